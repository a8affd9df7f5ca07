//! Error against time, as a diagram of work and precision: small enough to stand beside others.
//!
//! Where the parameter changes the problem, each value has a panel of its own, with the same axes. (E. R.
//! Tufte, Envisioning Information, 1990, on small multiples)

use common::svg::{Svg, color};

use super::axis::{AxisLabel, LogAxis};
use crate::experiment::{Axis, Curve, Curves, Interval, Point, Unit};
use crate::front::{Front, compact_power};
use crate::report::Measured;

/// The width of a diagram with one panel, two of which stand side by side in the book, and of one
/// with a row of them.
const NARROW: f64 = 366.0;
const WIDE: f64 = 740.0;

/// The most panels in a row.
const COLUMNS: usize = 6;

/// The left side of the first panel, and the gaps between panels.
const LEFT: f64 = 50.0;
const GAP: f64 = 9.0;
const ROW_GAP: f64 = 26.0;

/// The width of the names beside the panels.
const NAMES: f64 = 178.0;

/// The upper side of the first panel, and the heights of panels.
const TOP: f64 = 74.0;
const HEIGHT: f64 = 150.0;
const HEIGHT_OF_ONE: f64 = 178.0;

/// The height below the panels: numbers, the name of the axis, the source.
const BELOW: f64 = 48.0;

/// The strip for errors of 0, below the broken axis.
const STRIP: f64 = 20.0;

/// The height of a name.
const NAME: f64 = 17.0;

/// The width of a letter of the title.
const LETTERS_OF_WIDTH: f64 = 8.0;

/// The width of a small letter.
const LETTERS_OF_SMALL: f64 = 6.2;

/// The least distance of two numbers of the horizontal axis.
const BETWEEN_NUMBERS: f64 = 30.0;

/// A point of a panel.
struct Mark {
    curve: usize,
    x: f64,
    x_ends: Interval,
    y: f64,
    y_ends: Interval,
}

/// A diagram for a value of the parameter, or for all of them.
struct Panel {
    heading: String,
    marks: Vec<Mark>,
    /// The points that no method beats, as x and y.
    front: Vec<[f64; 2]>,
    /// Whether a line joins the points of a curve.
    has_curves: bool,
}

/// The words of a diagram.
struct Words {
    title: String,
    below_title: String,
    x: String,
    y: String,
}

/// A unit of time, in seconds.
struct TimeUnit {
    name: &'static str,
    seconds: f64,
}

const TIME_UNITS: [TimeUnit; 4] = [
    TimeUnit {
        name: "s",
        seconds: 1.0,
    },
    TimeUnit {
        name: "ms",
        seconds: 1e-3,
    },
    TimeUnit {
        name: "µs",
        seconds: 1e-6,
    },
    TimeUnit {
        name: "ns",
        seconds: 1e-9,
    },
];

/// The diagram of an experiment. With the one of the opposite mistake, it has the fractions of
/// both mistakes as its axes.
pub fn diagram(measured: &Measured, opposite: Option<&Measured>) -> String {
    match opposite {
        Some(opposite) => of_mistakes(measured, opposite),
        None => of_time(measured),
    }
}

fn of_time(measured: &Measured) -> String {
    let e = &measured.experiment;
    let unit = time_unit(measured);
    let fronts = measured.fronts(None);
    let mut panels = Vec::new();
    match &fronts[..] {
        [] => panels.push(whole(measured, &[], unit)),
        [front] if front.parameter.is_none() && e.unit != Unit::Fraction => {
            panels.push(whole(measured, std::slice::from_ref(front), unit));
        }
        fronts => {
            for front in fronts {
                panels.push(of_front(front, unit));
            }
        }
    }
    let task = match size_of_task(measured) {
        Some(work) => format!(" for {} {}", compact_power(work), e.work),
        None => String::new(),
    };
    let words = Words {
        title: e.question.to_owned(),
        below_title: match (e.against, e.unit) {
            (Axis::Parameter, Unit::Fraction) => "worst case".to_owned(),
            (Axis::Parameter, _) if e.curves_are == Curves::Methods => e.parameter.to_owned(),
            _ => String::new(),
        },
        x: format!("processor time{task} ({})", unit.name),
        y: format!("{} ({})", e.error, e.unit),
    };
    draw(&words, &panels, &measured.curves)
}

/// All points in one panel.
fn whole(measured: &Measured, fronts: &[Front], unit: &TimeUnit) -> Panel {
    let mut panel = Panel {
        heading: String::new(),
        marks: Vec::new(),
        front: Vec::new(),
        has_curves: true,
    };
    for (curve, of) in measured.curves.iter().enumerate() {
        for point in &of.points {
            let time = point.times.seconds;
            panel.marks.push(Mark {
                curve,
                x: time.value / unit.seconds,
                x_ends: Interval {
                    low: time.low / unit.seconds,
                    high: time.high / unit.seconds,
                },
                y: point.errors.rms,
                y_ends: point.errors.interval,
            });
        }
    }
    for front in fronts {
        for one in &front.unbeaten {
            panel.front.push([one.time.value / unit.seconds, one.error]);
        }
    }
    panel
}

/// The methods for one value of the parameter.
fn of_front(front: &Front, unit: &TimeUnit) -> Panel {
    let mut panel = Panel {
        heading: front.parameter.map(compact_power).unwrap_or_default(),
        marks: Vec::new(),
        front: Vec::new(),
        has_curves: false,
    };
    for one in &front.contenders {
        panel.marks.push(Mark {
            curve: one.curve,
            x: one.time.value / unit.seconds,
            x_ends: Interval {
                low: one.time.low / unit.seconds,
                high: one.time.high / unit.seconds,
            },
            y: one.error,
            y_ends: one.interval,
        });
    }
    for one in &front.unbeaten {
        panel.front.push([one.time.value / unit.seconds, one.error]);
    }
    panel
}

/// The greatest fractions of two opposite mistakes.
fn of_mistakes(measured: &Measured, opposite: &Measured) -> String {
    let mut panel = Panel {
        heading: String::new(),
        marks: Vec::new(),
        front: Vec::new(),
        has_curves: false,
    };
    let greatest = |curve: &Curve| {
        let points = curve.points.iter();
        let greatest = points.max_by(|a, b| a.errors.rms.total_cmp(&b.errors.rms));
        greatest.map(|point| point.errors)
    };
    for (index, curve) in measured.curves.iter().enumerate() {
        let other = opposite.curve(curve.method).and_then(greatest);
        if let (Some(x), Some(y)) = (greatest(curve), other) {
            panel.marks.push(Mark {
                curve: index,
                x: x.rms,
                x_ends: x.interval,
                y: y.rms,
                y_ends: y.interval,
            });
        }
    }
    let (e, other) = (&measured.experiment, &opposite.experiment);
    let words = Words {
        title: e.question.to_owned(),
        below_title: String::new(),
        x: e.error.to_owned(),
        y: other.error.to_owned(),
    };
    draw(&words, &[panel], &measured.curves)
}

/// The greatest unit in which no time is below 1; else nanoseconds.
fn time_unit(measured: &Measured) -> &'static TimeUnit {
    let points = measured.curves.iter().flat_map(|curve| &curve.points);
    let least = points.map(|point| point.times.seconds.value);
    let least = least.fold(f64::INFINITY, f64::min);
    let is_enough = |unit: &&TimeUnit| least >= unit.seconds;
    TIME_UNITS.iter().find(is_enough).unwrap_or(&TIME_UNITS[3])
}

/// The work of all points, if it is the same.
fn size_of_task(measured: &Measured) -> Option<f64> {
    let mut points = measured.curves.iter().flat_map(|curve| &curve.points);
    let work = points.next()?.work;
    points
        .all(|point: &Point| point.work == work)
        .then_some(work)
}

/// A diagram that is being drawn.
struct Drawing {
    svg: Svg,
    x: LogAxis,
    y: LogAxis,
    has_zero: [bool; 2],
    size: [f64; 2],
}

fn draw(words: &Words, panels: &[Panel], curves: &[Curve]) -> String {
    // As equal rows as possible.
    let rows = panels.len().div_ceil(COLUMNS).max(1);
    let columns = panels.len().div_ceil(rows).max(1);
    let width = if panels.len() > 2 { WIDE } else { NARROW };
    let panel_height = if rows > 1 { HEIGHT } else { HEIGHT_OF_ONE };
    let gaps = GAP * (columns - 1) as f64;
    let panel_width = (width - LEFT - NAMES - gaps) / columns as f64;
    let row_height = panel_height + ROW_GAP;
    let bottom = TOP + row_height * rows as f64 - ROW_GAP;

    let (mut along, mut up) = (Vec::new(), Vec::new());
    let mut has_zero = [false; 2];
    for mark in panels.iter().flat_map(|panel| &panel.marks) {
        for (axis, number, numbers) in [(0, mark.x, &mut along), (1, mark.y, &mut up)] {
            if number == 0.0 {
                has_zero[axis] = true;
            } else if number.is_finite() {
                numbers.push(number);
            }
        }
    }
    let strip = |has_zero: bool| if has_zero { STRIP } else { 0.0 };
    let mut drawing = Drawing {
        svg: Svg::new([width, bottom + BELOW], &words.title),
        x: LogAxis::new(&along, strip(has_zero[0]), panel_width),
        y: LogAxis::new(&up, panel_height - strip(has_zero[1]), 0.0),
        has_zero,
        size: [panel_width, panel_height],
    };
    let letters = width / LETTERS_OF_WIDTH;
    for (n, line) in lines(&words.title, letters).iter().enumerate() {
        drawing
            .svg
            .text("bold", [8.0, 19.0 + 16.0 * n as f64], line);
    }
    let svg = &mut drawing.svg;
    svg.text("small", [8.0, TOP - 23.0], &words.y);
    svg.text("small end", [width - 8.0, TOP - 23.0], &words.below_title);
    // In the middle of the panels, unless that is too near to the left.
    let middle = LEFT + f64::midpoint(panel_width * columns as f64, gaps);
    let half = words.x.chars().count() as f64 * LETTERS_OF_SMALL / 2.0;
    svg.text(
        "small middle",
        [middle.max(8.0 + half), bottom + 36.0],
        &words.x,
    );
    for (n, panel) in panels.iter().enumerate() {
        let (row, column) = (n / columns, n % columns);
        let corner = [
            LEFT + (panel_width + GAP) * column as f64,
            TOP + row_height * row as f64,
        ];
        let is_last = n + columns >= panels.len();
        drawing.draw_panel(panel, curves.len(), corner, column == 0, is_last);
    }
    drawing.draw_names(panels, curves, width - NAMES, bottom);
    drawing.svg.finish()
}

impl Drawing {
    /// The place of a point in a panel. A number of 0 lies in the strip.
    fn at(&self, [left, top]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
        let x = if x == 0.0 { STRIP / 2.0 } else { self.x.at(x) };
        let y = if y == 0.0 {
            self.size[1] - STRIP / 2.0
        } else {
            self.y.at(y)
        };
        [left + x, top + y]
    }

    fn draw_panel(
        &mut self,
        panel: &Panel,
        curves: usize,
        corner: [f64; 2],
        is_first: bool,
        is_last: bool,
    ) {
        self.draw_axes(corner, is_first, is_last);
        let [left, top] = corner;
        let heading = [left + self.size[0] / 2.0, top - 6.0];
        self.svg.text("small middle", heading, &panel.heading);
        let front: Vec<_> = panel
            .front
            .iter()
            .map(|point| self.at(corner, *point))
            .collect();
        match front[..] {
            // One point alone: a short line.
            [[x, y]] => self.svg.line("front", &[[x - 5.0, y], [x + 5.0, y]]),
            _ => self.svg.line("front", &front),
        }
        for curve in 0..curves {
            let of_curve = panel.marks.iter().filter(|mark| mark.curve == curve);
            let of_curve: Vec<_> = of_curve.filter(|mark| mark.y.is_finite()).collect();
            if panel.has_curves {
                let class = format!("curve {}", color(curve));
                let line: Vec<_> = of_curve
                    .iter()
                    .map(|mark| self.at(corner, [mark.x, mark.y]))
                    .collect();
                self.svg.line(&class, &line);
            }
            for mark in of_curve {
                let earlier = panel.marks.iter().take_while(|other| other.curve < curve);
                let at_the_same_place =
                    earlier.filter(|other| other.x == mark.x && other.y == mark.y);
                // Side by side, so that all are seen.
                let aside = 9.0 * at_the_same_place.count() as f64;
                self.draw_mark(mark, corner, aside);
            }
        }
    }

    fn draw_mark(&mut self, mark: &Mark, corner: [f64; 2], aside: f64) {
        let [x, y] = self.at(corner, [mark.x, mark.y]);
        let class = color(mark.curve);
        let Interval { low, high } = mark.x_ends;
        if mark.x > 0.0 && low > 0.0 {
            let ends = [low, high].map(|end| self.at(corner, [end, mark.y]));
            self.svg.line(&class, &ends);
        }
        let Interval { low, high } = mark.y_ends;
        if mark.y > 0.0 && self.y.holds(low) && self.y.holds(high) {
            let ends = [low, high].map(|end| self.at(corner, [mark.x, end]));
            self.svg.line(&class, &ends);
        }
        self.svg.mark(mark.curve, [x + aside, y]);
    }

    fn draw_axes(&mut self, [left, top]: [f64; 2], is_first: bool, is_last: bool) {
        let [width, height] = self.size;
        let (right, bottom) = (left + width, top + height);
        let svg = &mut self.svg;
        let mut last = f64::INFINITY;
        for AxisLabel { number, text } in self.y.labels() {
            let y = top + self.y.at(number);
            svg.line("grid", &[[left, y], [right, y]]);
            // From below: those too near to the last one have no room.
            if is_first && (last - y) > 13.0 {
                svg.text("small end", [left - 5.0, y + 4.0], &text);
                last = y;
            }
        }
        let mut last = if self.has_zero[0] {
            left + STRIP / 2.0
        } else {
            f64::NEG_INFINITY
        };
        for AxisLabel { number, text } in self.x.labels() {
            let x = left + self.x.at(number);
            svg.line("grid", &[[x, top], [x, bottom]]);
            if is_last && x - last > BETWEEN_NUMBERS {
                svg.text("small middle", [x, bottom + 15.0], &text);
                last = x;
            }
        }
        svg.line("", &[[left, top], [left, bottom]]);
        svg.line("", &[[left, bottom], [right, bottom]]);
        if self.has_zero[1] {
            let y = bottom - STRIP / 2.0;
            svg.line("grid", &[[left, y], [right, y]]);
            if is_first {
                svg.text("small end", [left - 5.0, y + 4.0], "0");
            }
            svg.line(
                "",
                &[
                    [left - 4.0, bottom - STRIP + 2.0],
                    [left + 4.0, bottom - STRIP - 2.0],
                ],
            );
        }
        if self.has_zero[0] {
            let x = left + STRIP / 2.0;
            svg.line("grid", &[[x, top], [x, bottom]]);
            if is_last {
                svg.text("small middle", [x, bottom + 15.0], "0");
            }
            svg.line(
                "",
                &[
                    [left + STRIP - 2.0, bottom + 4.0],
                    [left + STRIP + 2.0, bottom - 4.0],
                ],
            );
        }
    }

    /// The names of the methods beside the last panel, each as near to its last point as the others
    /// allow, and that of the front.
    fn draw_names(&mut self, panels: &[Panel], curves: &[Curve], left: f64, bottom: f64) {
        let top = bottom - self.size[1];
        let mut names = Vec::new();
        for (curve, of) in curves.iter().enumerate() {
            let mut all = panels.iter().flat_map(|panel| &panel.marks);
            let Some(last) = all.rfind(|mark| mark.curve == curve && mark.y.is_finite()) else {
                continue;
            };
            let [_, y] = self.at([0.0, top], [last.x, last.y]);
            names.push((y, Some(curve), of.method));
        }
        if let Some([x, y]) = panels.last().and_then(|panel| panel.front.last()) {
            let [_, y] = self.at([0.0, top], [*x, *y]);
            names.push((y, None, "Pareto front"));
        }
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        // From above, each is moved below the one before it; then those that are too low, upwards.
        let mut least = TOP;
        for name in &mut names {
            name.0 = name.0.max(least);
            least = name.0 + NAME;
        }
        let mut most = bottom;
        for (y, curve, method) in names.into_iter().rev() {
            let y = y.min(most);
            most = y - NAME;
            match curve {
                Some(curve) => self.svg.mark(curve, [left + 14.0, y]),
                None => self.svg.line("front", &[[left + 8.0, y], [left + 20.0, y]]),
            }
            self.svg.text("small", [left + 26.0, y + 4.0], method);
        }
    }
}

/// A title in lines of at most this number of letters.
fn lines(title: &str, letters: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in title.split(' ') {
        let Some(line) = lines.last_mut() else { break };
        let length = line.chars().count() + 1 + word.chars().count();
        if line.is_empty() {
            word.clone_into(line);
        } else if (length as f64) < letters {
            *line = format!("{line} {word}");
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}
