//! `Kind`: the tables of a scene file and their keys, as `keys.md` lists them, which is a part
//! of the book, too.

use std::sync::LazyLock;

use common::sensitivity::Unit;

use crate::Range;

/// A kind of tables.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// The form of its tables, such as `[camera]`, `[material.NAME]` or `[[sphere]]`.
    pub form: &'static str,
    /// Its keys.
    pub keys: Vec<Key>,
}

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// The form of its value: `3 numbers`, `color`, `text`, or that of its tables.
    pub form: &'static str,
    /// The unit of its numbers; none if it has no numbers.
    pub unit: Option<Unit>,
    /// The range of its numbers, as [`Range::parse`] reads it; empty if it is no interval.
    pub range: &'static str,
    /// What a missing key means: `needed`, `needed, or` another key, `needed with` another key,
    /// `instead of` another key, or the value that it then has.
    pub missing: &'static str,
    /// The first stage that knows it.
    pub stage: u8,
    /// Its meaning and unit.
    pub about: &'static str,
}

impl Kind {
    /// The key of this name.
    #[must_use]
    pub fn key(&self, name: &str) -> Option<&Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

impl Key {
    /// The kind of its tables; none if its value is no table.
    #[must_use]
    pub fn tables(&self) -> Option<&'static Kind> {
        KINDS.iter().find(|kind| kind.form == self.form)
    }

    /// The range of its numbers.
    #[must_use]
    pub fn limits(&self) -> Range {
        Range::parse(self.range)
    }

    /// The other key in what a missing key means, behind these words.
    #[must_use]
    pub fn other_key(&self, words: &str) -> Option<&'static str> {
        let other = self.missing.strip_prefix(words)?;
        Some(other.trim_matches([' ', '`']))
    }

    /// The form of its value, in words.
    #[must_use]
    pub fn needed(&self) -> String {
        match self.form {
            "color" => "a color, such as [1, 0.5, 0], \"#ff8000\" or \"orange\"".to_owned(),
            "number" => "a finite number".to_owned(),
            "whole number" => "a whole number from 1".to_owned(),
            "text" => "a text in quotation marks".to_owned(),
            "true or false" => self.form.to_owned(),
            "{ step }" => "a list of steps, such as [{ scale = [1, 2, 1] }]".to_owned(),
            table if table.starts_with('[') => format!("a table: {table}"),
            form if form.contains("whole") => format!("a list of {form} from 1"),
            form => format!("a list of {form}, all of them finite"),
        }
    }
}

/// Whether tables of this form are shapes, or hold some.
fn are_shapes(form: &str) -> bool {
    form.starts_with("[[") && !form.ends_with("_light]]") || form == "[define.NAME]"
}

/// The tables in which shapes stand, besides the scene file itself.
const WITH_SHAPES: [&str; 3] = ["group", "define", "repeat"];

/// Whether shapes stand in tables of this kind: in the scene file itself, in groups, definitions
/// and repeats.
pub(crate) fn has_shapes(kind: &Kind) -> bool {
    kind.form.is_empty() || WITH_SHAPES.contains(&kind.name)
}

/// The unit of a word of `keys.md`. A direction has its length where its numbers are known.
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

/// The scene file itself, whose keys are the other kinds, and these in the order of the list.
pub static KINDS: LazyLock<Vec<Kind>> = LazyLock::new(|| {
    let mut kinds = vec![Kind {
        name: "a scene file",
        form: "",
        keys: Vec::new(),
    }];
    for row in include_str!("keys.md").lines().skip(2) {
        let mut cells = row.split('|').skip(1);
        let mut cell = || cells.next().unwrap_or_default().trim();
        let [table, name, form] = [cell(), cell(), cell()].map(|cell| cell.trim_matches('`'));
        let key = Key {
            name,
            form,
            unit: unit(cell()),
            range: cell(),
            missing: cell(),
            stage: cell().parse().unwrap_or(0),
            about: cell(),
        };
        if table == "every shape" {
            let shapes = kinds.iter_mut().filter(|kind| are_shapes(kind.form));
            let without = shapes.filter(|kind| kind.key(name).is_none());
            without.for_each(|kind| kind.keys.push(key));
        } else if let Some(known) = kinds.iter_mut().find(|kind| kind.form == table) {
            known.keys.push(key);
        } else {
            let name = table.trim_matches(['[', ']', '{', '}', ' ']);
            let name = name.trim_end_matches(".NAME");
            let form = table;
            // Steps stand in a transform only.
            if name != "step" {
                let key = Key {
                    name,
                    form,
                    unit: None,
                    range: "",
                    missing: "",
                    about: "",
                    ..key
                };
                kinds[0].keys.push(key);
            }
            let keys = vec![key];
            kinds.push(Kind { name, form, keys });
        }
    }
    let mut shapes = kinds[0].keys.clone();
    shapes.retain(|key| key.form.starts_with("[[") && are_shapes(key.form));
    let groups = kinds
        .iter_mut()
        .filter(|kind| WITH_SHAPES.contains(&kind.name));
    groups.for_each(|group| group.keys.extend(&shapes));
    kinds
});
