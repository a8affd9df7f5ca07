//! Random values of the keys of a table, by the form, the unit and the range of each.

use std::fmt::Write;

use common::Unit;
use scene_file::{Form, Key, Kind, Missing};

use super::{Writer, kind};
use crate::list;
use crate::meshes::{MESHES, mesh};
use crate::numbers::{Numbers, Style};

/// The brightest colour, whose decimals tell it in the text.
const BRIGHT: f64 = 3e20;

/// The rows of a transform without the last one.
type Matrix = [[f64; 4]; 3];

fn rows(matrix: &Matrix) -> String {
    format!("[{}]", matrix.map(|row| list(&row)).join(", "))
}

impl Writer<'_> {
    /// Random values for the keys of a table, but not for the surface of a shape.
    pub(super) fn keys(&mut self, kind: &Kind) -> String {
        let (mut text, is_other) = (String::new(), self.numbers.below(2) == 0);
        let stage = self.stage;
        let keys = kind.keys.iter().filter(|key| key.stage <= stage);
        let mut replaced = Vec::new();
        for key in keys.clone() {
            if let Missing::InsteadOf(others) = &key.missing {
                replaced.extend(others);
            }
        }
        for key in keys {
            let is_there = match &key.missing {
                Missing::NeededOr("material") => false,
                Missing::InsteadOf(others) => is_other && !others.contains(&"color"),
                _ if is_other && replaced.contains(&&key.name) => false,
                Missing::Needed | Missing::NeededWith(_) => true,
                Missing::NeededOr(_) => !is_other,
                // A picture of the size that stands for a missing one takes long.
                Missing::Optional if key.name == "size" => true,
                // Tables in a table have no meaning of their own.
                Missing::Optional => !key.about.is_empty() && self.numbers.below(3) > 0,
            };
            if is_there {
                let value = self.value(key);
                let _ = writeln!(text, "{} = {value}", key.name);
            }
        }
        text
    }

    fn value(&mut self, key: &Key) -> String {
        match &key.form {
            Form::Color if key.range.contains(BRIGHT) && self.numbers.below(12) == 0 => {
                let color = [(); 3].map(|()| self.numbers.one_of(&[0.0, 1e-310, 0.5, BRIGHT]));
                list(&color)
            }
            Form::Color => self.color(),
            Form::Flag => self.numbers.one_of(&["true", "false"]).to_owned(),
            Form::Mesh => {
                let name = self.numbers.one_of(&MESHES);
                let numbers = &mut self.numbers;
                self.meshes
                    .entry(name)
                    .or_insert_with(|| mesh(name, numbers));
                format!("{name:?}")
            }
            Form::Text => format!("{:?}", self.numbers.one_of(&["part", "whole"])),
            Form::Tables(_) => {
                let steps: Vec<_> = (0..self.numbers.below(3)).map(|_| self.step()).collect();
                format!("[{}]", steps.join(", "))
            }
            Form::Numbers { lengths, .. } => match lengths[..] {
                [] => self.numbers_of(key, 1).trim_matches(['[', ']']).to_owned(),
                [count] => self.numbers_of(key, count),
                [rows, columns, ..] => {
                    let rows: Vec<_> = (0..rows).map(|_| self.numbers_of(key, columns)).collect();
                    format!("[{}]", rows.join(", "))
                }
            },
        }
    }

    /// A list of numbers of the unit of a key, and mostly in its range.
    fn numbers_of(&mut self, key: &Key, count: usize) -> String {
        let numbers = &mut self.numbers;
        let in_range = |numbers: &mut Numbers, values: &[f64]| {
            let values: Vec<_> = values
                .iter()
                .copied()
                .filter(|x| key.range.contains(*x))
                .collect();
            (0..count).map(|_| numbers.one_of(&values)).collect()
        };
        let mut values: Vec<f64> = match key.unit {
            Some(Unit::Direction(_)) => numbers.direction().to_vec(),
            Some(Unit::Length) if count == 3 => {
                let mut point = numbers.point();
                // Where it sees most of the scene.
                if key.name == "eye" && numbers.below(3) > 0 {
                    point[numbers.below(3)] += numbers.unit * numbers.one_of(&[3.0, -3.0, 6.0]);
                }
                point.to_vec()
            }
            Some(Unit::Length) => vec![numbers.unit * numbers.one_of(&[0.25, 0.5, 1.0, 0.7])],
            Some(Unit::Degree) => {
                in_range(numbers, &[0.0, 90.0, 180.0, 30.0, 40.0, 3.0, 0.5, 120.0])
            }
            Some(Unit::Scale) => in_range(numbers, &[1.0, 1.0, 1.0, -1.0, 0.5, -2.0, 1e-9]),
            Some(Unit::Whole) => in_range(
                numbers,
                match key.name {
                    // More rays than a batch of the engine has, and fewer.
                    "size" => &[1.0, 3.0, 7.0, 12.0, 16.0, 24.0, 40.0],
                    "samples" => &[1.0, 1.0, 4.0],
                    "depth" => &[1.0, 2.0, 3.0, 5.0, 20.0],
                    _ => &[1.0, 2.0, 3.0],
                },
            ),
            _ => in_range(numbers, &[0.0, 0.5, 1.0, 2.5, 20.0, 64.0, 1024.0]),
        };
        if numbers.style == Style::Any && numbers.below(4) == 0 {
            values[0] = numbers.any();
        }
        if key.form.is_whole() {
            let values: Vec<_> = values.iter().map(f64::to_string).collect();
            return format!("[{}]", values.join(", "));
        }
        list(&values)
    }

    /// Black in one of three cases.
    pub(super) fn color(&mut self) -> String {
        let is_black = self.numbers.below(3) == 0;
        let channels = [(); 3].map(|()| {
            if is_black {
                0.0
            } else {
                self.numbers.below(9) as f64 / 8.0
            }
        });
        list(&channels)
    }

    /// A step of a transform.
    fn step(&mut self) -> String {
        let steps = &kind("step").keys;
        let key = &steps[self.numbers.below(steps.len())];
        match key.name {
            "matrix" => {
                let (mut matrix, _) = self.matrix();
                matrix[0][self.numbers.below(3)] += self.numbers.one_of(&[0.0, 0.125]);
                format!("{{ matrix = {} }}", rows(&matrix))
            }
            "inverse" => {
                let (matrix, inverse) = self.matrix();
                format!(
                    "{{ matrix = {}, inverse = {} }}",
                    rows(&matrix),
                    rows(&inverse)
                )
            }
            name => format!("{{ {name} = {} }}", self.value(key)),
        }
    }

    /// A matrix that exchanges axes, stretches them by powers of two, and moves; and its exact inverse.
    fn matrix(&mut self) -> (Matrix, Matrix) {
        let (turn, to) = (self.numbers.below(3), self.numbers.point());
        let (mut matrix, mut inverse) = ([[0.0; 4]; 3], [[0.0; 4]; 3]);
        for row in 0..3 {
            let column = (row + turn) % 3;
            let factor = self.numbers.one_of(&[1.0, 1.0, -1.0, 2.0, -0.5]);
            (matrix[row][column], matrix[row][3]) = (factor, to[row]);
            (inverse[column][row], inverse[column][3]) = (1.0 / factor, 0.0 - to[row] / factor);
        }
        (matrix, inverse)
    }
}
