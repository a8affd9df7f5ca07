//! `Precision`: the error of a program's pictures against its run time, as a table, in words, and as the work-precision
//! diagram of `cargo run -- report`.

use std::fmt::Write;

use common::{Median, text};
use judge::pictures::{Axis, Precision, Sheet};
use measure::RoundedInterval;
use measure::experiment::{self, Curve, Errors, HALF_GREY_LEVEL, Interval, Times};
use measure::fit::Fit;
use measure::plot::{Diagram, Line, Mark};

use super::history::Earlier;

/// The pixels of a block along each side. Where there are fewer rows, they stand beside each other.
const SIDE: usize = 4;

/// The errors of a program's pictures and the times of its runs.
pub struct Report<'a> {
    sheet: &'a Sheet,
    precision: Precision<'a>,
    pub points: Vec<Point>,
}

/// What is measured with a number of samples.
pub struct Point {
    pub samples: u32,
    /// The errors of the pixels.
    pub errors: Errors,
    /// The errors of the means of blocks of pixels, if there is noise.
    blocks: Option<Errors>,
    /// The error of theory.
    theory: f64,
    pub seconds: Median,
}

impl<'a> Report<'a> {
    /// The report of pictures and the times that they took. The error is a sentence about the program.
    pub fn new(
        sheet: &'a Sheet,
        precision: Precision<'a>,
        seconds: impl IntoIterator<Item = Median>,
    ) -> Result<Self, String> {
        let theory = precision.theory;
        let mut points = Vec::<Point>::new();
        for (of_picture, seconds) in precision.points.iter().zip(seconds) {
            let scale = theory.tests.unwrap_or(1.0);
            let all: Vec<_> = of_picture.errors.iter().map(|e| e * scale).collect();
            let has_noise = theory.tests.is_none() && precision.axis == Axis::Logarithm;
            let blocks = has_noise.then(|| Errors::of(means_of_blocks(&all, precision.width)));
            points.push(Point {
                samples: of_picture.samples,
                errors: Errors::of(all),
                blocks,
                theory: theory.errors[points.len()],
                seconds,
            });
        }
        let is_used = "does the program use --samples?";
        for (two, pictures) in points.windows(2).zip(precision.points.windows(2)) {
            if pictures[0].errors == pictures[1].errors {
                let [few, many] = [two[0].samples, two[1].samples];
                return Err(format!(
                    "{}: {few} and {many} samples draw the same pixels: {is_used}",
                    sheet.name
                ));
            }
        }
        for Point {
            samples, errors, ..
        } in &points
        {
            if errors.rms == 0.0 {
                return Err(format!(
                    "{}: with {samples} samples the picture is exact already: {is_used}",
                    sheet.name
                ));
            }
        }
        if theory.tests.is_some() {
            let scale = points[0].errors.rms / points[0].theory;
            for point in &mut points {
                point.theory *= scale;
            }
        }
        Ok(Self {
            sheet,
            precision,
            points,
        })
    }

    fn counts_tests(&self) -> bool {
        self.precision.theory.tests.is_some()
    }

    /// The table, the slopes, and what they mean.
    pub fn words(&self, earlier: Option<&Earlier>) -> String {
        let theory = self.precision.theory;
        let (samples, error) = if self.counts_tests() {
            ("balls", "tests of a ray")
        } else {
            ("samples", "error of a pixel")
        };
        let mut words = format!("{samples:>9}{error:>18}{:>9}", "theory");
        if self.points[0].blocks.is_some() {
            let _ = write!(words, "{:>20}", "mean of 16 pixels");
        }
        let _ = writeln!(words, "{:>18}", "seconds");
        for point in &self.points {
            let (samples, error) = (point.samples, in_words(&point.errors));
            let theory = text::rounded(point.theory, 3);
            let _ = write!(words, "{samples:>9}{error:>18}{theory:>9}");
            if let Some(blocks) = &point.blocks {
                let _ = write!(words, "{:>20}", in_words(blocks));
            }
            let Median { low, value, high } = point.seconds;
            let seconds = RoundedInterval::within(value, low, high).to_string();
            let _ = writeln!(words, "{seconds:>18}");
        }
        let (name, formula) = (&theory.name, &theory.formula);
        let _ = writeln!(
            words,
            "± is half of the interval of 95 %. Theory, {name}: {formula}"
        );
        for sentence in self.sentences() {
            words.extend([&*sentence, "\n"]);
        }
        words.extend(earlier.and_then(|earlier| self.since(earlier)));
        words.extend(["Not seen here: ", &theory.unseen, "\n"]);
        words
    }

    /// What the errors say about the program.
    fn sentences(&self) -> Vec<String> {
        let fact = self.precision.fact;
        let is_linear = self.precision.axis == Axis::Linear;
        let parameter = |point: &Point| {
            let samples = f64::from(point.samples);
            // A straight line over the samples is one over the logarithm of this.
            if is_linear {
                libm::exp(samples)
            } else {
                samples
            }
        };
        let Some(slope) = self.fit(|point| [parameter(point), point.errors.rms]) else {
            return Vec::new();
        };
        let over = if self.counts_tests() {
            "balls"
        } else {
            "samples"
        };
        let theory = text::number(fact.value);
        let mut sentences = vec![format!(
            "slope over {over} {}; theory: {theory}",
            sure(slope)
        )];
        let seconds = |point: &Point| point.seconds.value;
        if self.counts_tests() {
            if let Some(of_time) = self.fit(|point| [parameter(point), seconds(point)]) {
                let [tests, time] = [slope, of_time].map(|fit| libm::pow(10.0, fit.slope));
                sentences.push(format!(
                    "Ten times as many balls take {tests:.1} times the tests, and {time:.1} times the time, in which \
                     the tree is built, too."
                ));
            }
        } else {
            let of_program = self.fit(|point| [seconds(point), point.errors.rms]);
            let of_theory = self.fit(|point| [seconds(point), point.theory]);
            let takes_time = match &*self.points {
                [first, .., last] => seconds(last) > 2.0 * seconds(first),
                _ => false,
            };
            sentences.push(match (of_program, of_theory) {
                (Some(of_program), Some(of_theory)) if takes_time => format!(
                    "slope over seconds {}; theory, with your seconds: {:.2}",
                    sure(of_program),
                    of_theory.slope
                ),
                _ => "All take about the same time: most of it starts the program, and writes the picture."
                    .to_owned(),
            });
        }
        let off = slope.slope - fact.value;
        let how = if off.abs() <= slope.half_width.max(fact.within) {
            "as theory says"
        } else if off > 0.0 {
            "more slowly than theory says"
        } else {
            "faster than theory says"
        };
        sentences.push(match slope.slope {
            _ if self.counts_tests() => {
                format!("The tests grow {}.", how.replace("more slowly", "faster"))
            }
            _ if is_linear => format!(
                "The error falls {how}: each further ray leaves {:.2} of it.",
                libm::exp(slope.slope)
            ),
            ..-0.1 => format!(
                "The error falls {how}: half of it takes {:.1} times the samples.",
                libm::pow(2.0, -1.0 / slope.slope)
            ),
            _ => "The error does not fall: more samples bring nothing.".to_owned(),
        });
        sentences.extend(self.shared(&slope));
        sentences
    }

    /// What pixels have in common, if it is more than chance and the rounding to bytes. The means of blocks of independent
    /// pixels have a quarter of their error; a common error stays.
    fn shared(&self, slope: &Fit) -> Option<String> {
        let is_shared = |point: &Point, factor: f64| {
            let by_chance = factor * point.errors.interval.high / SIDE as f64;
            let most = libm::hypot(by_chance, HALF_GREY_LEVEL);
            let blocks = point.blocks.as_ref();
            blocks.is_some_and(|blocks| blocks.interval.low > most)
        };
        let [first, .., last] = &*self.points else {
            return None;
        };
        // With few samples noise is greater than most shifts.
        if is_shared(first, 2.0) && slope.slope < self.precision.fact.value / 2.0 {
            return Some(
                "Neighbouring pixels have the same error: has each pixel random numbers of its own?"
                    .to_owned(),
            );
        }
        if !is_shared(last, 1.0) {
            return None;
        }
        let of_block = last.blocks.as_ref().map_or(0.0, |blocks| blocks.rms);
        let pixels = (SIDE * SIDE) as f64;
        let squared =
            (pixels * of_block * of_block - last.errors.rms * last.errors.rms) / (pixels - 1.0);
        Some(format!(
            "An error of {} stays, however many samples: the mean is wrong, as by a shift or a clamp.",
            text::rounded(squared.max(0.0).sqrt(), 2)
        ))
    }

    /// What has changed since an earlier report.
    fn since(&self, earlier: &Earlier) -> Option<String> {
        let last = self.points.last()?;
        let before = earlier.iter().find(|point| point.samples == last.samples)?;
        let [error, seconds] = [
            last.errors.rms / before.error,
            last.seconds.value / before.seconds,
        ];
        let noun = if self.counts_tests() {
            "tests"
        } else {
            "error"
        };
        Some(format!(
            "Since your last report: {error:.2} times the {noun}, and {seconds:.2} times the seconds, in the last row.\n"
        ))
    }

    /// The line through the logarithms of pairs of numbers.
    fn fit(&self, pair: impl Fn(&Point) -> [f64; 2]) -> Option<Fit> {
        let point = |point: &Point| {
            let [x, y] = pair(point);
            experiment::Point {
                parameter: x,
                work: x,
                errors: Errors::of([y]),
                times: Times::of(|| ()),
            }
        };
        Curve::new("", self.points.iter().map(point)).fit(experiment::Axis::Work)
    }

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
fn lines(earlier: &[Earlier], place: impl Fn(&super::history::Point) -> [f64; 2]) -> Vec<Line> {
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

fn sure(fit: Fit) -> RoundedInterval {
    RoundedInterval::around(fit.slope, fit.half_width)
}

fn in_words(errors: &Errors) -> String {
    let Interval { low, high } = errors.interval;
    RoundedInterval::within(errors.rms, low, high).to_string()
}

/// The means of the errors of neighbouring pixels.
fn means_of_blocks(errors: &[f64], width: usize) -> Vec<f64> {
    let height = errors.len() / width;
    let [columns, rows] = if height < SIDE {
        [SIDE * SIDE, 1]
    } else {
        [SIDE, SIDE]
    };
    let mut means = Vec::new();
    for top in 0..height / rows {
        for left in 0..width / columns {
            let mut sum = 0.0;
            for y in top * rows..(top + 1) * rows {
                let from = y * width + left * columns;
                sum += errors[from..from + columns].iter().sum::<f64>();
            }
            means.push(sum / (columns * rows) as f64);
        }
    }
    means
}
