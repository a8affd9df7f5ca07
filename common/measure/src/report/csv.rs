//! Measurements as comma-separated values (RFC 4180).

use std::fmt::Write;

use common::{Median, text};

use crate::experiment::{Experiment, Interval};
use crate::report::Measured;

/// A measured experiment with the name that its rows have.
pub struct Named<'m, 'a> {
    /// The name.
    pub name: String,
    /// The measurement.
    pub measured: &'m Measured<'a>,
}

/// The measurements of some experiments as comma-separated values, below lines with `#`: where they
/// come from, and the question of each experiment. [`Recording`](crate::recorded::Recording) reads
/// them.
pub fn csv(provenance: &[(&str, String)], all: &[Named]) -> String {
    let mut csv = String::new();
    for (key, words) in provenance {
        let _ = writeln!(csv, "# {key}: {words}");
    }
    csv += "# seconds: processor time of one thread; medians, and intervals of 95 % in this run\n";
    for Named { name, measured } in all {
        let e = &measured.experiment;
        let (question, error, exact, seeds) = (e.question, e.error, e.exact, seeds(e));
        let name = text::name(name);
        let _ = writeln!(csv, "# {name}: {question} {error}, {exact}; {seeds}");
    }
    csv += "experiment,method,parameter,work,unit,error,error low,error high,\
            seconds,seconds low,seconds high,slope,slope low,slope high\n";
    for named in all {
        add_rows(&mut csv, named);
    }
    csv
}

fn add_rows(csv: &mut String, Named { name, measured }: &Named) {
    let e = &measured.experiment;
    for curve in &measured.curves {
        let slope = match e.fit(curve) {
            Some(fit) if fit.is_power_law() => {
                let Interval { low, high } = fit.interval();
                format!("{:.4},{low:.4},{high:.4}", fit.slope)
            }
            _ => ",,".to_owned(),
        };
        for point in &curve.points {
            let (name, method, unit) = (text::name(name), curve.method, e.unit);
            let (parameter, work) = (text::number(point.parameter), text::number(point.work));
            let _ = write!(csv, "{name},\"{method}\",{parameter},{work},\"{unit}\"");
            let (error, ends) = (point.errors.rms, point.errors.interval);
            let _ = write!(csv, ",{error:e},{:.3e},{:.3e}", ends.low, ends.high);
            let Median { low, value, high } = point.times.seconds;
            let _ = writeln!(csv, ",{value:.3e},{low:.3e},{high:.3e},{slope}");
        }
    }
}

fn seeds(experiment: &Experiment) -> String {
    if experiment.seeds.is_empty() {
        return "no random numbers".to_owned();
    }
    let seeds: Vec<_> = experiment.seeds.iter().map(u64::to_string).collect();
    format!("seeds {}", seeds.join(" "))
}
