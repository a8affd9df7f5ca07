//! Reads the text of a file of cases.

use common::row::{self, Row, Value};

use crate::{Case, ExactAnswer, Hit, Question, Shape, Step};

/// Reads cases. A case that has no answer yet is refused.
///
/// # Errors
///
/// Fails with the case, the key and what it must be.
pub fn read(text: &str) -> Result<Vec<Case>, String> {
    row::read("cases", text, |file| {
        file.rows("case")?.iter().map(Case::read).collect()
    })
}

impl Case {
    fn read(row: &Row) -> Result<Self, String> {
        let case = Self {
            question: Question::read(row)?,
            answer: answer(row)?,
            condition: row.get("condition")?,
            is_border: row.find::<bool>("border")?.is_some(),
            between: row.find("between")?,
        };
        row.end()?;
        Ok(case)
    }
}

impl Question {
    /// The ray and the shape of a case. A row of a laboratory has no family and no source.
    pub fn read(row: &Row) -> Result<Self, String> {
        let id = row.get("id")?;
        let shape = shape(row)?;
        let missing = || row.error("ray", "is missing; it must be a table");
        let ray = row.table("ray")?.ok_or_else(missing)?;
        let question = Self {
            id,
            family: row.find("family")?.unwrap_or_default(),
            says: row.get("says")?,
            source: row.find("source")?.unwrap_or_default(),
            shape,
            under: under(row)?,
            origin: ray.get("origin")?,
            direction: ray.get("direction")?,
            within: row.find("within")?.unwrap_or([0.0, f64::INFINITY]),
        };
        ray.end()?;
        Ok(question)
    }
}

fn shape(row: &Row) -> Result<Shape, String> {
    if let Some(triangles) = row.find("triangles")? {
        return Ok(Shape::Triangles(triangles));
    }
    for key in ["plane", "sphere", "box", "disc", "tube"] {
        let Some(table) = row.table(key)? else {
            continue;
        };
        let shape = match key {
            "plane" => Shape::Plane {
                point: table.get("point")?,
                normal: table.get("normal")?,
            },
            "sphere" => Shape::Sphere {
                center: table.get("center")?,
                radius: table.get("radius")?,
            },
            "box" => Shape::Box {
                low: table.get("low")?,
                high: table.get("high")?,
            },
            "disc" => Shape::Disc {
                center: table.get("center")?,
                normal: table.get("normal")?,
                radius: table.get("radius")?,
            },
            _ => Shape::Tube {
                from: table.get("from")?,
                to: table.get("to")?,
                radius: table.get("radius")?,
            },
        };
        table.end()?;
        return Ok(shape);
    }
    Err(row.error("triangles", "is missing, or another shape"))
}

fn under(row: &Row) -> Result<Vec<Step>, String> {
    let mut steps = Vec::new();
    if row.has("under") {
        for step in row.rows("under")? {
            steps.push(match step.find("translate")? {
                Some(distance) => Step::Translate(distance),
                None => Step::Scale(step.get("scale")?),
            });
            step.end()?;
        }
    }
    Ok(steps)
}

fn answer(row: &Row) -> Result<ExactAnswer, String> {
    match row.get::<String>("answer")?.as_str() {
        "miss" => Ok(ExactAnswer::Miss),
        "coplanar" => Ok(ExactAnswer::Coplanar),
        "hit" => {
            let Digits { text, number } = row.get("t")?;
            let normal: Option<[Digits; 3]> = row.find("normal")?;
            Ok(ExactAnswer::Hit(Hit {
                t: number,
                digits: text,
                normal: normal.map(|normal| normal.map(|digits| digits.text)),
            }))
        }
        _ => Err(row.error("answer", "must be one of hit, miss, coplanar")),
    }
}

/// A number of more digits than doubles have.
struct Digits {
    text: String,
    number: f64,
}

impl Value for Digits {
    fn form() -> String {
        "a number in quotes".to_owned()
    }

    fn read(value: &row::DeValue) -> Option<Self> {
        let text = String::read(value)?;
        let number = text.parse().ok()?;
        Some(Self { text, number })
    }
}
