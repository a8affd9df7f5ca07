//! The numbers of a scene file with their places in the text. A file with another number is another
//! value, for which the text is not read again.

mod written;

use std::collections::HashMap;
use std::ops::Range as Bytes;

use common::{SceneNumber, Transfer, Unit};

use crate::{Data, Form, Item, Key, SceneFile};
use written::Written;

impl SceneFile {
    /// All numbers of the file, of which this is the text, in the order of the text. Those inside of a
    /// definition or a repeat are there once, and a colour in a text is three numbers.
    #[must_use]
    pub fn numbers(&self, text: &str) -> Vec<SceneNumber> {
        let mut written = written::values(text);
        let mut numbers = Vec::new();
        let singles = [&self.picture, &self.camera, &self.world];
        let lists = [
            &self.materials,
            &self.lights,
            &self.shapes,
            &self.definitions,
        ];
        for item in singles.into_iter().chain(lists.into_iter().flatten()) {
            add_numbers(item, text, &mut written, &mut numbers);
        }
        numbers.sort_by_key(|number| (number.bytes.start, number.index));
        let (mut line, mut from) = (1, 0);
        for number in &mut numbers {
            let between = text.get(from..number.bytes.start).unwrap_or_default();
            line += between.matches('\n').count();
            from = number.bytes.start;
            number.line = line;
        }
        numbers
    }

    /// The file with another value of a number, also in all copies of a repeat; none if its key does
    /// not allow the value. The colours in bytes are those of this transfer.
    #[must_use]
    pub fn with(&self, transfer: Transfer, number: &SceneNumber, value: f64) -> Option<Self> {
        let [least, greatest] = number.allowed;
        if !(least..=greatest).contains(&value) {
            return None;
        }
        let mut file = self.with_transfer(transfer).into_owned();
        let singles = [&mut file.picture, &mut file.camera, &mut file.world];
        let lists = [
            &mut file.materials,
            &mut file.lights,
            &mut file.shapes,
            &mut file.definitions,
        ];
        for item in singles.into_iter().chain(lists.into_iter().flatten()) {
            set_number(item, number, value);
        }
        Some(file)
    }
}

fn set_number(item: &mut Item, number: &SceneNumber, value: f64) {
    for (_, at, data) in &mut item.values {
        if *at != number.at {
            continue;
        }
        if let Data::Bytes(_, linear) = data {
            // Another transfer does not change a channel that has been given in linear light.
            *data = Data::Numbers(linear.to_vec());
        }
        if let Data::Numbers(numbers) = data
            && let Some(number) = numbers.get_mut(number.index)
        {
            *number = value;
        }
    }
    let is_repeat = item.kind.name == "repeat";
    let mut copies = 0_u32;
    for table in &mut item.tables {
        if is_repeat && table.used.is_some() {
            // Copy i is displaced, or rotated, by i times the numbers of the repeat.
            set_number(table, number, f64::from(copies) * value);
            copies += 1;
        } else {
            set_number(table, number, value);
        }
    }
}

/// Adds the numbers of an item, and of those in it, that have not been found before: a copy of a
/// repeat has the positions of the repeat. Their lines are not yet known.
fn add_numbers(
    item: &Item,
    text: &str,
    written: &mut HashMap<usize, Written>,
    numbers: &mut Vec<SceneNumber>,
) {
    for (name, at, data) in &item.values {
        let values = match data {
            Data::Numbers(values) => values.as_slice(),
            Data::Bytes(_, linear) => linear.as_slice(),
            Data::Text(_) | Data::Flag(_) | Data::Mesh(_) => continue,
        };
        let (Some(key), Some(found)) = (item.kind.key(name), written.remove(at)) else {
            continue;
        };
        // A text has the three numbers of a colour.
        let parts = if found.parts.len() < values.len() {
            of_color(text, &found.parts)
        } else {
            found.parts
        };
        for (index, (value, bytes)) in values.iter().zip(parts).enumerate() {
            numbers.push(SceneNumber {
                line: 0,
                bytes,
                at: *at,
                index,
                table: found.table.clone(),
                key: found.key.clone() + &part(&key.form, index),
                value: *value,
                unit: unit(key, values),
                allowed: [key.range.least, key.range.greatest],
            });
        }
    }
    for table in &item.tables {
        add_numbers(table, text, written, numbers);
    }
}

/// The name of a number of a value, behind the key.
fn part(form: &Form, index: usize) -> String {
    let (row, axis) = (index / 3 + 1, ["x", "y", "z"][index % 3]);
    match (form, form.lengths()) {
        (Form::Color, _) => format!(" {}", ["red", "green", "blue"][index % 3]),
        (_, Some([3])) => format!(" {axis}"),
        (_, Some([_, 3])) => format!(" {row} {axis}"),
        (_, Some([_, columns])) => format!(" {},{}", index / columns + 1, index % columns + 1),
        (_, Some([_])) => format!(" {}", index + 1),
        _ => String::new(),
    }
}

/// The unit of the numbers of a key, which have these values.
fn unit(key: &Key, values: &[f64]) -> Unit {
    match key.unit {
        Some(Unit::Direction(_)) => {
            let squares = values.iter().take(3).map(|value| value * value);
            Unit::Direction(squares.sum::<f64>().sqrt())
        }
        Some(unit) => unit,
        None => Unit::Factor,
    }
}

/// The bytes of the channels of a colour in a text: its digits, or three times the whole text.
fn of_color(text: &str, parts: &[Bytes<usize>]) -> Vec<Bytes<usize>> {
    let Some(bytes) = parts.first().cloned() else {
        return Vec::new();
    };
    let quoted = text.get(bytes.clone()).unwrap_or_default();
    let inside = quoted.trim_matches(['"', '\'']);
    let start = bytes.start + (quoted.len() - inside.len()) / 2 + 1;
    let digits = inside.strip_prefix('#').map_or(0, str::len);
    if !matches!(digits, 3 | 6) {
        return vec![bytes; 3];
    }
    let width = digits / 3;
    let channel = |i| start + i * width..start + (i + 1) * width;
    (0..3).map(channel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers of a text for stage 7, each as it is written, with its table and its key.
    fn numbers(text: &str) -> Vec<String> {
        let file = SceneFile::read(text, 7, &|_| Err("no mesh".to_owned())).unwrap();
        assert_eq!(file.mistake, None);
        let numbers = file.numbers(text);
        let place = |number: &SceneNumber| {
            let SceneNumber {
                line,
                bytes,
                table,
                key,
                value,
                ..
            } = number;
            let written = &text[bytes.clone()];
            format!("{line}: {written} is {table} {key} = {value}")
        };
        numbers.iter().map(place).collect()
    }

    #[test]
    fn each_form_of_a_color_is_three_numbers() {
        let camera = "camera = { eye = [0, 0, 5], gaze = [0, 0, -1], angle = 40 }\n";
        for (color, expected) in [
            ("[1, 0, 0.5]", ["1", "0", "0.5"]),
            ("\"#ff0080\"", ["ff", "00", "80"]),
            ("'#f08'", ["f", "0", "8"]),
            ("\"\"\"#f08\"\"\"", ["f", "0", "8"]),
            ("\"red\"", ["\"red\""; 3]),
            ("\"\\u0023f08\"", ["\"\\u0023f08\""; 3]),
        ] {
            let text = format!("{camera}[world]\nambient = {color}\n");
            let found: Vec<_> = numbers(&text).split_off(7);
            for (found, (written, channel)) in found
                .iter()
                .zip(expected.iter().zip(["red", "green", "blue"]))
            {
                let begin = format!("3: {written} is [world] ambient {channel} = ");
                assert!(found.starts_with(&begin), "{color}: {found}, not {begin}");
            }
            assert_eq!(found.len(), 3);
        }
    }

    #[test]
    fn tables_have_the_same_numbers_in_every_form() {
        let text = "\u{FEFF}camera.eye = [0.5, 0, 5]\ncamera.gaze = [0, 0, -1]\ncamera.angle = 4e1\n\
            # ü\nmaterial = { \"ü\" = { diffuse = \"red\" } }\n\
            sphere = [{ center = [1,\n  2, 3], radius = +1_0.5, material = \"ü\" }]\n\
            [[group]]\ntransform = [{ scale = [1, 2, 3] }, { rotate_x = 5 }]\n\
            sphere = [{ center = [0, 0, 0], radius = 1, color = \"red\", \
            transform = [{ translate = [7, 8, 9] }] }]\n\
            [define.a]\n[[define.a.box]]\nlbf = [0, 0.25, 0]\nrun = [1, 1, 1]\ncolor = \"red\"\n\
            [[use]]\nname = \"a\"\n[[use]]\nname = \"a\"\n";
        let found = numbers(text);
        for expected in [
            "1: 0.5 is [camera] eye x = 0.5",
            "3: 4e1 is [camera] angle = 40",
            "5: \"red\" is [material.ü] diffuse red = 1",
            "7: 2 is [[sphere]] #1 center y = 2",
            "7: +1_0.5 is [[sphere]] #1 radius = 10.5",
            "9: 2 is [[group]] #1 transform step 1: scale y = 2",
            "9: 5 is [[group]] #1 transform step 2: rotate_x = 5",
            "10: 8 is [[group]] #1 [[sphere]] #1 transform step 1: translate y = 8",
            "13: 0.25 is [define.a] [[box]] #1 lbf y = 0.25",
        ] {
            let count = found.iter().filter(|found| *found == expected).count();
            assert_eq!(count, 1, "{expected}: {found:#?}");
        }
    }
}
