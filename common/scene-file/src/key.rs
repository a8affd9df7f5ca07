//! `Key`: a row of `keys.md`.

use common::Unit;

use crate::{Form, Range};

/// A key of a table.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// The form of its value.
    pub form: Form,
    /// The unit of its numbers; none if it has no numbers.
    pub unit: Option<Unit>,
    /// The range of its numbers.
    pub range: Range,
    /// What a missing key means.
    pub missing: Missing,
    /// The first stage that knows it.
    pub stage: u8,
    /// Its meaning and unit.
    pub about: &'static str,
}

/// What a missing key means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// A mistake.
    Needed,
    /// A mistake, if this other key is missing, too.
    NeededOr(&'static str),
    /// A mistake, if this other key is there.
    NeededWith(&'static str),
    /// No mistake: the key stands instead of these others, and beside none of them.
    InsteadOf(Vec<&'static str>),
    /// No mistake: there is a value for it.
    Optional,
}

impl Key {
    /// The table and the key of a row; none if a cell has no meaning.
    pub(crate) fn parse(row: &'static str) -> Option<(&'static str, Self)> {
        let mut cells = row.split('|').skip(1).map(str::trim);
        let mut cell = || cells.next();
        let [table, name, form] = [cell()?, cell()?, cell()?].map(|cell| cell.trim_matches('`'));
        let key = Self {
            name,
            form: Form::parse(form)?,
            unit: match cell()? {
                "" => None,
                word => Some(unit(word)?),
            },
            range: Range::parse(cell()?)?,
            missing: Missing::parse(cell()?)?,
            stage: cell()?.parse().ok()?,
            about: cell()?,
        };
        Some((table, key))
    }
}

/// The unit of a word. A direction has its length where its numbers are known.
fn unit(word: &str) -> Option<Unit> {
    match word {
        "length" => Some(Unit::Length),
        "degree" => Some(Unit::Degree),
        "direction" => Some(Unit::Direction(1.0)),
        "factor" => Some(Unit::Factor),
        "scale" => Some(Unit::Scale),
        "channel" => Some(Unit::Channel),
        "whole" => Some(Unit::Whole),
        _ => None,
    }
}

impl Missing {
    /// The meaning of a cell, such as "needed, or `look_at`"; any other text is the value of a missing key.
    fn parse(text: &'static str) -> Option<Self> {
        let other = |words| Some(text.strip_prefix(words)?.trim_matches('`'));
        if text == "needed" {
            Some(Self::Needed)
        } else if let Some(other) = other("needed, or ") {
            Some(Self::NeededOr(other))
        } else if let Some(other) = other("needed with ") {
            Some(Self::NeededWith(other))
        } else if let Some(other) = other("instead of ") {
            let others = other.split(", ").map(|other| other.trim_matches('`'));
            Some(Self::InsteadOf(others.collect()))
        } else {
            let text = text.to_lowercase();
            let is_misspelt = text.contains("need") || text.contains("instead");
            (!is_misspelt).then_some(Self::Optional)
        }
    }
}
