//! Log-log plots of error against work, as SVG for light and dark pages.

use common::Error;
use plotters::coord::combinators::IntoLogRange;
use plotters::prelude::*;

use crate::experiment::{Axis, Curve};
use crate::report::Measured;

/// Colours of a page.
struct Page {
    name: &'static str,
    paper: RGBColor,
    ink: RGBColor,
    grid: RGBColor,
    /// Colours of the curves, which colour-blind people can distinguish, too (Okabe
    /// and Ito, Color Universal Design, 2008).
    curves: [RGBColor; 7],
}

const LIGHT: Page = Page {
    name: "light",
    paper: RGBColor(255, 255, 255),
    ink: RGBColor(40, 40, 40),
    grid: RGBColor(225, 225, 225),
    curves: [
        RGBColor(0, 114, 178),
        RGBColor(213, 94, 0),
        RGBColor(0, 158, 115),
        RGBColor(204, 121, 167),
        RGBColor(86, 180, 233),
        RGBColor(160, 110, 0),
        RGBColor(60, 60, 60),
    ],
};

const DARK: Page = Page {
    name: "dark",
    paper: RGBColor(24, 26, 27),
    ink: RGBColor(225, 225, 225),
    grid: RGBColor(60, 63, 65),
    curves: [
        RGBColor(86, 180, 233),
        RGBColor(230, 159, 0),
        RGBColor(0, 190, 140),
        RGBColor(230, 150, 195),
        RGBColor(120, 150, 255),
        RGBColor(240, 228, 66),
        RGBColor(200, 200, 200),
    ],
};

/// The rounding of numbers near 1, at which curves become level.
const ROUNDING: f64 = f64::EPSILON;

/// The plots of an experiment, each with the suffix of its file name: error
/// against counted work or the parameter, and against time.
pub fn plots(measured: &Measured) -> Result<Vec<(String, String)>, Error> {
    let experiment = measured.experiment;
    let counted = match experiment.against {
        Axis::Work => experiment.work,
        Axis::Knob => experiment.knob,
    };
    let mut plots = Vec::new();
    for page in [&LIGHT, &DARK] {
        for (kind, label) in [("work", counted), ("time", "seconds")] {
            let series: Vec<_> = measured
                .curves
                .iter()
                .zip(&measured.seconds)
                .map(|(curve, seconds)| points(curve, seconds, kind, experiment.against))
                .collect();
            let mut svg = String::new();
            draw(&mut svg, page, measured, label, &series).map_err(|reason| Error::Plot {
                name: experiment.name.to_owned(),
                reason,
            })?;
            plots.push((format!("-{kind}-{}.svg", page.name), svg));
        }
    }
    Ok(plots)
}

/// The points of a curve whose coordinates have logarithms.
fn points(curve: &Curve, seconds: &[f64], kind: &str, axis: Axis) -> Vec<(f64, f64)> {
    let timed = curve.points.iter().zip(seconds);
    timed
        .map(|(point, seconds)| match kind {
            "time" => (*seconds, point.rms),
            _ => (point.on(axis), point.rms),
        })
        .filter(|(x, error)| *x > 0.0 && *error > 0.0 && error.is_finite())
        .collect()
}

/// Most decades on an axis; below them, curves leave the plot.
const MOST_DECADES: f64 = 40.0;

/// The range of decades that holds all numbers, or the upper part of it.
fn decades(numbers: impl Iterator<Item = f64> + Clone) -> std::ops::Range<f64> {
    let least = numbers.clone().fold(f64::INFINITY, f64::min);
    let most = numbers.fold(0.0, f64::max);
    if least > most {
        return 0.1..1.0;
    }
    let decade = |x: f64| libm::pow(10.0, x);
    let (from, to) = (libm::log10(least).floor(), libm::log10(most).ceil());
    let to = to.max(from + 1.0);
    // Numbers have some 16 digits: more than twice as many decades show nothing.
    decade(from.max(to - MOST_DECADES))..decade(to)
}

fn draw(
    svg: &mut String,
    page: &Page,
    measured: &Measured,
    label: &str,
    series: &[Vec<(f64, f64)>],
) -> Result<(), String> {
    let explain = |error: &dyn std::fmt::Display| error.to_string();
    let root = SVGBackend::with_string(svg, (760, 480)).into_drawing_area();
    root.fill(&page.paper).map_err(|e| explain(&e))?;
    let all = || series.iter().flatten();
    let x = decades(all().map(|point| point.0));
    let y = decades(all().map(|point| point.1));
    let text = |size: i32| ("sans-serif", size).into_font().color(&page.ink);
    let mut chart = ChartBuilder::on(&root)
        .caption(measured.experiment.name, text(20))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(72)
        .build_cartesian_2d(x.clone().log_scale(), y.clone().log_scale())
        .map_err(|e| explain(&e))?;
    let power = |value: &f64| format!("1e{:.0}", libm::log10(*value));
    chart
        .configure_mesh()
        .axis_style(page.ink)
        .bold_line_style(page.grid)
        .light_line_style(TRANSPARENT)
        .label_style(text(14))
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .x_desc(label)
        .y_desc("rms error")
        .draw()
        .map_err(|e| explain(&e))?;
    let floor = LineSeries::new([(x.start, ROUNDING), (x.end, ROUNDING)], page.ink);
    if y.contains(&ROUNDING) {
        chart.draw_series(floor).map_err(|e| explain(&e))?;
    }
    for (index, (curve, points)) in measured.curves.iter().zip(series).enumerate() {
        let color = page.curves[index % page.curves.len()];
        let shown = points.iter().copied();
        let shown = shown.filter(|point| point.0 >= x.start && point.1 >= y.start);
        let line = LineSeries::new(shown, color.stroke_width(2)).point_size(3);
        let drawn = chart.draw_series(line).map_err(|e| explain(&e))?;
        drawn
            .label(curve.method)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(3)));
    }
    chart
        .configure_series_labels()
        .background_style(page.paper.mix(0.85))
        .border_style(page.grid)
        .label_font(text(13))
        .draw()
        .map_err(|e| explain(&e))?;
    root.present().map_err(|e| explain(&e))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::{Experiment, Point};

    #[test]
    fn axes_hold_whole_decades() {
        let shown = |numbers: &[f64]| {
            let decades = decades(numbers.iter().copied());
            [decades.start, decades.end].map(libm::log10)
        };
        assert_eq!(shown(&[2.0, 300.0]), [0.0, 3.0]);
        assert_eq!(shown(&[0.02, 0.03]), [-2.0, -1.0]);
        assert_eq!(shown(&[1.0]), [0.0, 1.0], "at least one");
        assert_eq!(shown(&[1e-50, 1.0]), [-40.0, 0.0], "at most forty");
        assert_eq!(shown(&[]), [-1.0, 0.0]);
    }

    /// Neither 0 nor NaN has a logarithm.
    #[test]
    fn only_points_that_have_logarithms_are_shown() {
        let point = |(work, error): (f64, f64)| Point::new(7.0, work, [error], || 0.0);
        let points_of = [
            (1.0, 0.5),
            (2.0, 0.0),
            (0.0, 0.5),
            (3.0, f64::NAN),
            (4.0, 0.25),
        ];
        let curve = Curve {
            method: "",
            remark: "",
            slope: None,
            points: points_of.map(point).into(),
        };
        let seconds = [0.1, 0.2, 0.3, 0.4, 0.0];
        let shown = |kind, axis| points(&curve, &seconds, kind, axis);
        assert_eq!(shown("work", Axis::Work), [(1.0, 0.5), (4.0, 0.25)]);
        let by_knob = [(7.0, 0.5), (7.0, 0.5), (7.0, 0.25)];
        assert_eq!(shown("work", Axis::Knob), by_knob);
        assert_eq!(shown("time", Axis::Work), [(0.1, 0.5), (0.3, 0.5)]);
    }

    /// The numbers of an attribute of every element that has this colour.
    fn numbers(svg: &str, element: &str, color: &str, attribute: &str) -> Vec<Vec<i32>> {
        let lines = svg.lines().filter(|line| {
            line.starts_with(&format!("<{element} ")) && line.contains(&format!("=\"{color}\""))
        });
        let of_line = |line: &str| {
            let (_, rest) = line.split_once(&format!(" {attribute}=\""))?;
            let (value, _) = rest.split_once('"')?;
            let numbers = value.split([',', ' ']).filter_map(|n| n.parse().ok());
            Some(numbers.collect())
        };
        lines.filter_map(of_line).collect()
    }

    /// Each point is a circle, except points below the decades shown. Each curve has
    /// its colour, and a line of 18 pixels in the legend.
    #[test]
    fn curves_have_their_points_and_colours() {
        let curve = |points: &[(f64, f64)]| Curve {
            method: "method",
            remark: "",
            slope: None,
            points: points
                .iter()
                .map(|(work, error)| Point::new(*work, *work, [*error], || 0.0))
                .collect(),
        };
        let curves = vec![
            curve(&[(1.0, 1.0), (10.0, 5.0), (100.0, 1e-60)]),
            curve(&[(1e-60, 1.0), (1.0, 5.0), (2.0, 5.0), (1e40, 1e40)]),
        ];
        let seconds = curves.iter().map(|c| vec![1.0; c.points.len()]).collect();
        let experiment = Experiment {
            name: "",
            about: "",
            knob: "",
            work: "",
            error: "",
            against: Axis::Work,
            curves: Box::new(|_| Vec::new()),
        };
        let measured = Measured {
            experiment: &experiment,
            curves,
            seconds,
        };
        let plots = plots(&measured).unwrap();
        let names: Vec<_> = plots.iter().map(|(name, _)| name.as_str()).collect();
        let expected = [
            "-work-light.svg",
            "-time-light.svg",
            "-work-dark.svg",
            "-time-dark.svg",
        ];
        assert_eq!(names, expected);
        for (color, points) in [("#0072B2", 2), ("#D55E00", 3)] {
            let svg = &plots[0].1;
            assert_eq!(numbers(svg, "circle", color, "cx").len(), points);
            let lines = numbers(svg, "polyline", color, "points");
            assert_eq!(lines[0].len(), 2 * points);
            let [from, from_y, to, to_y] = lines[1][..] else {
                panic!("{lines:?}");
            };
            assert_eq!((to - from, to_y - from_y), (18, 0));
        }
    }
}
