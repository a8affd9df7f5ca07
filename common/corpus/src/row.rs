//! `Row`: a case of `laboratory.toml`, and what the stages' laboratories expect of two formulas.

use std::sync::LazyLock;

use crate::reader::read_rows;
use crate::{Case, LABORATORY, Mistake};

/// A case, and what is expected of the lesson and of the course's protocol.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The ray, the shape and the exact answer.
    pub case: Case,
    /// `t` times the length of the direction, of a hit.
    pub distance: Option<Distance>,
    /// What is expected.
    pub expected: Expected,
}

/// A distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Distance {
    /// Rounded to 40 significant digits.
    pub digits: String,
    /// Rounded to a double.
    pub value: f64,
}

/// The outcomes that are expected of two formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Expected {
    /// Which quantity is asked, and of which ray.
    pub asks: Asks,
    /// How far an answer may be off.
    pub bound: Bound,
    /// Whether the formula of the course's protocol is within the bound, if it is asked.
    pub protocol: Option<Outlook>,
    /// Whether the lesson's constructors refuse the numbers: there is no such shape or ray, or its
    /// size is out of their range.
    pub is_refused: bool,
}

/// The question of a row about a ray and a shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Asks {
    /// The distance of the nearest hit, along a ray whose direction the lesson brings to length 1.
    #[default]
    Distance,
    /// The same, where the protocol's formula gets the direction as it is given.
    AsGiven,
    /// `t`, in units of the direction as it is given.
    T,
    /// The normal at the nearest hit.
    Normal,
    /// Whether a shadow ray from its origin is free: whether there is no hit.
    IsLit,
}

/// How far an answer may be off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Bound {
    /// Not at all.
    #[default]
    Equal,
    /// This many units in the last place.
    Ulps(f64),
    /// This many times the condition of the case, in units in the last place.
    Conditions(f64),
    /// Four roundings of a length over the cosine between the ray and the normal: `4 ε length / cosine`.
    Roundings {
        /// Such as the distance to the middle of a sphere.
        length: f64,
        /// From 0 to 1.
        cosine: f64,
    },
}

/// Whether a formula is within the bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outlook {
    /// It is.
    Holds,
    /// It is not.
    Fails,
}

/// The rows of the laboratories, which are read once.
static ROWS: LazyLock<Result<Vec<Row>, Mistake>> = LazyLock::new(|| read_rows(LABORATORY));

/// The rows of some families, in the order of the file.
///
/// # Errors
///
/// If the file has a mistake.
pub fn rows(families: &[&str]) -> Result<Vec<&'static Row>, &'static Mistake> {
    let all = ROWS.as_ref()?;
    let is_one = |row: &&Row| families.contains(&row.case.question.family.as_str());
    Ok(all.iter().filter(is_one).collect())
}
