//! `Diagram`: marks on logarithmic axes, as SVG.
//!
//! The names of the curves stand beside the plot, in the order of the curves' ends, so that they
//! cover no data (W. S. Cleveland, The Elements of Graphing Data, 1985).

use common::svg::{Svg, color};

use super::axis::{AxisLabel, LogAxis};
use crate::experiment::Interval;

/// Width and height of a plot, two of which stand side by side in the book, and of a wide one.
const NARROW: [f64; 2] = [138.0, 178.0];
const WIDE: [f64; 2] = [512.0, 300.0];

/// The margins of the plot: at the left, with the numbers; above, with the title; at the right, with the
/// names; and below, with the numbers and the name of the axis.
const LEFT: f64 = 50.0;
const TOP: f64 = 74.0;
const NAMES: f64 = 178.0;
const BELOW: f64 = 48.0;

/// The strip for numbers of 0, before the broken axis.
const STRIP: f64 = 20.0;

/// The height of a name.
const NAME: f64 = 17.0;

/// The width of a letter of the title, and of a small letter.
const LETTER: f64 = 8.0;
const SMALL_LETTER: f64 = 6.2;

/// The least distances of two numbers of the axes.
const BETWEEN_NUMBERS: [f64; 2] = [30.0, 13.0];

/// A plot, and the words around it.
pub struct Diagram {
    /// The words above it.
    pub title: String,
    /// Words above the right end of the plot.
    pub remark: String,
    /// The name of the horizontal axis.
    pub x: String,
    /// The name of the vertical axis.
    pub y: String,
    /// Whether it is as wide as the page, or half as wide.
    pub is_wide: bool,
    /// Whether a line joins the marks of a curve.
    pub has_curves: bool,
    /// What is measured.
    pub marks: Vec<Mark>,
    /// What is drawn behind the marks, to compare with.
    pub lines: Vec<Line>,
}

/// A point, with its interval in both directions.
pub struct Mark {
    /// The number of its curve.
    pub curve: usize,
    /// The horizontal coordinate.
    pub x: f64,
    /// Its interval.
    pub x_ends: Interval,
    /// The vertical coordinate.
    pub y: f64,
    /// Its interval.
    pub y_ends: Interval,
}

/// A thin line through points without marks.
pub struct Line {
    /// Its name; none if another line has it.
    pub name: Option<String>,
    /// The number of the curve whose colour it has; of none it is dashed.
    pub curve: Option<usize>,
    /// Its points, whose coordinates are positive.
    pub points: Vec<[f64; 2]>,
}

impl Line {
    fn class(&self) -> String {
        self.curve.map_or("estimate".to_owned(), color)
    }
}

/// A plot that is being drawn.
struct Drawing {
    svg: Svg,
    x: LogAxis,
    y: LogAxis,
    /// Whether there is a strip for numbers of 0 on each axis.
    has_zero: [bool; 2],
    right: f64,
    bottom: f64,
}

impl Diagram {
    /// The diagram as SVG, with these names of the curves.
    pub fn draw(mut self, curves: &[&str]) -> String {
        self.marks
            .retain(|mark| mark.x.is_finite() && mark.y.is_finite());
        let [width, height] = if self.is_wide { WIDE } else { NARROW };
        let (right, bottom) = (LEFT + width, TOP + height);
        let has_zero = [
            self.marks.iter().any(|mark| mark.x == 0.0),
            self.marks.iter().any(|mark| mark.y == 0.0),
        ];
        let [before, below] = has_zero.map(|has_zero| if has_zero { STRIP } else { 0.0 });
        let of_lines: Vec<_> = self.lines.iter().flat_map(|line| &line.points).collect();
        let numbers = |of: fn(&Mark) -> f64, axis: usize| -> Vec<f64> {
            let numbers = self.marks.iter().map(of);
            let of_lines = of_lines.iter().map(|point| point[axis]);
            let all = numbers.chain(of_lines);
            all.filter(|number| *number != 0.0).collect()
        };
        let mut drawing = Drawing {
            svg: Svg::new([right + NAMES, bottom + BELOW], &self.title),
            x: LogAxis::new(&numbers(|mark| mark.x, 0), LEFT + before, right),
            y: LogAxis::new(&numbers(|mark| mark.y, 1), bottom - below, TOP),
            has_zero,
            right,
            bottom,
        };
        self.draw_words(&mut drawing);
        drawing.draw_axes();
        for line in &self.lines {
            let points: Vec<_> = line
                .points
                .iter()
                .map(|[x, y]| drawing.at(*x, *y))
                .collect();
            drawing.svg.line(&line.class(), &points);
        }
        for curve in 0..curves.len() {
            self.draw_curve(&mut drawing, curve);
        }
        self.draw_names(&mut drawing, curves);
        drawing.svg.finish()
    }

    fn draw_words(&self, drawing: &mut Drawing) {
        let Drawing {
            svg, right, bottom, ..
        } = drawing;
        let end = *right + NAMES - 8.0;
        for (n, line) in lines(&self.title, end / LETTER).iter().enumerate() {
            svg.text("bold", [8.0, 19.0 + 16.0 * n as f64], line);
        }
        svg.text("small", [8.0, TOP - 23.0], &self.y);
        svg.text("small end", [end, TOP - 23.0], &self.remark);
        // In the middle of the plot, unless that is too near to the left.
        let half = self.x.chars().count() as f64 * SMALL_LETTER / 2.0;
        let middle = f64::midpoint(LEFT, *right).max(8.0 + half);
        svg.text("small middle", [middle, *bottom + 36.0], &self.x);
    }

    fn draw_curve(&self, drawing: &mut Drawing, curve: usize) {
        let of_curve = self.marks.iter().filter(|mark| mark.curve == curve);
        let of_curve: Vec<_> = of_curve.collect();
        if self.has_curves {
            // No line leads to an error of 0, which lies infinitely far below.
            let parts = of_curve.split(|mark| mark.y == 0.0);
            for part in parts.filter(|part| !part.is_empty()) {
                let line: Vec<_> = part.iter().map(|mark| drawing.at(mark.x, mark.y)).collect();
                drawing.svg.line(&format!("curve {}", color(curve)), &line);
            }
        }
        for mark in of_curve {
            drawing.draw_mark(mark);
        }
    }

    /// The names of the curves and lines, each as near to its last point as the others allow.
    fn draw_names(&self, drawing: &mut Drawing, curves: &[&str]) {
        let mut names = Vec::new();
        for (curve, name) in curves.iter().enumerate() {
            if let Some(last) = self.marks.iter().rfind(|mark| mark.curve == curve) {
                let [_, y] = drawing.at(last.x, last.y);
                names.push((y, Key::Mark(curve), *name));
            }
        }
        for line in &self.lines {
            if let (Some(name), Some([x, y])) = (&line.name, line.points.last()) {
                let [_, y] = drawing.at(*x, *y);
                names.push((y, Key::Line(line.class()), name));
            }
        }
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        // From above, each is moved below the one before it; then those that are too low, upwards.
        let mut least = TOP;
        for name in &mut names {
            name.0 = name.0.max(least);
            least = name.0 + NAME;
        }
        let (mut most, left) = (drawing.bottom, drawing.right);
        for (y, key, name) in names.into_iter().rev() {
            let y = y.min(most);
            most = y - NAME;
            match key {
                Key::Mark(curve) => drawing.svg.mark(curve, [left + 14.0, y]),
                Key::Line(class) => {
                    let ends = [[left + 5.0, y], [left + 23.0, y]];
                    drawing.svg.line(&class, &ends);
                }
            }
            drawing.svg.text("small", [left + 26.0, y + 4.0], name);
        }
    }
}

/// What stands before a name.
enum Key {
    /// The mark of a curve.
    Mark(usize),
    /// A piece of a line of this class.
    Line(String),
}

impl Drawing {
    /// The place of a point. A number of 0 lies in the strip.
    fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let middle = STRIP / 2.0;
        [
            if x == 0.0 {
                LEFT + middle
            } else {
                self.x.at(x)
            },
            if y == 0.0 {
                self.bottom - middle
            } else {
                self.y.at(y)
            },
        ]
    }

    fn draw_mark(&mut self, mark: &Mark) {
        let class = color(mark.curve);
        let Interval { low, high } = mark.x_ends;
        if mark.x > 0.0 && 0.0 < low && low < high {
            let right = self.right;
            let ends = [low, high].map(|end| {
                let [x, y] = self.at(end, mark.y);
                [x.clamp(LEFT, right), y]
            });
            self.svg.line(&class, &ends);
        }
        let Interval { low, high } = mark.y_ends;
        if mark.y > 0.0 && 0.0 < low && low < high {
            let bottom = self.bottom;
            let ends = [low, high].map(|end| {
                let [x, y] = self.at(mark.x, end);
                [x, y.clamp(TOP, bottom)]
            });
            self.svg.line(&class, &ends);
        }
        self.svg.mark(mark.curve, self.at(mark.x, mark.y));
    }

    fn draw_axes(&mut self) {
        let Self {
            svg, right, bottom, ..
        } = self;
        let (right, bottom) = (*right, *bottom);
        let [between_x, between_y] = BETWEEN_NUMBERS;
        let mut last = f64::INFINITY;
        for AxisLabel { number, text } in self.y.labels() {
            let y = self.y.at(number);
            svg.line("grid", &[[LEFT, y], [right, y]]);
            // From below: those too near to the last one have no room.
            if last - y > between_y {
                svg.text("small end", [LEFT - 5.0, y + 4.0], &text);
                last = y;
            }
        }
        let mut last = if self.has_zero[0] {
            LEFT
        } else {
            f64::NEG_INFINITY
        };
        for AxisLabel { number, text } in self.x.labels() {
            let x = self.x.at(number);
            svg.line("grid", &[[x, TOP], [x, bottom]]);
            if x - last > between_x {
                svg.text("small middle", [x, bottom + 15.0], &text);
                last = x;
            }
        }
        svg.line("", &[[LEFT, TOP], [LEFT, bottom]]);
        svg.line("", &[[LEFT, bottom], [right, bottom]]);
        // A stroke across the axis: here it is broken.
        if self.has_zero[1] {
            let (y, end) = (bottom - STRIP / 2.0, bottom - STRIP);
            svg.line("grid", &[[LEFT, y], [right, y]]);
            svg.text("small end", [LEFT - 5.0, y + 4.0], "0");
            svg.line("", &[[LEFT - 4.0, end + 2.0], [LEFT + 4.0, end - 2.0]]);
        }
        if self.has_zero[0] {
            let (x, end) = (LEFT + STRIP / 2.0, LEFT + STRIP);
            svg.line("grid", &[[x, TOP], [x, bottom]]);
            svg.text("small middle", [x, bottom + 15.0], "0");
            svg.line("", &[[end - 2.0, bottom + 4.0], [end + 2.0, bottom - 4.0]]);
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
