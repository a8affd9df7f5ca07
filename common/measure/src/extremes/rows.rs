//! The rows of `cases.toml` beside a laboratory: numbers in, a number out, in the format of the corpus.

use common::row::{self, DeValue, Value};
use corpus::Question;

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
    let cases = row::read("cases.toml", text, |file| {
        let rows = file.rows("case")?;
        rows.iter().map(|row| case(row, effort, &compute)).collect()
    });
    cases.unwrap_or_else(|mistake| {
        vec![Case {
            id: "cases.toml".into(),
            what: mistake,
            exact: Outcome::Flag(true),
            ours: Outcome::Flag(false),
            ..Case::default()
        }]
    })
}

fn case(of: &row::Row, effort: Effort, compute: impl Fn(&Row) -> Case) -> Result<Case, String> {
    let row = Row {
        id: of.get("id")?,
        asks: of.find("asks")?.unwrap_or_else(|| "distance".to_owned()),
        numbers: of.find("numbers")?.unwrap_or_default(),
        count: match of.find::<[f64; 2]>("counts")? {
            Some([quick, full]) => effort.choose(quick as usize, full as usize),
            None => 0,
        },
        ray: if of.has("ray") {
            Some(Question::read(of)?)
        } else {
            None
        },
    };
    let says: String = of.get("says")?;
    let protocol: Option<String> = of.find("protocol")?;
    let case = Case {
        id: row.id.clone(),
        what: says.replace("{count}", &row.count.to_string()),
        exact: of.get("exact")?,
        bound: bound(of)?,
        condition: of.find("condition")?.unwrap_or(Condition::Unstated),
        protocol: match protocol.as_deref() {
            Some("fails") => Protocol::Fails,
            _ => Protocol::Holds,
        },
        ..compute(&row)
    };
    of.end()?;
    Ok(case)
}

impl Value for Outcome {
    fn form() -> String {
        "a number or three in quotes, true, false, none or refused".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        let number = |value: &DeValue| value.as_str()?.parse().ok();
        match value {
            DeValue::Boolean(flag) => Some(Self::Flag(*flag)),
            DeValue::String(word) if word == "none" => Some(Self::Nothing),
            DeValue::String(word) if word == "refused" => Some(Self::Refused),
            DeValue::String(_) => number(value).map(Self::Number),
            DeValue::Array(all) => {
                let numbers: Option<Vec<f64>> = all.iter().map(|x| number(x.get_ref())).collect();
                Some(Self::Triple(numbers?.try_into().ok()?))
            }
            _ => None,
        }
    }
}

/// How far an outcome may be off: not at all; by units in the last place; by these times the condition; by a
/// distance; or by roundings of 1.
fn bound(row: &row::Row) -> Result<Bound, String> {
    let Some(table) = row.table("bound")? else {
        return Ok(Bound::Equal);
    };
    let bound = if let Some(ulps) = table.find("ulps")? {
        Bound::Ulps(ulps)
    } else if let Some(conditions) = table.find::<f64>("conditions")? {
        Bound::Ulps(conditions * row.get::<f64>("condition")?)
    } else if let Some(distance) = table.find("distance")? {
        Bound::Absolute(distance)
    } else {
        Bound::Absolute(table.get::<f64>("epsilons")? * f64::EPSILON)
    };
    table.end()?;
    Ok(bound)
}

/// A number, or why there is none.
impl Value for Condition {
    fn form() -> String {
        "a number, or why there is none".to_owned()
    }

    fn read(value: &DeValue) -> Option<Self> {
        let number = f64::read(value).map(Self::Known);
        number.or_else(|| String::read(value).map(Self::Without))
    }
}
