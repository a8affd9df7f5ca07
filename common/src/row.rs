//! `Row`: a table of a list in TOML, such as of exercises, facts or cases. Its errors name the file, the row and the key,
//! and it refuses keys that nobody has asked for.

use std::cell::RefCell;
use std::iter;

use toml::de::DeTable;
pub use toml::de::DeValue;

/// Reads the table of a file by a function.
pub fn read<T>(
    file: &str,
    text: &str,
    read: impl FnOnce(&Row) -> Result<T, String>,
) -> Result<T, String> {
    let table = DeTable::parse(text).map_err(|error| format!("{file}: {error}"))?;
    read(&Row::new(file, table.get_ref()))
}

/// A value that a row has for a key.
pub trait Value: Sized {
    /// What it must be, in words.
    fn form() -> String;

    /// The value; none if it is of another form.
    fn read(value: &DeValue) -> Option<Self>;
}

impl Value for String {
    fn form() -> String {
        "a text".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        let text = value.as_str()?.trim();
        (!text.is_empty()).then(|| text.to_owned())
    }
}

impl Value for u32 {
    fn form() -> String {
        "a whole number from 0".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        let number = value.as_integer()?;
        Self::from_str_radix(number.as_str(), number.radix()).ok()
    }
}

impl Value for f64 {
    fn form() -> String {
        "a number".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        let text = match value {
            DeValue::Float(number) => number.as_str(),
            DeValue::Integer(number) => number.as_str(),
            _ => return None,
        };
        text.parse().ok()
    }
}

impl Value for bool {
    fn form() -> String {
        "true or false".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        value.as_bool()
    }
}

impl<T: Value> Value for Vec<T> {
    fn form() -> String {
        format!("a list, each {}", T::form())
    }

    fn read(value: &DeValue) -> Option<Self> {
        let list = value.as_array()?;
        let values: Option<Self> = list.iter().map(|value| T::read(value.get_ref())).collect();
        values.filter(|values| !values.is_empty())
    }
}

impl<T: Value, const N: usize> Value for [T; N] {
    fn form() -> String {
        format!("a list of {N}, each {}", T::form())
    }

    fn read(value: &DeValue) -> Option<Self> {
        Vec::read(value)?.try_into().ok()
    }
}

/// A table of a file.
#[derive(Debug)]
pub struct Row<'a> {
    /// The file and the row, with which errors begin.
    pub place: String,
    table: &'a DeTable<'a>,
    known: RefCell<Vec<&'static str>>,
}

impl<'a> Row<'a> {
    fn new(place: &str, table: &'a DeTable<'a>) -> Self {
        Self {
            place: place.to_owned(),
            table,
            known: RefCell::default(),
        }
    }

    /// An error about a key.
    #[must_use]
    pub fn error(&self, key: &str, problem: &str) -> String {
        format!("{}: `{key}` {problem}", self.place)
    }

    fn know(&self, key: &'static str) {
        let mut known = self.known.borrow_mut();
        if !known.contains(&key) {
            known.push(key);
        }
    }

    /// Whether the row has a key.
    pub fn has(&self, key: &'static str) -> bool {
        self.know(key);
        self.table.contains_key(key)
    }

    /// The value of a key; none if the row lacks it.
    pub fn find<T: Value>(&self, key: &'static str) -> Result<Option<T>, String> {
        self.know(key);
        let Some(value) = self.table.get(key) else {
            return Ok(None);
        };
        let read = T::read(value.get_ref());
        let wrong = || self.error(key, &format!("must be {}", T::form()));
        read.map(Some).ok_or_else(wrong)
    }

    /// The value of a key that each such row has.
    pub fn get<T: Value>(&self, key: &'static str) -> Result<T, String> {
        let missing = || self.error(key, &format!("is missing; it must be {}", T::form()));
        self.find(key)?.ok_or_else(missing)
    }

    /// The table of a key; none if the row lacks it.
    pub fn table(&self, key: &'static str) -> Result<Option<Row<'a>>, String> {
        self.know(key);
        let Some(value) = self.table.get(key) else {
            return Ok(None);
        };
        let table = value.get_ref().as_table();
        let table = table.ok_or_else(|| self.error(key, "must be a table"))?;
        Ok(Some(Row::new(&format!("{}, {key}", self.place), table)))
    }

    /// The rows `[[key]]`.
    pub fn rows(&self, key: &'static str) -> Result<Vec<Row<'a>>, String> {
        self.know(key);
        let list = self.table.get(key).map(|rows| rows.get_ref().as_array());
        let list = list.unwrap_or(None).into_iter().flatten();
        let mut rows = Vec::new();
        for (number, row) in iter::zip(1.., list) {
            let table = row.get_ref().as_table();
            let table = table.ok_or_else(|| self.error(key, "must be a table"))?;
            let name = ["name", "scene", "id"]
                .iter()
                .find_map(|key| table.get(*key)?.get_ref().as_str());
            let name = name.unwrap_or("without a name");
            let place = format!("{}, {key} {number} ({name})", self.place);
            rows.push(Row::new(&place, table));
        }
        if rows.is_empty() {
            return Err(self.error(key, &format!("is missing; the file has rows [[{key}]]")));
        }
        Ok(rows)
    }

    /// Refuses keys that mean nothing.
    pub fn end(&self) -> Result<(), String> {
        let known = self.known.borrow();
        let mut keys = self.table.keys().map(|key| &**key.get_ref());
        let Some(unknown) = keys.find(|key| !known.contains(key)) else {
            return Ok(());
        };
        let problem = match crate::text::nearest(&known, unknown) {
            Some(nearest) => format!("is no key here; the nearest is `{nearest}`"),
            None => format!("is no key here; its keys are {}", known.join(", ")),
        };
        Err(self.error(unknown, &problem))
    }
}
