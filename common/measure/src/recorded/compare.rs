//! Two recordings beside each other: which quotients of times have another sign on another machine, or on
//! another day.

use std::fmt;

use super::recorded_point::{Measurement, RecordedPoint};
use super::{Recording, figure, is_first, over_first};

/// A point whose time, over that of the first method, has another sign in another recording.
#[derive(Debug)]
pub struct Turned<'t> {
    experiment: &'t str,
    method: &'t str,
    parameter: f64,
    first: &'t str,
    here: Measurement,
    elsewhere: Measurement,
}

impl Turned<'_> {
    /// Whether what is faster here is slower elsewhere; else only one recording tells a difference.
    pub fn is_opposite(&self) -> bool {
        self.here.sign().is_some() && self.elsewhere.sign().is_some()
    }
}

impl fmt::Display for Turned<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            experiment,
            method,
            parameter,
            first,
            ..
        } = self;
        let [here, elsewhere] = [self.here, self.elsewhere].map(figure::quotient);
        write!(f, "{experiment} at {parameter}: {method} over {first}: ")?;
        write!(f, "{here}; elsewhere {elsewhere}")
    }
}

/// Two recordings that have been compared.
#[derive(Debug)]
pub struct Comparison<'t> {
    /// How many quotients both have.
    pub quotients: usize,
    /// Those with another sign.
    pub turned: Vec<Turned<'t>>,
    /// The points of the other recording behind them, as a recording of its own.
    pub elsewhere: String,
}

impl<'t> Recording<'t> {
    /// Compares the quotients that both recordings have.
    pub fn compare(&self, other: &Recording<'t>) -> Comparison<'t> {
        let (mut quotients, mut turned) = (0, Vec::new());
        let mut kept = Vec::new();
        for row in self.rows.iter().filter(|row| !is_first(&self.rows, row)) {
            let pair = over_first(&self.rows, row).zip(over_first(&other.rows, row));
            let Some((here, elsewhere)) = pair else {
                continue;
            };
            quotients += 1;
            let first = self
                .rows
                .iter()
                .find(|first| first.experiment == row.experiment);
            if here.sign() == elsewhere.sign() {
                continue;
            }
            kept.push(row);
            turned.push(Turned {
                experiment: row.experiment,
                method: row.method,
                parameter: row.parameter,
                first: first.map_or("", |first| first.method),
                here,
                elsewhere,
            });
        }
        // Opposite signs first.
        turned.sort_by_key(|one| !one.is_opposite());
        let is_kept = |row: &&RecordedPoint| {
            kept.iter().any(|kept| {
                kept.is_at(row) && (kept.method == row.method || is_first(&other.rows, row))
            })
        };
        let head = other
            .head
            .iter()
            .map(|(key, words)| format!("# {key}: {words}"));
        let mut elsewhere: Vec<String> = head.chain([other.columns.to_owned()]).collect();
        let rows = other.rows.iter().filter(is_kept);
        elsewhere.extend(rows.map(|row| row.line.to_owned()));
        Comparison {
            quotients,
            turned,
            elsewhere: elsewhere.join("\n") + "\n",
        }
    }
}
