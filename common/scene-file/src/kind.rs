//! `Kind`: the tables of a scene file and their keys, as `keys.md` lists them, which is a part
//! of the book, too.

use std::sync::{LazyLock, Mutex, PoisonError};

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
    /// The form of its value: `3 numbers`, `text`, or that of its tables.
    pub form: &'static str,
    /// The first stage that knows it.
    pub stage: u8,
    /// Its meaning, unit and range.
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

    /// The form of its value, in words.
    #[must_use]
    pub fn needed(&self) -> String {
        match self.form {
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

/// The table of a shape that a stage knows and `keys.md` does not list.
#[derive(Clone, Copy, Debug)]
pub struct OwnTable {
    /// Its name, without brackets.
    pub name: &'static str,
    /// Its keys, besides those of every shape.
    pub keys: &'static [Key],
}

/// A kind of tables, and the key in the scene file and in groups that has such tables.
#[derive(Debug)]
pub(crate) struct OwnKind {
    pub kind: Kind,
    pub key: Key,
}

impl OwnTable {
    /// The kind of this table. It is made once, and kept as those of `keys.md` are.
    pub(crate) fn kind(&self) -> &'static OwnKind {
        static KNOWN: Mutex<Vec<&OwnKind>> = Mutex::new(Vec::new());
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(kind) = known.iter().find(|own| own.kind.name == self.name) {
            return kind;
        }
        let form = &*format!("[[{}]]", self.name).leak();
        let shapes = KINDS.iter().filter(|kind| are_shapes(kind.form));
        let of_every_shape = shapes.flat_map(|kind| &kind.keys);
        let of_every_shape = of_every_shape.filter(|key| ["color", "material"].contains(&key.name));
        let own = Box::leak(Box::new(OwnKind {
            kind: Kind {
                name: self.name,
                form,
                keys: self
                    .keys
                    .iter()
                    .chain(of_every_shape.take(2))
                    .copied()
                    .collect(),
            },
            key: Key {
                name: self.name,
                form,
                stage: 0,
                about: "",
            },
        }));
        known.push(own);
        own
    }
}

/// Whether tables of this form are shapes.
fn are_shapes(form: &str) -> bool {
    form.starts_with("[[") && !form.ends_with("_light]]")
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
            stage: cell().parse().unwrap_or(0),
            about: cell(),
        };
        if table == "every shape" {
            let shapes = kinds.iter_mut().filter(|kind| are_shapes(kind.form));
            shapes.for_each(|kind| kind.keys.push(key));
        } else if let Some(known) = kinds.iter_mut().find(|kind| kind.form == table) {
            known.keys.push(key);
        } else {
            let name = table.trim_matches(['[', ']', '{', '}', ' ']);
            let name = name.trim_end_matches(".NAME");
            let form = table;
            // Steps stand in a group only.
            if name != "step" {
                let about = "";
                let key = Key {
                    name,
                    form,
                    about,
                    ..key
                };
                kinds[0].keys.push(key);
            }
            let keys = vec![key];
            kinds.push(Kind { name, form, keys });
        }
    }
    let mut shapes = kinds[0].keys.clone();
    shapes.retain(|key| are_shapes(key.form));
    let groups = kinds.iter_mut().filter(|kind| kind.name == "group");
    groups.for_each(|group| group.keys.extend(&shapes));
    kinds
});
