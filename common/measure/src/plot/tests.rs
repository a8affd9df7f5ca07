use super::*;
use common::Median;

use crate::example::{curve, experiment};
use crate::experiment::{Experiment, Unit};
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
    for text in ["processor time (s)", "class=\"front\"", ">not beaten<"] {
        assert!(
            time.contains(text) && !work.contains(text),
            "{text}: {time}"
        );
    }
    assert!(!time.contains("slope") && work.contains("class=\"fit c0\""));
    let plots = plots_of(Unit::Other("radii"), &[&falling]);
    assert!(!plots[0].contains("1/510"));
}
