use common::Median;

use super::*;
use crate::example::{curve, experiment};
use crate::experiment::{Errors, Experiment, Unit};

/// The plots of curves with these points: work, and error. The times are the works.
fn plots_of(experiment: Experiment<'static>, curves: &[&[(f64, f64)]]) -> [String; 2] {
    let mut curves: Vec<_> = curves.iter().map(|points| curve(points)).collect();
    for curve in &mut curves {
        for point in &mut curve.points {
            point.times.seconds = Median::of(vec![point.work; 6]);
        }
    }
    plots(&Measured { experiment, curves }, None).map(|plot| plot.svg)
}

fn marks(svg: &str) -> usize {
    svg.matches("class=\"mark ").count()
}

/// Each point has a mark, and each curve another beside its name; errors that are no
/// numbers have none.
#[test]
fn every_point_is_shown() {
    let falling = [(1.0, 0.5), (10.0, 0.05), (100.0, 0.005)];
    let other = [(1.0, f64::NAN), (10.0, 0.5), (100.0, 0.0)];
    let [work, time] = &plots_of(experiment(), &[&falling, &other]);
    for svg in [work, time] {
        assert_eq!(marks(svg), 3 + 2 + 2);
        for text in ["one over", "rms error (white = 1)", "a &lt; b", ">0<"] {
            assert!(svg.contains(text), "{text}: {svg}");
        }
    }
    let (of_work, of_time) = (">steps<", "processor time (s)");
    assert!(work.contains(of_work) && !work.contains(of_time));
    assert!(time.contains(of_time) && !time.contains(of_work));
}

/// The fractions of both mistakes are the axes.
#[test]
fn opposite_mistakes_are_one_plot() {
    let of = |error, fraction| {
        let mut all = curve(&[(1.0, 0.0)]);
        all.points[0].errors = Errors::fraction(fraction, 100);
        Measured {
            experiment: Experiment {
                unit: Unit::Fraction,
                error,
                ..experiment()
            },
            curves: vec![all],
        }
    };
    let (acne, leaks) = (of("fraction of acne", 0.25), of("fraction of leaks", 0.0));
    let [_, both] = plots(&acne, Some(&leaks)).map(|plot| plot.svg);
    assert!(both.contains("fraction of acne") && both.contains("fraction of leaks"));
    assert!(
        !both.contains("processor time") && marks(&both) == 2,
        "{both}"
    );
}
