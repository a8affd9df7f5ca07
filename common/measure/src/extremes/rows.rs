//! The rows of `cases.toml` beside a laboratory: numbers in, a number out, in the format of the corpus.

use corpus::{Fields, Mistake, Question};

use super::{Bound, Case, Condition, Outcome, Protocol};
use crate::Effort;

/// What a row asks, and the numbers that it gives.
pub struct Row {
    /// Its name.
    pub id: String,
    /// The name of the question.
    pub asks: String,
    /// The numbers of a question that is no ray.
    pub numbers: Vec<f64>,
    /// How many random rays or points it takes, if it takes any.
    pub count: usize,
    /// The ray and the shape of a question that is one.
    pub ray: Option<Question>,
}

impl Row {
    /// The number at an index from 0; NaN if the row has fewer.
    pub fn number(&self, index: usize) -> f64 {
        self.numbers.get(index).copied().unwrap_or(f64::NAN)
    }

    /// Three numbers from an index on.
    pub fn triple(&self, index: usize) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.number(index + axis))
    }

    /// The outcome of a question that nobody knows, which is no exact one.
    pub fn unknown() -> Case {
        Case {
            ours: Outcome::Number(f64::NAN),
            ..Case::default()
        }
    }
}

/// The cases of a file, whose outcomes a function computes from each row.
///
/// If the file has a mistake, a single case that does not hold says so.
pub fn rows(text: &str, effort: Effort, compute: impl Fn(&Row) -> Case) -> Vec<Case> {
    let cases = corpus::read_each(text, |fields| case(fields, effort, &compute));
    cases.unwrap_or_else(|mistake| {
        vec![Case {
            id: "cases.toml".into(),
            what: mistake.to_string(),
            exact: Outcome::Flag(true),
            ours: Outcome::Flag(false),
            ..Case::default()
        }]
    })
}

fn case(fields: &Fields, effort: Effort, compute: impl Fn(&Row) -> Case) -> Result<Case, Mistake> {
    let row = Row {
        id: fields.text("id")?,
        asks: match fields.value("asks") {
            Some(_) => fields.text("asks")?,
            None => "distance".to_owned(),
        },
        numbers: match fields.value("numbers") {
            Some(_) => fields.numbers("numbers")?,
            None => Vec::new(),
        },
        count: match fields.value("counts") {
            Some(_) => {
                let [quick, full]: [f64; 2] = fields.numbers("counts")?;
                effort.choose(quick as usize, full as usize)
            }
            None => 0,
        },
        ray: match fields.value("ray") {
            Some(_) => Some(fields.question()?),
            None => None,
        },
    };
    Ok(Case {
        id: row.id.clone(),
        what: fields
            .text("says")?
            .replace("{count}", &row.count.to_string()),
        exact: exact(fields)?,
        bound: bound(fields)?,
        condition: condition(fields)?,
        protocol: match fields.value("protocol") {
            Some(_) if fields.text("protocol")? == "fails" => Protocol::Fails,
            _ => Protocol::Holds,
        },
        ..compute(&row)
    })
}

/// A number or three in quotes, a decision, `none` or `refused`.
fn exact(fields: &Fields) -> Result<Outcome, Mistake> {
    let form = "a number or three in quotes, true, false, none or refused";
    let wrong = || fields.mistake("exact", form);
    let value = fields.value("exact").ok_or_else(wrong)?;
    if let Some(flag) = value.as_bool() {
        return Ok(Outcome::Flag(flag));
    }
    match value.as_str() {
        Some("none") => return Ok(Outcome::Nothing),
        Some("refused") => return Ok(Outcome::Refused),
        Some(digits) => return Ok(Outcome::Number(digits.parse().map_err(|_| wrong())?)),
        None => {}
    }
    let mut numbers = Vec::new();
    for digits in value.as_array().ok_or_else(wrong)? {
        let digits = digits.get_ref().as_str().ok_or_else(wrong)?;
        numbers.push(digits.parse().map_err(|_| wrong())?);
    }
    Ok(Outcome::Triple(numbers.try_into().map_err(|_| wrong())?))
}

/// How far an outcome may be off: not at all; by units in the last place; by these times the condition; by a
/// distance; or by roundings of 1.
fn bound(fields: &Fields) -> Result<Bound, Mistake> {
    let Some(bound) = fields.inner("bound") else {
        return Ok(Bound::Equal);
    };
    if bound.value("ulps").is_some() {
        Ok(Bound::Ulps(bound.number("ulps")?))
    } else if bound.value("conditions").is_some() {
        let condition = fields.number("condition")?;
        Ok(Bound::Ulps(bound.number("conditions")? * condition))
    } else if bound.value("distance").is_some() {
        Ok(Bound::Absolute(bound.number("distance")?))
    } else {
        Ok(Bound::Absolute(bound.number("epsilons")? * f64::EPSILON))
    }
}

/// A number, or why there is none.
fn condition(fields: &Fields) -> Result<Condition, Mistake> {
    match fields.value("condition") {
        None => Ok(Condition::Unstated),
        Some(value) if value.is_str() => Ok(Condition::Without(fields.text("condition")?)),
        Some(_) => Ok(Condition::Known(fields.number("condition")?)),
    }
}
