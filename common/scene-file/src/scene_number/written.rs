//! Where the values of a scene file stand in its text.

use std::collections::HashMap;
use std::ops::Range as Bytes;

use common::text;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value of a text in TOML that has numbers, or a text.
pub struct Written {
    /// The table, such as `[[sphere]] #2`.
    pub table: String,
    /// The keys behind the table, up to the one of the value.
    pub key: String,
    /// The bytes of each number; those of the text in quotation marks.
    pub parts: Vec<Bytes<usize>>,
}

/// The values of a text, by their positions; none if it is no TOML.
pub fn values(text: &str) -> HashMap<usize, Written> {
    let mut written = HashMap::new();
    if let Ok(table) = DeTable::parse(text) {
        add_table(table.get_ref(), "", "", &mut written);
    }
    written
}

/// Adds the values of a table of the text, by their positions.
fn add_table(table: &DeTable, path: &str, keys: &str, written: &mut HashMap<usize, Written>) {
    for (name, value) in table {
        let name = text::name(name.get_ref());
        let key = join(keys, &name);
        match value.get_ref() {
            DeValue::Table(inner) if path.is_empty() => {
                add_tables_of(&name, inner, written);
            }
            DeValue::Table(inner) => add_table(inner, path, &key, written),
            DeValue::Array(list) if is_of_tables(list.iter()) => {
                for (number, inner) in (1..).zip(list.iter()) {
                    let DeValue::Table(inner) = inner.get_ref() else {
                        continue;
                    };
                    if name == "transform" {
                        add_table(inner, path, &format!("{key} step {number}:"), written);
                    } else {
                        let path = join(path, &format!("[[{name}]] #{number}"));
                        add_table(inner, &path, "", written);
                    }
                }
            }
            _ => add_value(path, key, value, written),
        }
    }
}

/// Adds a table at the top of the file: one of its own, such as `[camera]`, or one of several with
/// names, such as `[material.red]`.
fn add_tables_of(name: &str, table: &DeTable, written: &mut HashMap<usize, Written>) {
    for (key, value) in table {
        let inner = text::name(key.get_ref());
        match value.get_ref() {
            DeValue::Table(of_name) => {
                add_table(of_name, &format!("[{name}.{inner}]"), "", written);
            }
            _ => add_value(&format!("[{name}]"), inner, value, written),
        }
    }
}

fn is_of_tables<'a, 'b: 'a>(mut list: impl Iterator<Item = &'a Spanned<DeValue<'b>>>) -> bool {
    list.any(|value| matches!(value.get_ref(), DeValue::Table(_)))
}

fn add_value(
    table: &str,
    key: String,
    value: &Spanned<DeValue>,
    written: &mut HashMap<usize, Written>,
) {
    let mut parts = Vec::new();
    add_parts(value, &mut parts);
    let found = Written {
        table: table.to_owned(),
        key,
        parts,
    };
    written.insert(value.span().start, found);
}

/// Adds the bytes of the numbers in a value, or those of the value itself.
fn add_parts(value: &Spanned<DeValue>, parts: &mut Vec<Bytes<usize>>) {
    match value.get_ref() {
        DeValue::Array(list) => list.iter().for_each(|value| add_parts(value, parts)),
        _ => parts.push(value.span()),
    }
}

fn join(before: &str, behind: &str) -> String {
    if before.is_empty() {
        return behind.to_owned();
    }
    format!("{before} {behind}")
}
