//! `Kind`: the tables of a scene file and their keys, as `keys.md` lists them, which is a part
//! of the book, too.

use std::sync::LazyLock;

/// A kind of tables.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// How its tables are written.
    pub role: Role,
    /// An example of that, such as `[[sphere]]`.
    pub written: &'static str,
    /// Its keys.
    pub keys: Vec<Key>,
}

/// How the tables of a kind are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Once, as `[camera]`.
    Single,
    /// Once for each name, as `[material.gold]`.
    Named,
    /// As often as needed, as `[[point_light]]`.
    Light,
    /// As often as needed, also in a group, as `[[sphere]]` and `[[group.sphere]]`.
    Shape,
    /// In a list of steps, as `{ scale = [1, 2, 1] }`.
    Step,
}

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// The form of its value: `3 numbers`, or `text`.
    pub form: &'static str,
    /// The first stage that knows it.
    pub stage: u8,
    /// Its meaning, unit and range.
    pub about: &'static str,
}

impl Kind {
    /// The first stage that knows it.
    #[must_use]
    pub fn stage(&self) -> u8 {
        self.keys.iter().map(|key| key.stage).min().unwrap_or(0)
    }

    /// The key of this name.
    #[must_use]
    pub fn key(&self, name: &str) -> Option<&Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

impl Key {
    /// The form of its value, in words.
    #[must_use]
    pub fn needed(&self) -> String {
        match self.form {
            "number" => "a finite number".to_owned(),
            "text" => "a text in quotation marks".to_owned(),
            "steps" => "a list of steps, such as [{ scale = [1, 2, 1] }]".to_owned(),
            "true or false" => self.form.to_owned(),
            form => format!("a list of {form}, all of them finite"),
        }
    }
}

/// The kinds in the order of the list.
pub static KINDS: LazyLock<Vec<Kind>> = LazyLock::new(|| {
    let mut kinds: Vec<Kind> = Vec::new();
    for row in include_str!("keys.md").lines().skip(2) {
        let mut cells = row.split('|').skip(1).map(str::trim);
        let mut cell = || cells.next().unwrap_or_default();
        let (table, name, form) = (cell().trim_matches('`'), cell().trim_matches('`'), cell());
        let stage = cell().parse().unwrap_or(0);
        let key = Key {
            name,
            form,
            stage,
            about: cell(),
        };
        if table == "every shape" {
            let shapes = kinds.iter_mut().filter(|kind| kind.role == Role::Shape);
            shapes.for_each(|kind| kind.keys.push(key));
            continue;
        }
        let name = table.trim_matches(['[', ']', '{', '}', ' ']);
        let (name, role) = match name.strip_suffix(".NAME") {
            Some(name) => (name, Role::Named),
            None if table.starts_with('{') => (name, Role::Step),
            None if name.ends_with("_light") => (name, Role::Light),
            None if table.starts_with("[[") => (name, Role::Shape),
            None => (name, Role::Single),
        };
        match kinds.last_mut() {
            Some(last) if last.name == name => last.keys.push(key),
            _ => kinds.push(Kind {
                name,
                role,
                written: table,
                keys: vec![key],
            }),
        }
    }
    kinds
});
