//! The measurements of an experiment as comma-separated values (RFC 4180).

use std::fmt::Write;

use common::{Median, text};

use crate::experiment::{Axis, Curves, Experiment};
use crate::report::Measured;

impl Measured<'_> {
    /// All measurements as comma-separated values, below lines with `#` about their
    /// origin. [`parse`](Self::parse) reads them again.
    pub fn csv(&self) -> String {
        let e = &self.experiment;
        let mut csv = self.origin();
        let [parameter, work, error] = [e.parameter, e.work, e.error].map(quoted);
        let _ = writeln!(
            csv,
            "method,{parameter},{work},{error},its low,its high,99 %,max,condition,problem's error,\
             over problem,seconds,low,high,time over first,its low,its high"
        );
        for curve in &self.curves {
            let method = quoted(curve.method);
            for point in &curve.points {
                let parameter = text::number(point.parameter);
                let work = text::number(point.work);
                let _ = write!(csv, "{method},{parameter},{work}");
                let errors = &point.errors;
                let ends = errors.interval;
                let _ = write!(csv, ",{:e},{:.3e},{:.3e}", errors.rms, ends.low, ends.high);
                for rank in [errors.p99, errors.max] {
                    csv.push(',');
                    if let Some(error) = rank {
                        let _ = write!(csv, "{error:.3e}");
                    }
                }
                match errors.problem {
                    Some(of) => {
                        let (condition, error) = (of.condition, of.error);
                        let over = of.error_over_condition;
                        let _ = write!(csv, ",{condition:.3e},{error:.3e},{over:.3e}");
                    }
                    None => csv.push_str(",,,"),
                }
                let Median { low, value, high } = point.times.seconds;
                let _ = write!(csv, ",{value:.3e},{low:.3e},{high:.3e}");
                match point.times.over_first {
                    Some(Median { low, value, high }) => {
                        let _ = writeln!(csv, ",{value:.4},{low:.4},{high:.4}");
                    }
                    None => csv.push_str(",,,\n"),
                }
            }
        }
        csv
    }

    /// What was measured, on which machine, in which build, and with which seeds.
    fn origin(&self) -> String {
        let e = &self.experiment;
        let (question, unit, exact) = (e.question, e.unit, e.exact);
        let against = match e.against {
            Axis::Work => "work",
            Axis::Parameter => "parameter",
        };
        let curves = match e.curves_are {
            Curves::Methods => "methods",
            Curves::Problems => "problems",
        };
        let provenance = &self.provenance;
        let rounds = provenance.rounds;
        let mut origin = String::new();
        for (key, words) in [
            ("experiment", text::name(e.name).clone()),
            ("question", question.to_owned()),
            ("parameter", e.parameter.to_owned()),
            ("work", e.work.to_owned()),
            ("error", e.error.to_owned()),
            ("unit", unit.to_string()),
            ("exact", exact.to_owned()),
            ("against", against.to_owned()),
            ("curves", curves.to_owned()),
            ("opposite", e.opposite.unwrap_or_default().to_owned()),
            ("seeds", seeds(e)),
            (
                "seconds",
                "processor time of one thread; medians, and intervals of 95 %".to_owned(),
            ),
            ("rounds", rounds.to_string()),
            ("machine", provenance.machine.clone()),
            ("version", provenance.version.clone()),
            ("date", provenance.date.clone()),
        ] {
            let _ = writeln!(origin, "# {key}: {words}");
        }
        for curve in &self.curves {
            if let Some(slope) = &curve.slope {
                let (value, ends) = (slope.value, &slope.between);
                let (low, high) = (text::number(*ends.start()), text::number(*ends.end()));
                let _ = writeln!(
                    origin,
                    "# theory: slope {value} from {low} to {high}: {}",
                    curve.method
                );
            }
        }
        origin
    }
}

fn seeds(experiment: &Experiment) -> String {
    if experiment.seeds.is_empty() {
        return "no random numbers".to_owned();
    }
    let seeds: Vec<_> = experiment.seeds.iter().map(u64::to_string).collect();
    seeds.join(" ")
}

/// A field, in quotes where a comma would end it. No name has a quote.
fn quoted(field: &str) -> String {
    let field = field.replace('"', "'");
    if field.contains(',') {
        format!("\"{field}\"")
    } else {
        field
    }
}
