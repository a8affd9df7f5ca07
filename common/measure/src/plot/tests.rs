use super::*;
use common::Median;

use crate::example::{curve, experiment};
use crate::experiment::{Errors, Experiment, Unit};
use crate::provenance::Provenance;

/// The plots of curves with these points: work, and error. The times are the works.
fn plots_of(unit: Unit<'static>, curves: &[&[(f64, f64)]]) -> [String; 2] {
    let experiment = Experiment {
        unit,
        ..experiment()
    };
    let mut curves: Vec<_> = curves.iter().map(|points| curve(points)).collect();
    for curve in &mut curves {
        for point in &mut curve.points {
            point.times.seconds = Median::of(vec![point.work; 6]);
        }
    }
    let measured = Measured {
        experiment,
        curves,
        provenance: Provenance::here(6),
    };
    plots(&measured, None).map(|plot| plot.svg)
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
    let [work, time] = &plots_of(Unit::Light, &[&falling, &other]);
    assert_eq!(marks(work), 3 + 2 + 2);
    let labels = ["one over", "rms error (white = 1)", "steps", "1/510", ">0<"];
    for text in ["a &lt; b", "slope −1.000 ± 0.000"].iter().chain(&labels) {
        assert!(work.contains(text), "{text}: {work}");
    }
    for text in ["processor time (s)", "class=\"front\"", ">Pareto front<"] {
        assert!(
            time.contains(text) && !work.contains(text),
            "{text}: {time}"
        );
    }
    assert!(!time.contains("slope") && work.contains("class=\"fit c0\""));
    let plots = plots_of(Unit::Other("radii"), &[&falling]);
    assert!(!plots[0].contains("1/510"));
}

/// Three problems have a panel each: a mark for each method in it, and one beside each name.
#[test]
fn each_problem_has_a_panel() {
    let exact = [(1.0, 1e-9), (10.0, 1e-9), (100.0, 1e-9)];
    let falling = [(1.0, 0.5), (10.0, 0.05), (100.0, 0.0)];
    let experiment = Experiment {
        against: Axis::Parameter,
        unit: Unit::Other("radii"),
        ..experiment()
    };
    let mut measured = Measured {
        experiment,
        curves: vec![curve(&exact), curve(&falling)],
        provenance: Provenance::here(6),
    };
    for curve in &mut measured.curves {
        for point in &mut curve.points {
            point.times.seconds = Median::of(vec![1e-3; 6]);
        }
    }
    let [_, time] = plots(&measured, None).map(|plot| plot.svg);
    assert_eq!(marks(&time), 3 + 3 + 2);
    for text in [
        ">1<",
        ">10<",
        ">100<",
        "processor time (ms)",
        "rms error (radii)",
        ">0<",
    ] {
        assert!(time.contains(text), "{text}: {time}");
    }
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
            provenance: Provenance::here(6),
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
