//! The measurements of an experiment as comma-separated values (RFC 4180).

use std::fmt::Write;

use common::{Median, text};

use crate::experiment::{Experiment, pareto_front};
use crate::provenance::Provenance;
use crate::report::Measured;

impl Measured<'_, '_> {
    /// All measurements as comma-separated values, below lines with `#` about their
    /// origin.
    pub fn csv(&self) -> String {
        let e = self.experiment;
        let mut csv = self.origin();
        let [parameter, work, error] = [e.parameter, e.work, e.error].map(quoted);
        let _ = writeln!(
            csv,
            "experiment,method,{parameter},{work},{error},99 %,max,condition,problem's error,\
             seconds,low,high,pareto"
        );
        let experiment = quoted(&text::name(e.name));
        let front = pareto_front(&self.curves);
        for (c, curve) in self.curves.iter().enumerate() {
            let method = quoted(curve.method);
            for (p, point) in curve.points.iter().enumerate() {
                let parameter = text::number(point.parameter);
                let work = text::number(point.work);
                let _ = write!(csv, "{experiment},{method},{parameter},{work}");
                let errors = &point.errors;
                let _ = write!(csv, ",{:e},{:e},{:e}", errors.rms, errors.p99, errors.max);
                match errors.problem {
                    Some(of) => drop(write!(csv, ",{:e},{:e}", of.condition, of.error)),
                    None => csv.push_str(",,"),
                }
                let Median { low, value, high } = point.times.median();
                let is_on_front = front[c][p];
                let _ = writeln!(csv, ",{value:e},{low:e},{high:e},{is_on_front}");
            }
        }
        csv
    }

    /// What was measured, on which machine, in which build, and with which seeds.
    fn origin(&self) -> String {
        let e = self.experiment;
        let name = text::name(e.name);
        let (question, unit, exact) = (e.question, e.unit, e.exact);
        let times = self.curves.iter().flat_map(|curve| &curve.points);
        let rounds = times.map(|point| point.times.seconds.len()).max();
        let rounds = rounds.unwrap_or(0);
        let seeds = seeds(e);
        let Provenance { machine, version } = Provenance::here();
        format!(
            "# experiment: {name}: {question}\n\
             # error: {} ({unit}), {exact}\n\
             # work: counted: {}\n\
             # seconds: median of {rounds} rounds by turns\n\
             # low and high: interval of 95 % for the median\n\
             # seed: {seeds}\n\
             # machine: {machine}\n\
             # version: {version}\n",
            e.error, e.work
        )
    }
}

fn seeds(experiment: &Experiment) -> String {
    if experiment.seeds.is_empty() {
        return "no random numbers".to_owned();
    }
    let seeds: Vec<_> = experiment.seeds.iter().map(u64::to_string).collect();
    seeds.join(" ")
}

/// A field, in quotes where a comma or a quote would end it.
fn quoted(field: &str) -> String {
    if field.contains([',', '"']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
