//! The diagrams of a report, as `cargo run -- report` draws them.

use common::Median;
use measure::experiment::{Errors, Interval};
use measure::plot::{Diagram, Line, Mark};

use super::{Point, Report, SIDE};
use crate::sheet::history::{self, Earlier};

impl Report<'_> {
    /// The diagrams, each with the ending of its file, and the lines of earlier reports.
    pub fn diagrams(&self, earlier: &[Earlier]) -> Vec<(&'static str, String)> {
        let time = "run time (s)";
        if !self.counts_tests() {
            let mut diagram = self.diagram(time, "root mean square error (white = 1)");
            for point in &self.points {
                diagram.marks.push(mark(0, point.seconds, &point.errors));
            }
            for point in &self.points {
                if let Some(blocks) = &point.blocks {
                    diagram.marks.push(mark(1, point.seconds, blocks));
                }
            }
            let of_theory = |point: &Point| [point.seconds.value, point.theory];
            diagram.lines = lines(earlier, |point| [point.seconds, point.error]);
            diagram
                .lines
                .push(self.line(&self.precision.theory.name, of_theory));
            if self.points[0].blocks.is_some() {
                let quarter = |point: &Point| [point.seconds.value, point.errors.rms / SIDE as f64];
                diagram
                    .lines
                    .push(self.line("a pixel's error / 4", quarter));
            }
            return vec![("svg", diagram.draw(&["a pixel", "mean of 16 pixels"]))];
        }
        let mut tests = self.diagram("balls", "tests of a ray (root mean square)");
        let mut seconds = self.diagram("balls", time);
        for point in &self.points {
            let balls = exactly(point.samples.into());
            tests.marks.push(mark(0, balls, &point.errors));
            let Median { low, value, high } = point.seconds;
            seconds.marks.push(Mark {
                curve: 0,
                x: balls.value,
                x_ends: ends(balls),
                y: value,
                y_ends: Interval { low, high },
            });
        }
        tests.lines = lines(earlier, |point| [point.samples.into(), point.error]);
        let of_theory = |point: &Point| [point.samples.into(), point.theory];
        tests
            .lines
            .push(self.line(&self.precision.theory.name, of_theory));
        seconds.lines = lines(earlier, |point| [point.samples.into(), point.seconds]);
        vec![
            ("svg", tests.draw(&["your tree"])),
            ("time.svg", seconds.draw(&["your tree"])),
        ]
    }

    fn diagram(&self, x: &str, y: &str) -> Diagram {
        Diagram {
            title: format!("{}: {}", self.sheet.title, self.precision.fact.says),
            remark: String::new(),
            x: x.to_owned(),
            y: y.to_owned(),
            is_wide: true,
            has_curves: true,
            marks: Vec::new(),
            lines: Vec::new(),
        }
    }

    fn line(&self, name: &str, point: impl Fn(&Point) -> [f64; 2]) -> Line {
        Line {
            name: Some(name.to_owned()),
            curve: None,
            points: self.points.iter().map(point).collect(),
        }
    }
}

/// A line for each earlier report, thin in the colour of this one's curve.
fn lines(earlier: &[Earlier], place: impl Fn(&history::Point) -> [f64; 2]) -> Vec<Line> {
    let mut lines = Vec::new();
    for report in earlier {
        lines.push(Line {
            name: lines.is_empty().then(|| "earlier reports".to_owned()),
            curve: Some(0),
            points: report.iter().map(&place).collect(),
        });
    }
    lines
}

fn mark(curve: usize, x: Median, errors: &Errors) -> Mark {
    Mark {
        curve,
        x: x.value,
        x_ends: ends(x),
        y: errors.rms,
        y_ends: errors.interval,
    }
}

const fn ends(Median { low, high, .. }: Median) -> Interval {
    Interval { low, high }
}

const fn exactly(value: f64) -> Median {
    Median {
        low: value,
        value,
        high: value,
    }
}
