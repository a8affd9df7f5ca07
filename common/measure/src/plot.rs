//! Log-log plots of error against work and against time, as SVG.
//!
//! The names of the curves stand beside the plot, in the order of the curves' ends, so
//! that they cover no data (E. R. Tufte, The Visual Display of Quantitative Information,
//! 1983; W. S. Cleveland, The Elements of Graphing Data, 1985).

mod axis;
mod precision;
mod series;

use common::svg::{Svg, color};

use crate::experiment::{Axis, HALF_GREY_LEVEL};
use crate::report::Measured;

use axis::{AxisLabel, LogAxis};
use series::{LimitPoint, Series, SeriesPoint};

/// The size of the picture, and the sides of the plot in it, in pixels.
const SIZE: [f64; 2] = [780.0, 468.0];
const LEFT: f64 = 70.0;
const RIGHT: f64 = 566.0;
const TOP: f64 = 88.0;
const BOTTOM: f64 = 400.0;

/// Height of the strip below the axis for errors of 0.
const STRIP: f64 = 34.0;

/// Where errors of 0 lie in this strip.
const ZERO: f64 = BOTTOM - 10.0;

/// Height of a label beside the plot, with its remark.
const LABEL: f64 = 31.0;

/// The rounding of numbers near 1, at which curves become level.
const ROUNDING: f64 = f64::EPSILON;

/// A plot as a file.
pub struct Plot {
    /// The ending of its name, behind those of stage and experiment.
    pub ending: &'static str,
    /// The text of the file.
    pub svg: String,
}

/// The plots of an experiment: error against counted work or the parameter, and error against time
/// with the fronts; or against the opposite mistake, if there is one.
pub fn plots(measured: &Measured, opposite: Option<&Measured>) -> [Plot; 2] {
    [
        Plot {
            ending: ".svg",
            svg: draw(measured),
        },
        Plot {
            ending: "-time.svg",
            svg: precision::diagram(measured, opposite),
        },
    ]
}

/// Draws error against counted work or the parameter.
fn draw(measured: &Measured) -> String {
    let experiment = &measured.experiment;
    let label = match experiment.against {
        Axis::Work => experiment.work,
        Axis::Parameter => experiment.parameter,
    };
    let series = series::by_work(measured);
    let visible = experiment
        .can_be_seen(&measured.curves)
        .then_some(HALF_GREY_LEVEL);
    let mut drawing = Drawing::new(experiment.question, &series, visible);
    let error = format!("{} ({})", experiment.error, experiment.unit);
    let svg = &mut drawing.svg;
    svg.text("title", [14.0, 28.0], experiment.question);
    svg.text("small", [14.0, 47.0], experiment.exact);
    svg.text("", [14.0, TOP - 15.0], &error);
    svg.text("middle", [f64::midpoint(LEFT, RIGHT), BOTTOM + 40.0], label);
    drawing.draw_axes();
    if let Some(level) = visible {
        drawing.draw_level(level, "half a grey level", "1/510");
    }
    if drawing.y.holds(ROUNDING) {
        drawing.draw_level(ROUNDING, "rounding of 1", "2⁻⁵²");
    }
    for (index, one) in series.iter().enumerate() {
        let mut earlier = series[..index].iter();
        if earlier.all(|other| other.limit != one.limit) {
            drawing.draw_limit(one.name, &one.limit);
        }
        drawing.draw_curve(index, one);
    }
    drawing.draw_labels();
    drawing.svg.finish()
}

/// A plot that is being drawn.
struct Drawing<'a> {
    svg: Svg,
    x: LogAxis,
    y: LogAxis,
    /// The lower end of the vertical axis, above the strip for errors of 0 if there are any.
    bottom: f64,
    labels: Vec<Label<'a>>,
}

/// A name beside the plot.
struct Label<'a> {
    /// The height at which it should stand.
    height: f64,
    name: &'a str,
    remark: &'a str,
    /// The class of its line.
    class: String,
    /// The number of its curve, which has a mark.
    curve: Option<usize>,
}

impl<'a> Drawing<'a> {
    /// An empty plot, whose axes hold all points and the level below which errors are not seen.
    fn new(title: &str, series: &[Series], visible: Option<f64>) -> Self {
        let (mut along, mut up) = (Vec::new(), Vec::new());
        let mut has_zeros = false;
        for point in series.iter().flat_map(|one| &one.points) {
            along.push(point.x);
            if point.error == 0.0 {
                has_zeros = true;
            } else {
                up.push(point.error);
            }
        }
        up.extend(visible);
        for limit in series.iter().flat_map(|one| &one.limit) {
            up.push(limit.error);
        }
        let bottom = if has_zeros { BOTTOM - STRIP } else { BOTTOM };
        Self {
            svg: Svg::new(SIZE, title),
            x: LogAxis::new(&along, LEFT, RIGHT),
            y: LogAxis::new(&up, bottom, TOP),
            bottom,
            labels: Vec::new(),
        }
    }

    fn draw_axes(&mut self) {
        let (svg, bottom) = (&mut self.svg, self.bottom);
        for AxisLabel { number, text } in self.y.labels() {
            let y = self.y.at(number);
            svg.line("grid", &[[LEFT, y], [RIGHT, y]]);
            svg.text("end", [LEFT - 8.0, y + 4.5], &text);
        }
        for AxisLabel { number, text } in self.x.labels() {
            let x = self.x.at(number);
            svg.line("grid", &[[x, TOP], [x, bottom]]);
            svg.text("middle", [x, BOTTOM + 19.0], &text);
        }
        svg.line("", &[[LEFT, TOP], [LEFT, bottom]]);
        svg.line("", &[[LEFT, BOTTOM], [RIGHT, BOTTOM]]);
        if bottom < BOTTOM {
            svg.line("grid", &[[LEFT, ZERO], [RIGHT, ZERO]]);
            svg.text("end", [LEFT - 8.0, ZERO + 4.5], "0");
            // Two strokes: here the axis is broken.
            for y in [bottom, bottom + 5.0] {
                svg.line("", &[[LEFT - 5.0, y + 3.0], [LEFT + 5.0, y - 3.0]]);
            }
        }
    }

    /// The height of an error. One of 0 lies in the strip below the axis.
    fn height(&self, error: f64) -> f64 {
        if error == 0.0 { ZERO } else { self.y.at(error) }
    }

    /// A level line at an error.
    fn draw_level(&mut self, error: f64, name: &'a str, remark: &'a str) {
        let y = self.y.at(error);
        self.svg.line("level", &[[LEFT, y], [RIGHT, y]]);
        self.labels.push(Label {
            height: y,
            name,
            remark,
            class: "level".to_owned(),
            curve: None,
        });
    }

    /// The errors that the problem itself has, with the method's name.
    fn draw_limit(&mut self, method: &'a str, limit: &[LimitPoint]) {
        let mut line = Vec::new();
        for point in limit {
            line.push([self.x.at(point.x), self.y.at(point.error)]);
        }
        if let Some([_, end]) = line.last() {
            self.svg.line("level", &line);
            self.labels.push(Label {
                height: *end,
                name: "condition · ulp",
                remark: method,
                class: "level".to_owned(),
                curve: None,
            });
        }
    }

    /// A method: a line through its points, and each point with its mark and its interval.
    fn draw_curve(&mut self, index: usize, series: &'a Series) {
        let class = format!("curve {}", color(index));
        // No line leads to an error of 0, which lies infinitely far below.
        for part in series.points.split(|point| point.error == 0.0) {
            let mut line = Vec::new();
            for point in part {
                line.push([self.x.at(point.x), self.height(point.error)]);
            }
            self.svg.line(&class, &line);
        }
        if let Some(ends) = series.fitted {
            let line = ends.map(|end| [self.x.at(end.x), self.y.at(end.error)]);
            self.svg.line(&format!("fit {}", color(index)), &line);
        }
        let mut last: Option<&SeriesPoint> = None;
        for point in &series.points {
            let y = self.height(point.error);
            self.svg.mark(index, [self.x.at(point.x), y]);
            if last.is_none_or(|last| point.x >= last.x) {
                last = Some(point);
            }
        }
        let is_exact = last.is_some() && series.points.iter().all(|point| point.error == 0.0);
        self.labels.push(Label {
            height: last.map_or(self.bottom, |last| self.height(last.error)),
            name: series.name,
            remark: if is_exact { "no error" } else { &series.remark },
            class,
            curve: Some(index),
        });
    }

    /// Draws the labels beside the plot, each as near to its height as the others allow.
    fn draw_labels(&mut self) {
        let mut labels = std::mem::take(&mut self.labels);
        labels.sort_by(|a, b| a.height.total_cmp(&b.height));
        // From above, each is moved below the one before it; then those that are too low, upwards.
        let mut least = TOP;
        for label in &mut labels {
            label.height = label.height.max(least);
            least = label.height + LABEL;
        }
        let mut most = BOTTOM;
        for label in labels.into_iter().rev() {
            let y = label.height.min(most);
            most = y - LABEL;
            let svg = &mut self.svg;
            svg.line(&label.class, &[[RIGHT + 12.0, y], [RIGHT + 34.0, y]]);
            if let Some(index) = label.curve {
                svg.mark(index, [RIGHT + 23.0, y]);
            }
            svg.text("", [RIGHT + 41.0, y + 4.5], label.name);
            svg.text("small", [RIGHT + 41.0, y + 18.0], label.remark);
        }
    }
}

#[cfg(test)]
mod tests;
