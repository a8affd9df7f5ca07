//! `Row`: a line of a recording.

/// A point of a curve.
#[derive(Debug)]
pub struct Row<'t> {
    /// With its stage, such as `a04.sphere-far`.
    pub experiment: &'t str,
    method: &'t str,
    pub parameter: f64,
    pub unit: &'t str,
    pub error: f64,
    pub seconds: f64,
    /// The slope of the curve, if it is a power law.
    pub slope: Option<f64>,
}

impl<'t> Row<'t> {
    /// A row as [`csv`](crate::report::csv) writes it, with method and unit in quotes.
    pub fn parse(line: &'t str) -> Option<Self> {
        let parts: Vec<_> = line.split('"').collect();
        let [experiment, method, parameter_and_work, unit, numbers] = parts[..] else {
            return None;
        };
        let (parameter, _) = parameter_and_work.strip_prefix(',')?.split_once(',')?;
        let numbers: Vec<_> = numbers.split(',').collect();
        let ["", error, _, _, seconds, _, _, slope] = numbers[..] else {
            return None;
        };
        Some(Self {
            experiment: experiment.strip_suffix(',')?,
            method,
            parameter: parameter.parse().ok()?,
            unit,
            error: error.parse().ok()?,
            seconds: seconds.parse().ok()?,
            slope: slope.parse().ok(),
        })
    }

    /// Whether its method has this name in lower case, with dashes between its words.
    pub fn has_method(&self, name: &str) -> bool {
        let mut dashed = String::new();
        for letter in self.method.to_lowercase().chars() {
            if letter.is_alphanumeric() {
                dashed.push(letter);
            } else if !dashed.ends_with('-') {
                dashed.push('-');
            }
        }
        dashed.trim_matches('-') == name
    }
}
