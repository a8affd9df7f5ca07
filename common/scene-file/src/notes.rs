//! `notes`: remarks on a scene file that is right, but may not show what was meant.

use std::collections::BTreeSet;

use common::text;

use crate::{Data, Error, Item, SceneFile};

/// The keys of colours that show their brightest at 1.
const SHOWN: [&str; 4] = ["color", "background", "diffuse", "specular"];

/// A light of at least this, in whole numbers up to 255, was probably meant in bytes.
const MIN_OF_BYTES: f64 = 32.0;

impl SceneFile {
    /// The notes about the meshes and the remarks on this file, which has this name and this text.
    #[must_use]
    pub fn notes(&self, name: &str, text: &str) -> Vec<String> {
        let mut notes = self.notes.clone();
        let mut unseen = Vec::new();
        if self.shapes.iter().all(|shape| !has_shape(shape)) {
            notes.push(format!(
                "{name} has no shape, so that its picture has the color of the background only"
            ));
        } else {
            self.add_unseen(&mut unseen);
        }
        let mut bright = Vec::new();
        let mut tiny = Vec::new();
        let tables = [
            &self.materials,
            &self.lights,
            &self.shapes,
            &self.definitions,
        ];
        for item in tables.into_iter().flatten().chain([&self.world]) {
            add_bright_colors(item, &mut bright);
        }
        for item in self.lights.iter().chain([&self.camera]) {
            add_tiny_angles(item, &mut tiny);
        }
        for mut remarks in [bright, tiny, unseen] {
            remarks.sort_by_key(|error| error.at);
            if let Some(first) = remarks.first() {
                let more = match remarks.len() {
                    1 => String::new(),
                    count => format!(", and the same holds for {} more", count - 1),
                };
                notes.push(format!("{name}:{}{more}", first.within(text)));
            }
        }
        notes
    }

    /// Adds the tables that nobody sees: definitions that are not used, and those without shapes.
    fn add_unseen(&self, unseen: &mut Vec<Error>) {
        let mut tables: Vec<_> = self.shapes.iter().chain(&self.definitions).collect();
        let mut next = 0;
        while let Some(table) = tables.get(next) {
            tables.extend(&table.tables);
            next += 1;
        }
        let used: BTreeSet<_> = tables.iter().filter_map(|table| table.used).collect();
        for (index, definition) in self.definitions.iter().enumerate() {
            // Those of repeats have no names.
            if !definition.name.is_empty() && !used.contains(&index) {
                let name = text::name(&definition.name);
                let text =
                    format!("no [[use]] names the definition \"{name}\", so that nobody sees it");
                unseen.push(Error::new(definition.at, text));
            }
        }
        for table in tables {
            if table.kind.has_shapes() && table.shapes().next().is_none() {
                let text = format!("{} has no shape", table.kind.header);
                unseen.push(Error::new(table.at, text));
            }
        }
    }
}

/// Whether an item is a shape, or a group that has one.
fn has_shape(item: &Item) -> bool {
    match item.kind.name {
        "group" => item.shapes().any(has_shape),
        _ => true,
    }
}

/// Adds the angles of an item that are below a degree, as those in radians are.
fn add_tiny_angles(item: &Item, tiny: &mut Vec<Error>) {
    for (key, at, data) in &item.values {
        if let Data::Numbers(numbers) = data
            && ["angle", "half_angle"].contains(key)
            && numbers[0] < 1.0
        {
            let (given, degrees) = (text::number(numbers[0]), numbers[0].to_degrees());
            let text = format!(
                "{key} {given} is below one degree; if radians were meant, write {degrees:.1}"
            );
            tiny.push(Error::new(*at, text));
        }
    }
}

/// Adds the colours of an item, and of those in it, that have channels above those of the brightest.
fn add_bright_colors(item: &Item, bright: &mut Vec<Error>) {
    let is_light = item.kind.is_light();
    for (key, at, data) in &item.values {
        let Data::Numbers(channels) = data else {
            continue;
        };
        let largest = channels.iter().copied().fold(0.0, f64::max);
        let are_bytes = channels.iter().all(|c| c.fract() == 0.0 && *c <= 255.0);
        // Light may be brighter than 1, as it may fall at a slant, or on dark surfaces.
        let is_bright = if is_light && *key == "color" || *key == "ambient" {
            are_bytes && largest >= MIN_OF_BYTES
        } else {
            SHOWN.contains(key) && largest > 1.0
        };
        if is_bright {
            let given = text::numbers(channels);
            let text = format!(
                "{key} [{given}] is brighter than 1; if 255 was meant as the brightest, divide it \
                 by 255"
            );
            bright.push(Error::new(*at, text));
        }
    }
    for table in &item.tables {
        add_bright_colors(table, bright);
    }
}
