//! Log-log plots of error against work and against time, as SVG.
//!
//! The names of the curves stand beside the plot, in the order of the curves' ends, so
//! that they cover no data (E. R. Tufte, The Visual Display of Quantitative Information,
//! 1983; W. S. Cleveland, The Elements of Graphing Data, 1985).

mod axis;

use common::Median;
use common::svg::{Svg, color};

use crate::experiment::{Axis, HALF_GREY_LEVEL};
use crate::provenance;
use crate::report::Measured;

use axis::LogAxis;

/// The size of the picture, and the sides of the plot in it, in pixels.
const SIZE: [f64; 2] = [780.0, 468.0];
const LEFT: f64 = 70.0;
const RIGHT: f64 = 566.0;
const TOP: f64 = 88.0;
const BOTTOM: f64 = 400.0;

/// Height of the strip below the axis for errors of 0.
const STRIP: f64 = 34.0;

/// Height of a name beside the plot, with its remark.
const NAME: f64 = 31.0;

/// The rounding of numbers near 1, at which curves become level.
const ROUNDING: f64 = f64::EPSILON;

/// A curve of a plot.
struct Series<'a> {
    name: &'a str,
    /// A remark beside the plot, the slope for example.
    remark: String,
    /// The points: the ends of an interval with the middle between them, and the error.
    points: Vec<([f64; 3], f64)>,
    /// The errors of the problem at the same places, where its condition is known.
    limit: Vec<(f64, f64)>,
}

/// The plots of an experiment, each with the suffix of its file name: error against counted work
/// or the parameter, and error against time with the front, of the points that can be compared.
pub fn plots(measured: &Measured) -> [(&'static str, String); 2] {
    let experiment = measured.experiment;
    let label = match experiment.against {
        Axis::Work => experiment.work,
        Axis::Parameter => experiment.parameter,
    };
    let [(_, machine), (_, version)] = provenance::lines();
    let source = format!("medians, with intervals of 95 %; {machine}; {version}");
    let front = measured.front().into_iter();
    let front: Vec<_> = front.map(|(_, error, time)| (time.value, error)).collect();
    let [by_work, by_time] = [false, true].map(|is_timed| series(measured, is_timed));
    let by_time = draw(measured, "time (seconds)", &source, &by_time, &front);
    [
        (".svg", draw(measured, label, "", &by_work, &[])),
        ("-time.svg", by_time),
    ]
}

/// The curves against time, or against work or parameter.
fn series<'a>(measured: &Measured<'_, 'a>, is_timed: bool) -> Vec<Series<'a>> {
    let experiment = measured.experiment;
    let curves = measured.curves.iter().enumerate().map(|(c, curve)| {
        let points: Vec<_> = if is_timed {
            let timed = |(p, error)| {
                let Median { low, value, high } = measured.time(c, p);
                ([low, value, high], error)
            };
            measured.compared(curve).into_iter().map(timed).collect()
        } else {
            let points = curve.points.iter();
            points
                .map(|p| ([p.on(experiment.against); 3], p.rms))
                .collect()
        };
        let points = points.into_iter();
        let points = points.filter(|(x, error)| x[0] > 0.0 && error.is_finite());
        let limit = curve.points.iter();
        let limit = limit.filter_map(|p| Some((p.on(experiment.against), p.problem?.error)));
        let fit = experiment.fit(curve);
        let fit = fit.filter(|fit| !is_timed && fit.is_power_law());
        Series {
            name: curve.method,
            remark: fit.map_or(String::new(), |fit| fit.slope_in_words().replace('-', "−")),
            points: points.collect(),
            limit: limit.filter(|_| !is_timed).collect(),
        }
    });
    curves
        .filter(|one| !is_timed || !one.points.is_empty())
        .collect()
}

fn draw(
    measured: &Measured,
    label: &str,
    source: &str,
    all: &[Series],
    front: &[(f64, f64)],
) -> String {
    let experiment = measured.experiment;
    let points = || all.iter().flat_map(|one| &one.points);
    let has_zeros = points().any(|(_, error)| *error == 0.0);
    let is_seen = experiment.can_be_seen(&measured.curves);
    let level = is_seen.then_some(HALF_GREY_LEVEL);
    let bottom = if has_zeros { BOTTOM - STRIP } else { BOTTOM };
    let errors = points().map(|(_, error)| *error);
    let errors = errors.filter(|error| *error > 0.0);
    let limits = all
        .iter()
        .flat_map(|one| &one.limit)
        .map(|(_, limit)| *limit);
    let y = LogAxis::new(errors.chain(level).chain(limits), (bottom, TOP));
    let x = LogAxis::new(points().flat_map(|(x, _)| *x), (LEFT, RIGHT));

    let mut svg = Svg::new(SIZE, experiment.about);
    svg.text("title", [14.0, 28.0], experiment.about);
    svg.text("small", [14.0, 47.0], experiment.exact);
    let error = format!("{} ({})", experiment.error, experiment.unit);
    svg.text("", [14.0, TOP - 15.0], &error);
    svg.text("middle", [f64::midpoint(LEFT, RIGHT), BOTTOM + 40.0], label);
    svg.text("small", [14.0, SIZE[1] - 8.0], source);
    draw_axes(&mut svg, &x, &y, bottom);

    let zero = BOTTOM - 10.0;
    let height = |error: f64| if error == 0.0 { zero } else { y.at(error) };
    if has_zeros {
        svg.line("grid", &[[LEFT, zero], [RIGHT, zero]]);
        svg.text("end", [LEFT - 8.0, zero + 4.5], "0");
        // Two strokes: here the axis is broken.
        for at in [bottom, bottom + 5.0] {
            svg.line("", &[[LEFT - 5.0, at + 3.0], [LEFT + 5.0, at - 3.0]]);
        }
    }
    let mut names = Vec::new();
    let shown = front.iter().filter(|(_, error)| y.holds(*error));
    let steps: Vec<_> = shown
        .map(|(time, error)| [x.at(*time), y.at(*error)])
        .collect();
    if let [_, .., [_, end]] = steps[..] {
        svg.line("front", &steps);
        names.push((
            end,
            "the front",
            "no method beats it",
            "front".to_owned(),
            None,
        ));
    }
    let rounding = Some(ROUNDING).filter(|rounding| y.holds(*rounding));
    let half = level.map(|level| (level, "half a grey level", "1/510"));
    let rounding = rounding.map(|level| (level, "rounding of 1", "2⁻⁵²"));
    for (level, name, remark) in half.into_iter().chain(rounding) {
        svg.line("level", &[[LEFT, y.at(level)], [RIGHT, y.at(level)]]);
        names.push((y.at(level), name, remark, "level".to_owned(), None));
    }
    for (index, one) in all.iter().enumerate() {
        let is_new = all[..index].iter().all(|other| other.limit != one.limit);
        if let Some((_, last)) = one.limit.last().filter(|_| is_new) {
            let at = one
                .limit
                .iter()
                .map(|(place, limit)| [x.at(*place), y.at(*limit)]);
            svg.line("level", &at.collect::<Vec<_>>());
            let (name, class) = ("condition · ulp", "level".to_owned());
            names.push((y.at(*last), name, one.name, class, None));
        }
        let class = format!("curve {}", color(index));
        let at = |(x_of, error): &([f64; 3], f64)| [x.at(x_of[1]), height(*error)];
        // No line leads to an error of 0, which lies infinitely far below.
        for part in one.points.split(|(_, error)| *error == 0.0) {
            let part: Vec<_> = part.iter().map(at).collect();
            svg.line(&class, &part);
        }
        for point in &one.points {
            let [low, _, high] = point.0.map(|number| x.at(number));
            svg.line(&color(index), &[[low, at(point)[1]], [high, at(point)[1]]]);
            svg.mark(index, at(point));
        }
        let last = one.points.iter().max_by(|a, b| a.0[1].total_cmp(&b.0[1]));
        let is_exact = last.is_some() && one.points.iter().all(|(_, error)| *error == 0.0);
        let remark = if is_exact { "no error" } else { &one.remark };
        let end = last.map_or(bottom, |last| at(last)[1]);
        names.push((end, one.name, remark, class, Some(index)));
    }
    draw_names(&mut svg, names);
    svg.finish()
}

fn draw_axes(svg: &mut Svg, x: &LogAxis, y: &LogAxis, bottom: f64) {
    for (number, label) in y.labels() {
        svg.line("grid", &[[LEFT, y.at(number)], [RIGHT, y.at(number)]]);
        svg.text("end", [LEFT - 8.0, y.at(number) + 4.5], &label);
    }
    for (number, label) in x.labels() {
        svg.line("grid", &[[x.at(number), TOP], [x.at(number), bottom]]);
        svg.text("middle", [x.at(number), BOTTOM + 19.0], &label);
    }
    svg.line("", &[[LEFT, TOP], [LEFT, bottom]]);
    svg.line("", &[[LEFT, BOTTOM], [RIGHT, BOTTOM]]);
}

/// A name with its height, its remark, and the class of its line; the number of its curve.
type Name<'a> = (f64, &'a str, &'a str, String, Option<usize>);

/// Draws names beside the plot, each as near to its height as the others allow.
fn draw_names(svg: &mut Svg, mut names: Vec<Name>) {
    names.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = TOP;
    for name in &mut names {
        name.0 = name.0.max(least);
        least = name.0 + NAME;
    }
    let mut most = BOTTOM;
    for (height, name, remark, class, curve) in names.into_iter().rev() {
        let at = height.min(most);
        most = at - NAME;
        svg.line(&class, &[[RIGHT + 12.0, at], [RIGHT + 34.0, at]]);
        if let Some(index) = curve {
            svg.mark(index, [RIGHT + 23.0, at]);
        }
        svg.text("", [RIGHT + 41.0, at + 4.5], name);
        svg.text("small", [RIGHT + 41.0, at + 18.0], remark);
    }
}

#[cfg(test)]
mod tests;
