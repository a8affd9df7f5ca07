//! `Item`: a table of a scene file with its values.

use std::sync::Arc;

use common::Unit;
use common::{ArgumentError, Color, Transfer, text};

use crate::error::nearest;
use crate::{Error, Kind, Mesh, Missing};

/// A value in the form that its key has.
#[derive(Clone, Debug)]
pub enum Data {
    /// Finite numbers, row after row.
    Numbers(Vec<f64>),
    /// A colour in bytes, and what it is in linear light.
    Bytes([u8; 3], [f64; 3]),
    /// A text.
    Text(String),
    /// True or false.
    Flag(bool),
    /// The triangles of a file.
    Mesh(Arc<Mesh>),
}

/// A table of a scene file.
#[derive(Clone, Debug)]
pub struct Item {
    /// Its kind.
    pub kind: &'static Kind,
    /// The last part of its name.
    pub name: String,
    /// Where it begins: the bytes before it.
    pub at: usize,
    /// Its values, with the names of their keys and their positions.
    pub values: Vec<(&'static str, usize, Data)>,
    /// The tables in it, in the order of the file: steps, and shapes of a group.
    pub tables: Vec<Self>,
    /// The index of the definition whose shapes are used here.
    pub used: Option<usize>,
}

impl Item {
    /// A table of this kind, name and position, without values.
    pub(crate) fn new(kind: &'static Kind, name: &str, at: usize) -> Self {
        Self {
            kind,
            name: name.to_owned(),
            at,
            values: Vec::new(),
            tables: Vec::new(),
            used: None,
        }
    }

    /// The value of a key, if it is there.
    #[must_use]
    pub fn find(&self, key: &str) -> Option<&Data> {
        let mut values = self.values.iter();
        values.find_map(|(name, _, data)| (*name == key).then_some(data))
    }

    /// The numbers of a key in rows of `M`, if it is there.
    #[must_use]
    pub fn find_rows<const M: usize, const N: usize>(&self, key: &str) -> Option<[[f64; M]; N]> {
        match self.find(key)? {
            Data::Numbers(numbers) => numbers.as_chunks().0.try_into().ok(),
            Data::Bytes(_, numbers) => numbers.as_chunks().0.try_into().ok(),
            _ => None,
        }
    }

    /// The numbers of a key in rows of `M`. It is an error if it is missing.
    pub fn rows<const M: usize, const N: usize>(&self, key: &str) -> Result<[[f64; M]; N], Error> {
        self.find_rows(key).ok_or_else(|| self.lacks(key))
    }

    /// The three numbers of a key as a point, vector or colour, if it is there.
    pub fn find_vector<T>(&self, key: &str, new: fn(f64, f64, f64) -> T) -> Option<T> {
        self.find_rows(key).map(|[[x, y, z]]| new(x, y, z))
    }

    /// The three numbers of a key as a point, vector or colour. It is an error if it is missing.
    pub fn vector<T>(&self, key: &str, new: fn(f64, f64, f64) -> T) -> Result<T, Error> {
        self.find_vector(key, new).ok_or_else(|| self.lacks(key))
    }

    /// The colour of a key, black if it is missing.
    #[must_use]
    pub fn color(&self, key: &str) -> Color {
        self.find_vector(key, Color::new).unwrap_or(Color::BLACK)
    }

    /// The number of a key. It is an error if it is missing.
    pub fn number(&self, key: &str) -> Result<f64, Error> {
        self.rows(key).map(|[[number]]| number)
    }

    /// The angle of a key in radians. It is an error if it is missing.
    pub fn angle(&self, key: &str) -> Result<f64, Error> {
        self.number(key).map(f64::to_radians)
    }

    /// The flag of a key, if it is there.
    #[must_use]
    pub fn flag(&self, key: &str) -> Option<bool> {
        match self.find(key)? {
            Data::Flag(flag) => Some(*flag),
            _ => None,
        }
    }

    /// Whether its shapes have the same color or material as those of another table.
    #[must_use]
    pub fn has_surface_of(&self, other: &Self) -> bool {
        let material = |item: &Self| match item.find("material") {
            Some(Data::Text(name)) => Some(name.clone()),
            _ => None,
        };
        let color = |item: &Self| item.find_rows::<3, 1>("color");
        std::ptr::eq(self, other)
            || material(self) == material(other) && color(self) == color(other)
    }

    /// The steps of its transform.
    pub fn steps(&self) -> impl Iterator<Item = &Self> {
        self.tables.iter().filter(|table| table.kind.name == "step")
    }

    /// The shapes in it.
    pub fn shapes(&self) -> impl Iterator<Item = &Self> {
        self.tables.iter().filter(|table| table.kind.name != "step")
    }

    /// Takes the colours in bytes as those of pictures with this transfer.
    pub(crate) fn set_transfer(&mut self, transfer: Transfer) {
        for (.., data) in &mut self.values {
            if let Data::Bytes(bytes, linear) = data {
                let channels = Color::from_bytes(*bytes);
                *linear = channels.map(|channel| transfer.decode(channel)).channels();
            }
        }
        for table in &mut self.tables {
            table.set_transfer(transfer);
        }
    }

    /// Adds the notes about its meshes that are not there yet.
    pub(crate) fn add_notes(&self, notes: &mut Vec<String>) {
        for (.., data) in &self.values {
            let Data::Mesh(mesh) = data else { continue };
            for note in mesh.notes() {
                let note = format!("{}: {note}", mesh.file);
                if !notes.contains(&note) {
                    notes.push(note);
                }
            }
        }
        for table in &self.tables {
            table.add_notes(notes);
        }
    }

    /// The error of a missing key.
    #[must_use]
    pub fn lacks(&self, key: &str) -> Error {
        let known = self.kind.key(key);
        let form = known.map_or_else(String::new, |known| known.form.words());
        let other = known.and_then(|known| match &known.missing {
            Missing::InsteadOf(others) => others.first().copied(),
            Missing::NeededOr(other) => Some(*other),
            _ => None,
        });
        let kind = self.kind.name;
        let text = match other {
            Some("color") => format!("{kind} lacks a color or a material"),
            Some(other) => format!("{kind} lacks {key}, {form}, or {other}"),
            None => format!("{kind} lacks {key}, {form}"),
        };
        Error {
            is_missing: true,
            ..self.error(key, text)
        }
    }

    /// The item that a key names, or an error with the nearest name.
    pub fn named<'a>(&self, key: &str, items: &'a [Self]) -> Result<&'a Self, Error> {
        let Some(Data::Text(name)) = self.find(key) else {
            return Err(self.lacks(key));
        };
        let found = items.iter().find(|item| item.name == *name);
        found.ok_or_else(|| {
            let names: Vec<_> = items.iter().map(|item| item.name.as_str()).collect();
            let nearest = nearest(&names, name);
            let name = text::name(name);
            let text = format!("there is no {key} \"{name}\"{nearest}");
            Error {
                is_missing: true,
                ..self.error(key, text)
            }
        })
    }

    /// The result of a constructor. Its error gets the position of the argument.
    pub fn check<T>(&self, made: Result<T, ArgumentError>) -> Result<T, Error> {
        made.map_err(|error| {
            let words = error.name.replace("centre", "center");
            let words = words.replace("half angle", "half_angle");
            let words = words.replace("triangle", "corners");
            let key = match words.split(' ').next().unwrap_or_default() {
                "gaze" if self.find("gaze").is_none() => "look_at",
                key => key,
            };
            // Constructors take radians.
            let known = self.kind.key(key);
            let text = match known.filter(|key| key.unit == Some(Unit::Degree)) {
                Some(angle) => format!("{}: {key} must be {}", self.kind.name, angle.about),
                None if key == "up" && self.find(key).is_none() => {
                    format!("camera without up: {error}; add up, such as up = [0, 0, -1]")
                }
                None => format!("{}: {error}", self.kind.name),
            };
            self.error(key, text)
        })
    }

    /// An error at a key, or at the table if the key is missing.
    pub fn error(&self, key: &str, text: impl Into<String>) -> Error {
        let value = self.values.iter().find(|(name, ..)| *name == key);
        let at = value.map_or(self.at, |(_, at, _)| *at);
        Error::new(at, text)
    }
}
