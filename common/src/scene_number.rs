//! `SceneNumber`: a number of a scene file, and where it stands.

use std::ops::Range;

/// The unit of a number of a scene, from which the step follows that moves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// A length, or a coordinate of a place, in the unit of the scene.
    Length,
    /// An angle in degrees.
    Degree,
    /// A coordinate of a direction of this length, which has no unit.
    Direction(f64),
    /// A factor or an exponent, which has no unit.
    Factor,
    /// A factor by which shapes are stretched.
    Scale,
    /// A channel of a colour, in linear light: 1 is the brightest that a picture shows.
    Channel,
    /// A whole number, such as a number of copies. It cannot be moved a little.
    Whole,
}

/// A number of a scene file, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneNumber {
    /// Its line, from 1.
    pub line: usize,
    /// Its bytes in the text of the file. A colour in a text has three numbers: those of digits have
    /// two bytes each, or one, and those of a name have the whole name.
    pub bytes: Range<usize>,
    /// The first byte of its value, which may be a list of several numbers.
    pub at: usize,
    /// Which of these numbers it is, from 0.
    pub index: usize,
    /// Its table, such as `[[sphere]] #2`: the second one in the file, or in its group.
    pub table: String,
    /// Its key, and which of the numbers of this key it is, such as `center x`.
    pub key: String,
    /// Its value; of a colour in a text, the channel in linear light.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
    /// The least and the greatest number that its key allows.
    pub allowed: [f64; 2],
}
