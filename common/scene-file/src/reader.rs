//! Reads the tables of a scene file, and refuses unknown ones.

mod known_key;

use std::sync::Arc;

use common::Unit;
use common::{Color, text};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::color_text;
use crate::mistake::BACKSLASH;
use crate::numbers::numbers;
use crate::scene_file::Meshes;
use crate::uses::{self, MAX_COPIES, MAX_LEVELS, too_deep};
use crate::{Data, Error, Form, Item, Key, Kind, Missing, Notation, kind};

/// Reads tables, and keeps the first mistake in them.
pub struct Reader<'a> {
    text: &'a str,
    stage: u8,
    meshes: Meshes<'a>,
    /// The shapes of repeats.
    pub definitions: Vec<Item>,
    /// The number of their copies.
    copies: f64,
    /// The first mistake. The parser sorts the keys by their names.
    pub mistake: Option<Error>,
    /// The number of mistakes.
    mistakes: usize,
}

impl<'a> Reader<'a> {
    /// A reader of this text for a stage.
    pub fn new(text: &'a str, stage: u8, meshes: Meshes<'a>) -> Self {
        Self {
            text,
            stage,
            meshes,
            definitions: Vec::new(),
            copies: 0.0,
            mistake: None,
            mistakes: 0,
        }
    }
}

impl Reader<'_> {
    /// Keeps a mistake if it stands before the others.
    fn keep(&mut self, error: Error) {
        self.mistakes += 1;
        if self.mistake.iter().all(|first| error.at < first.at) {
            self.mistake = Some(error);
        }
    }

    /// A table of a kind in a number of tables with shapes, with its values and tables.
    pub fn item(
        &mut self,
        kind: &'static Kind,
        name: &str,
        at: usize,
        table: &DeTable,
        level: usize,
    ) -> Item {
        let mistakes_before = self.mistakes;
        let mut item = Item::new(kind, name, at);
        if level > MAX_LEVELS {
            self.keep(too_deep(&item));
            return item;
        }
        for (name, value) in table {
            let key = match self.known(&item, name) {
                Ok(key) => key,
                Err(error) => {
                    self.keep(error);
                    continue;
                }
            };
            let Form::Tables(kind) = key.form else {
                match self.data(item.kind, key, value) {
                    Ok(data) => item.values.push((key.name, value.span().start, data)),
                    Err(error) => self.keep(error),
                }
                continue;
            };
            let kind = kind::find(kind);
            let is_outermost = item.kind.header.is_empty();
            let level = level + usize::from(item.kind.has_shapes() && !is_outermost);
            match self.tables(kind, key, value) {
                Ok(tables) => {
                    for (name, value) in tables {
                        let DeValue::Table(table) = value.get_ref() else {
                            self.keep(wrong(key, value));
                            continue;
                        };
                        let table = self.item(kind, name, value.span().start, table, level);
                        item.tables.push(table);
                    }
                }
                Err(error) => self.keep(error),
            }
        }
        // A value that is wrong is no value.
        if self.mistakes == mistakes_before {
            self.check_keys_together(&item);
        }
        item.tables.sort_by_key(|table| table.at);
        // A file may have many thousands of tables.
        item.tables.shrink_to_fit();
        item.values.shrink_to_fit();
        if let Some(is_smooth) = item.flag("smooth") {
            for (.., data) in &mut item.values {
                if let Data::Mesh(mesh) = data
                    && let Some(mesh) = Arc::get_mut(mesh)
                {
                    mesh.set_smooth(is_smooth);
                }
            }
        }
        if item.kind.name == "repeat" && self.mistakes == mistakes_before {
            self.repeat(&mut item);
        }
        item
    }

    /// Keeps the mistakes of keys of which one stands instead of another, or is needed with it.
    fn check_keys_together(&mut self, item: &Item) {
        for key in &item.kind.keys {
            let has = |name| item.find(name).is_some();
            match &key.missing {
                Missing::InsteadOf(others) if has(key.name) => {
                    let (kind, key) = (item.kind.name, key.name);
                    for other in others.iter().filter(|other| has(other)) {
                        let text = format!("{kind} takes {other} or {key}, not both");
                        self.keep(item.error(key, text));
                    }
                }
                Missing::NeededWith(other) if !has(key.name) && has(other) => {
                    self.keep(item.lacks(key.name));
                }
                _ => {}
            }
        }
    }

    /// Replaces the shapes of a repeat by uses of a definition of them.
    fn repeat(&mut self, repeat: &mut Item) {
        let count = repeat.number("count");
        if repeat.find("translate").or(repeat.find("rotate")).is_none() {
            self.keep(repeat.lacks("translate"));
        }
        match count {
            Err(error) => self.keep(error),
            Ok(count) if self.copies + count > MAX_COPIES => {
                let text = format!(
                    "the repeats of a file make at most {MAX_COPIES} copies; a repeat in another \
                     one needs fewer"
                );
                self.keep(repeat.error("count", text));
            }
            Ok(count) => {
                self.copies += count;
                let tables = std::mem::take(&mut repeat.tables);
                let is_step = |table: &Item| table.kind.name == "step";
                let (steps, shapes) = tables.into_iter().partition(is_step);
                let copies = uses::copies(repeat, self.definitions.len());
                self.definitions.push(Item {
                    tables: shapes,
                    ..Item::new(repeat.kind, "", repeat.at)
                });
                repeat.tables = steps;
                repeat.tables.extend(copies);
            }
        }
    }

    /// The tables of a kind that are the value of a key, with their names.
    fn tables<'a>(
        &self,
        kind: &Kind,
        key: &'a Key,
        value: &'a Spanned<DeValue<'a>>,
    ) -> Result<Vec<(&'a str, &'a Spanned<DeValue<'a>>)>, Error> {
        let are_in_list = matches!(kind.notation, Notation::Many | Notation::Inline);
        match value.get_ref() {
            DeValue::Array(list) if are_in_list => {
                Ok(list.iter().map(|table| (key.name, table)).collect())
            }
            DeValue::Table(tables) if kind.notation == Notation::Named => {
                let tables = tables.iter();
                Ok(tables
                    .map(|(name, table)| (&**name.get_ref(), table))
                    .collect())
            }
            DeValue::Table(_) if !are_in_list => Ok(vec![(key.name, value)]),
            DeValue::Table(_) if let Some(header) = self.header(value) => {
                let text = format!(
                    "{} may stand there several times, so its table has two pairs of brackets: \
                     [[{header}]]",
                    key.name
                );
                Err(error(value, text))
            }
            DeValue::Table(_) if self.text[value.span().start..].starts_with('{') => {
                let name = key.name;
                Err(error(
                    value,
                    format!("{name} is a list: {name} = [{{ ... }}]"),
                ))
            }
            _ => Err(wrong(key, value)),
        }
    }

    /// The name of a table that is written as `[name]`, such as `group.sphere`.
    fn header(&self, table: &Spanned<DeValue>) -> Option<&str> {
        let line = self.text.get(table.span().start..)?.lines().next()?;
        let (name, _) = line.strip_prefix('[')?.split_once(']')?;
        Some(name.trim())
    }

    /// The value of a key of a table of a kind.
    fn data(&self, kind: &Kind, key: &Key, value: &Spanned<DeValue>) -> Result<Data, Error> {
        match (&key.form, value.get_ref()) {
            (Form::Mesh, DeValue::String(file)) => {
                let mesh = (self.meshes)(file);
                let mut mesh = mesh.map_err(|reason| self.cannot_read(file, &reason, value))?;
                mesh.file = file.to_string();
                Ok(Data::Mesh(Arc::new(mesh)))
            }
            (Form::Text, DeValue::String(text)) => Ok(Data::Text(text.to_string())),
            (Form::Flag, DeValue::Boolean(flag)) => Ok(Data::Flag(*flag)),
            (Form::Color, DeValue::String(color)) => {
                let bytes = color_text::bytes(color).map_err(|reason| error(value, reason))?;
                let linear = Color::from_bytes(bytes).channels();
                Ok(Data::Bytes(bytes, linear))
            }
            (form, numbers) => {
                let numbers = self::numbers(numbers, form).ok_or_else(|| wrong(key, value))?;
                check_range(kind, key, &numbers).map_err(|text| error(value, text))?;
                Ok(Data::Numbers(numbers))
            }
        }
    }

    /// The error of a mesh that cannot be read. A backslash is a usual mistake in its name.
    fn cannot_read(&self, file: &str, reason: &str, value: &Spanned<DeValue>) -> Error {
        let written = self.text.get(value.span()).unwrap_or_default();
        let are_doubled = written.matches('\\').count() == 2 * file.matches('\\').count();
        let hint = if written.starts_with('"') && !are_doubled {
            format!("; {BACKSLASH}")
        } else if file.contains('\\') && cfg!(not(windows)) {
            "; between folders stands /".to_owned()
        } else {
            String::new()
        };
        let file = text::path(file.as_ref());
        error(value, format!("cannot read {file}: {reason}{hint}"))
    }
}

/// Whether all numbers are within the range of a key. The error is a clause.
fn check_range(kind: &Kind, key: &Key, numbers: &[f64]) -> Result<(), String> {
    let Some(beyond) = numbers.iter().find(|number| !key.range.contains(**number)) else {
        return Ok(());
    };
    let (kind, name) = (kind.name, key.name);
    let (beyond, range) = (text::number(*beyond), key.range.words());
    let degrees = if key.unit == Some(Unit::Degree) {
        ", in degrees"
    } else {
        ""
    };
    Err(if numbers.len() == 1 {
        format!("{kind}: {name} is {beyond}, but must be {range}{degrees}")
    } else {
        format!("{kind}: {name} has {beyond}, but its numbers must be {range}")
    })
}

/// An error at a value or a key.
fn error<T>(at: &Spanned<T>, text: String) -> Error {
    Error::new(at.span().start, text)
}

/// The error of a value in another form than its key has.
fn wrong(key: &Key, value: &Spanned<DeValue>) -> Error {
    let behind = match key.name {
        "group" => ", behind which its shapes stand, such as [[group.sphere]]",
        "define" => ", with a name, behind which its shapes stand, such as [[define.pawn.sphere]]",
        _ => "",
    };
    let is_number = |text: &str| text.trim().parse::<f64>().is_ok();
    let quoted = match value.get_ref() {
        DeValue::String(text) if is_number(text) => ", without quotation marks",
        _ => "",
    };
    let (name, needed) = (key.name, key.form.words());
    error(value, format!("{name} must be {needed}{quoted}{behind}"))
}
