//! `Kind`: the tables of a scene file and their keys, as `keys.md` lists them, which is a part
//! of the book, too.

use std::sync::LazyLock;

use crate::{Form, Key, Missing, Range};

/// A kind of tables.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// The header of its tables, such as `[camera]`, `[material.NAME]` or `[[sphere]]`; empty for
    /// the scene file itself.
    pub header: &'static str,
    /// How its tables are written.
    pub notation: Notation,
    /// Its keys.
    pub keys: Vec<Key>,
}

/// How the tables of a kind are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// `[camera]`, at most once.
    Single,
    /// `[material.NAME]`, each with a name of its own.
    Named,
    /// `[[sphere]]`, any number of times.
    Many,
    /// `{ step }`, in a list that is the value of a key.
    Inline,
}

impl Kind {
    /// A kind without keys.
    fn new(header: &'static str) -> Self {
        Self {
            name: name(header),
            header,
            notation: match header {
                header if header.ends_with(".NAME]") => Notation::Named,
                header if header.starts_with("[[") => Notation::Many,
                header if header.starts_with('{') => Notation::Inline,
                _ => Notation::Single,
            },
            keys: Vec::new(),
        }
    }

    /// The key of this name.
    #[must_use]
    pub fn key(&self, name: &str) -> Option<&Key> {
        self.keys.iter().find(|key| key.name == name)
    }

    /// Whether shapes stand in its tables: in the scene file itself, in groups, definitions and
    /// repeats.
    pub(crate) fn has_shapes(&self) -> bool {
        self.header.is_empty() || WITH_SHAPES.contains(&self.name)
    }

    /// Whether its tables are lights.
    #[must_use]
    pub fn is_light(&self) -> bool {
        self.name.ends_with("_light")
    }

    /// Whether its tables stand where shapes do.
    fn is_shape(&self) -> bool {
        self.notation == Notation::Many && !self.is_light()
    }

    /// The key of the tables around it: it is known from the stage of its first key on.
    fn as_key(&self) -> Key {
        Key {
            name: self.name,
            form: Form::Tables(self.name),
            unit: None,
            range: Range::ALL,
            missing: Missing::Optional,
            stage: self.keys.first().map_or(0, |key| key.stage),
            about: "",
        }
    }
}

/// The tables in which shapes stand, besides the scene file itself.
const WITH_SHAPES: [&str; 3] = ["group", "define", "repeat"];

/// The name of the tables with this header.
pub(crate) fn name(header: &str) -> &str {
    let name = header.trim_matches(['[', ']', '{', '}', ' ']);
    name.trim_end_matches(".NAME")
}

/// The kind of this name, which the list has: a test says so of each name in it.
pub(crate) fn find(name: &str) -> &'static Kind {
    let found = TABLES.iter().find(|kind| kind.name == name);
    found.unwrap_or(&FILE)
}

/// The tables and keys of the list; none for a row that cannot be read.
fn rows() -> impl Iterator<Item = Option<(&'static str, Key)>> {
    include_str!("keys.md").lines().skip(2).map(Key::parse)
}

/// The kinds of tables, in the order of the list.
pub static TABLES: LazyLock<Vec<Kind>> = LazyLock::new(|| {
    let mut kinds: Vec<Kind> = Vec::new();
    for (header, key) in rows().flatten() {
        if header == "every shape" {
            for kind in &mut kinds {
                let has_surface = kind.is_shape() || kind.name == "define";
                if has_surface && kind.key(key.name).is_none() {
                    kind.keys.push(key.clone());
                }
            }
            continue;
        }
        if kinds.iter().all(|kind| kind.header != header) {
            kinds.push(Kind::new(header));
        }
        let with_header = kinds.iter_mut().filter(|kind| kind.header == header);
        with_header.for_each(|kind| kind.keys.push(key.clone()));
    }
    let shapes = kinds.iter().filter(|kind| kind.is_shape());
    let shapes: Vec<_> = shapes.map(Kind::as_key).collect();
    for kind in &mut kinds {
        if WITH_SHAPES.contains(&kind.name) {
            kind.keys.extend_from_slice(&shapes);
        }
    }
    kinds
});

/// The scene file itself, whose keys are the kinds of tables. Steps stand in a transform only.
pub static FILE: LazyLock<Kind> = LazyLock::new(|| {
    let tables = TABLES
        .iter()
        .filter(|kind| kind.notation != Notation::Inline);
    Kind {
        name: "a scene file",
        keys: tables.map(Kind::as_key).collect(),
        ..Kind::new("")
    }
});

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_row_of_the_list_is_read() {
        for (number, row) in (3..).zip(rows()) {
            assert!(row.is_some(), "keys.md:{number}");
        }
        for misspelt in ["needed or `b`", "needed,or `b`", "Needed", "instead `b`"] {
            let row = format!("| `[a]` | `a` | number |  |  | {misspelt} | 4 | a number |");
            let read = Key::parse(row.leak());
            assert!(
                read.is_none_or(|(_, key)| key.missing != Missing::Optional),
                "{misspelt}"
            );
        }
    }

    /// A row may name a table or another key of its own.
    #[test]
    fn every_name_in_the_list_is_known_and_stands_once() {
        for name in ["picture", "camera", "world", "step", "use"] {
            assert_eq!(find(name).name, name);
        }
        let mut names = BTreeSet::new();
        for kind in TABLES.iter() {
            assert!(names.insert(kind.name.to_owned()), "{}", kind.name);
            for key in &kind.keys {
                let name = format!("{} {}", kind.name, key.name);
                assert!(names.insert(name.clone()), "{name}");
                let has_numbers = matches!(key.form, Form::Numbers { .. } | Form::Color);
                assert_eq!(key.unit.is_some(), has_numbers, "{name}");
                if let Form::Tables(table) = key.form {
                    assert_eq!(find(table).name, table, "{name}");
                }
                let missing = |other: &str| kind.key(other).map(|other| &other.missing);
                let is_right = match &key.missing {
                    Missing::Needed | Missing::Optional => true,
                    Missing::NeededWith(other) => missing(other).is_some(),
                    // A key that is needed anyway, or for another one, cannot be replaced.
                    Missing::InsteadOf(others) => others.iter().all(|other| match missing(other) {
                        Some(Missing::NeededOr(other)) => *other == key.name,
                        Some(Missing::Optional | Missing::NeededWith(_)) => true,
                        _ => false,
                    }),
                    Missing::NeededOr(other) => match missing(other) {
                        Some(Missing::NeededOr(other)) => *other == key.name,
                        Some(Missing::InsteadOf(others)) => others[..] == [key.name],
                        _ => false,
                    },
                };
                assert!(is_right, "{name}: {:?}", key.missing);
            }
        }
    }
}
