//! `Theory`: what theory says about the error of a fact's pictures at each number of samples.

use crate::pictures::fact::Fact;
use crate::pictures::fitted_slope::Axis;
use crate::pictures::quantity::Quantity;
use crate::pictures::run::Run;
use crate::pictures::sheet::{RequestedPicture, Sheet};

/// What theory says about the errors behind a slope.
#[derive(Debug)]
pub struct Theory {
    /// Whose errors they are, such as independent random rays.
    pub name: String,
    /// The errors, one for each number of samples.
    pub errors: Vec<f64>,
    /// Their formula.
    pub formula: String,
    /// Mistakes that leave these pixels as they are.
    pub unseen: String,
    /// The number of tests that white stands for, where a picture shows no light but tests, and samples are
    /// balls. Of such errors only the shape is known.
    pub tests: Option<f64>,
}

/// The errors of a program's pictures, and those of theory.
#[derive(Debug)]
pub struct Precision<'a> {
    /// The fact that asks their slope.
    pub fact: &'a Fact,
    /// What theory says.
    pub theory: &'a Theory,
    /// What the logarithm of the error is a straight line over.
    pub axis: Axis,
    /// The picture that is drawn.
    pub picture: &'a RequestedPicture,
    /// Its runs, from few samples to many.
    pub runs: &'a [Run],
    /// The number of columns.
    pub width: usize,
    /// The errors of each run.
    pub points: Vec<PixelErrors>,
}

/// The errors of a picture.
#[derive(Debug)]
pub struct PixelErrors {
    /// Its samples.
    pub samples: u32,
    /// The time of the run.
    pub seconds: f64,
    /// The differences from what is exact, row by row.
    pub errors: Vec<f64>,
}

impl Fact {
    /// What theory says about its errors.
    pub(crate) const fn theory(&self) -> Option<&Theory> {
        match &self.quantity {
            Quantity::Slope { theory, .. } => theory.as_ref(),
            _ => None,
        }
    }
}

impl Sheet {
    /// The fact of which theory knows the errors.
    pub(crate) fn fact_with_theory(&self) -> Option<&Fact> {
        self.facts.iter().find(|fact| fact.theory().is_some())
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::pictures::quantity::Exact;

    /// The mean of the squared errors of the columns, of which each has this exact value.
    fn squared_error(sheet: &str, samples: f64, f: f64) -> f64 {
        match sheet {
            "lens" | "patterns" => f * (1.0 - f) / samples,
            "light" => f * (0.5 - f) / samples,
            "lamp" => {
                let k = samples.sqrt();
                let g = (k * f).fract();
                g * (1.0 - g) / (k * k * k)
            }
            "glass" => {
                let r = 0.387_704;
                let error = f * (1.0 - r) * libm::pow(r, samples - 2.0);
                error * error
            }
            _ => libm::log2(samples) * libm::log2(samples),
        }
    }

    #[test]
    fn errors_follow_from_their_formulas() {
        for name in ["glass", "lamp", "lens", "light", "patterns", "tree"] {
            let file = format!("{}/sheets/{name}.toml", env!("CARGO_MANIFEST_DIR"));
            // A handout has the sheets of its stages alone.
            let Ok(text) = fs::read_to_string(file) else {
                continue;
            };
            let sheet = Sheet::read(name, &text).unwrap();
            let fact = sheet.fact_with_theory().unwrap();
            let Quantity::Slope {
                exact,
                runs,
                theory: Some(theory),
                ..
            } = &fact.quantity
            else {
                panic!("{name}")
            };
            let columns = match exact {
                Exact::Number(number) => vec![*number],
                Exact::Columns(columns) => columns.clone(),
                Exact::Run(_) => panic!("{name}"),
            };
            for (run, error) in runs.iter().zip(&theory.errors) {
                let squared = |f: &f64| squared_error(name, run.samples.into(), *f);
                let sum: f64 = columns.iter().map(squared).sum();
                let exact = (sum / columns.len() as f64).sqrt();
                assert!(
                    (error / exact - 1.0).abs() < 0.004,
                    "{name}: {error} {exact}"
                );
            }
        }
    }
}
