//! Reads the text of a file of cases.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::{Answer, Case, Hit, Question, Shape, Step};

/// What is wrong in a file of cases.
#[derive(Debug, thiserror::Error)]
pub enum Mistake {
    /// The text is no TOML.
    #[error("no TOML: {0}")]
    Toml(#[from] toml::de::Error),
    /// A value of a case is missing or is not of its form.
    #[error("case {case}: {key} is missing, or is not {form}")]
    Value {
        /// The id of the case, or its number in the file if it has none.
        case: String,
        /// The key of the value.
        key: String,
        /// What is expected.
        form: &'static str,
    },
}

/// Reads cases. A case that has no answer yet is refused.
#[allow(clippy::redundant_closure_for_method_calls)]
pub fn read(text: &str) -> Result<Vec<Case>, Mistake> {
    read_each(text, |fields| fields.case())
}

/// Reads each table `[[case]]` of a file by a function.
// It is a closure where it is called, because the name of a method would have the lifetime of one table.
pub fn read_each<T>(
    text: &str,
    read: impl Fn(&Fields) -> Result<T, Mistake>,
) -> Result<Vec<T>, Mistake> {
    let file = DeTable::parse(text)?;
    let mut all = Vec::new();
    if let Some(DeValue::Array(tables)) = file.get_ref().get("case").map(Spanned::get_ref) {
        for (number, table) in tables.iter().enumerate() {
            let mut fields = Fields {
                table: table.get_ref().as_table(),
                case: format!("number {}", number + 1),
            };
            fields.case = fields.text("id")?;
            all.push(read(&fields)?);
        }
    }
    Ok(all)
}

/// The values of a table, and the case to which they belong.
pub struct Fields<'a> {
    table: Option<&'a DeTable<'a>>,
    case: String,
}

impl Fields<'_> {
    /// The value of a key, if it is there.
    #[must_use]
    pub fn value(&self, key: &str) -> Option<&DeValue<'_>> {
        Some(self.table?.get(key)?.get_ref())
    }

    /// Says that a key should be of a form.
    #[must_use]
    pub fn mistake(&self, key: &str, form: &'static str) -> Mistake {
        Mistake::Value {
            case: self.case.clone(),
            key: key.to_owned(),
            form,
        }
    }

    /// A text.
    pub fn text(&self, key: &str) -> Result<String, Mistake> {
        let text = self.value(key).and_then(DeValue::as_str);
        text.map(str::to_owned)
            .ok_or_else(|| self.mistake(key, "a text"))
    }

    /// A number.
    pub fn number(&self, key: &str) -> Result<f64, Mistake> {
        let number = self.value(key).and_then(number);
        number.ok_or_else(|| self.mistake(key, "a number"))
    }

    /// As many numbers in brackets as an array or a vector holds.
    pub fn numbers<A: TryFrom<Vec<f64>>>(&self, key: &str) -> Result<A, Mistake> {
        let numbers = self.value(key).and_then(numbers);
        let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
        numbers.ok_or_else(|| self.mistake(key, "as many numbers in brackets as it has"))
    }

    /// The table of this key, whose values belong to the same case.
    #[must_use]
    pub fn inner(&self, key: &str) -> Option<Fields<'_>> {
        Some(Fields {
            table: Some(self.value(key)?.as_table()?),
            case: self.case.clone(),
        })
    }

    fn case(&self) -> Result<Case, Mistake> {
        Ok(Case {
            question: self.question()?,
            answer: self.answer()?,
            condition: self.number("condition")?,
            is_border: self.value("border").is_some(),
            between: match self.value("between") {
                Some(_) => Some(self.numbers("between")?),
                None => None,
            },
        })
    }

    /// The ray and the shape of a case. A row of a laboratory has no family and no source.
    pub fn question(&self) -> Result<Question, Mistake> {
        let ray = self
            .inner("ray")
            .ok_or_else(|| self.mistake("ray", "a table"))?;
        Ok(Question {
            id: self.text("id")?,
            family: self.text("family").unwrap_or_default(),
            says: self.text("says")?,
            source: self.text("source").unwrap_or_default(),
            shape: self.shape()?,
            under: self.under()?,
            origin: ray.numbers("origin")?,
            direction: ray.numbers("direction")?,
            within: match self.value("within") {
                Some(_) => self.numbers("within")?,
                None => [0.0, f64::INFINITY],
            },
        })
    }

    fn shape(&self) -> Result<Shape, Mistake> {
        if let Some(plane) = self.inner("plane") {
            return Ok(Shape::Plane {
                point: plane.numbers("point")?,
                normal: plane.numbers("normal")?,
            });
        }
        if let Some(sphere) = self.inner("sphere") {
            return Ok(Shape::Sphere {
                center: sphere.numbers("center")?,
                radius: sphere.number("radius")?,
            });
        }
        if let Some(aligned) = self.inner("box") {
            return Ok(Shape::Box {
                low: aligned.numbers("low")?,
                high: aligned.numbers("high")?,
            });
        }
        if let Some(disc) = self.inner("disc") {
            return Ok(Shape::Disc {
                center: disc.numbers("center")?,
                normal: disc.numbers("normal")?,
                radius: disc.number("radius")?,
            });
        }
        if let Some(tube) = self.inner("tube") {
            return Ok(Shape::Tube {
                from: tube.numbers("from")?,
                to: tube.numbers("to")?,
                radius: tube.number("radius")?,
            });
        }
        self.triangles()
    }

    fn triangles(&self) -> Result<Shape, Mistake> {
        let form = "an array of triangles of three corners of three numbers (or another shape)";
        let rows = self.value("triangles").and_then(DeValue::as_array);
        let rows = rows.ok_or_else(|| self.mistake("triangles", form))?;
        let mut triangles = Vec::new();
        for row in rows {
            triangles.push(triangle(row.get_ref()).ok_or_else(|| self.mistake("triangles", form))?);
        }
        Ok(Shape::Triangles(triangles))
    }

    fn under(&self) -> Result<Vec<Step>, Mistake> {
        let mut steps = Vec::new();
        if let Some(DeValue::Array(tables)) = self.value("under") {
            for table in tables {
                let step = Fields {
                    table: table.get_ref().as_table(),
                    case: self.case.clone(),
                };
                steps.push(match step.value("translate") {
                    Some(_) => Step::Translate(step.numbers("translate")?),
                    None => Step::Scale(step.numbers("scale")?),
                });
            }
        }
        Ok(steps)
    }

    fn answer(&self) -> Result<Answer, Mistake> {
        match self.text("answer")?.as_str() {
            "miss" => Ok(Answer::Miss),
            "coplanar" => Ok(Answer::Coplanar),
            "hit" => {
                let digits = self.text("t")?;
                let t = digits.parse().ok();
                let normal = match self.value("normal") {
                    Some(_) => Some(self.digits("normal")?),
                    None => None,
                };
                Ok(Answer::Hit(Hit {
                    t: t.ok_or_else(|| self.mistake("t", "a number in quotes"))?,
                    digits,
                    normal,
                }))
            }
            _ => Err(self.mistake("answer", "one of hit, miss, coplanar")),
        }
    }

    /// Three numbers of more digits than doubles have, in quotes.
    fn digits(&self, key: &str) -> Result<[String; 3], Mistake> {
        let form = "three numbers in quotes";
        let texts = self.value(key).and_then(DeValue::as_array);
        let mut digits = Vec::new();
        for text in texts.ok_or_else(|| self.mistake(key, form))? {
            let text = text.get_ref().as_str();
            let text = text.filter(|text| text.parse::<f64>().is_ok());
            digits.push(text.ok_or_else(|| self.mistake(key, form))?.to_owned());
        }
        digits.try_into().map_err(|_| self.mistake(key, form))
    }
}

fn number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Float(number) => number.as_str().parse().ok(),
        DeValue::Integer(number) => number.as_str().parse().ok(),
        _ => None,
    }
}

fn numbers(value: &DeValue) -> Option<Vec<f64>> {
    let values = value.as_array()?;
    values.iter().map(|value| number(value.get_ref())).collect()
}

fn triangle(value: &DeValue) -> Option<[[f64; 3]; 3]> {
    let mut corners = Vec::new();
    for corner in value.as_array()? {
        corners.push(numbers(corner.get_ref())?.try_into().ok()?);
    }
    corners.try_into().ok()
}
