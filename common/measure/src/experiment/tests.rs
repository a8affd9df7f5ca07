use super::*;

fn curve(points: &[(f64, f64)]) -> Curve<'static> {
    let point = |&(work, error): &(f64, f64)| Point::new(work, work, [error], || 0.0);
    Curve {
        method: "method",
        remark: "",
        slope: None,
        points: points.iter().map(point).collect(),
    }
}

fn of_slope(expected: f64, tolerance: f64) -> Experiment<'static> {
    let curves = move |_| {
        let slope = Slope {
            expected,
            tolerance,
            between: (0.0, f64::INFINITY),
        };
        vec![Curve {
            slope: Some(slope),
            ..curve(&[(1.0, 1.0), (4.0, 0.25), (16.0, 0.0625)])
        }]
    };
    Experiment {
        name: "halving",
        about: "",
        knob: "",
        work: "",
        error: "",
        unit: Unit::Light,
        exact: "",
        seeds: &[],
        against: Axis::Work,
        curves: Box::new(curves),
    }
}

#[test]
fn the_mean_and_the_greatest_error_are_computed() {
    let point = Point::new(1.0, 1.0, [3.0, -4.0, 0.0, 0.0], || 0.0);
    assert_eq!((point.rms, point.max), (2.5, 4.0));
}

/// A point with the same error and the same work does not beat another; a smaller
/// error or less work does, unless it is an estimate.
#[test]
fn the_front_has_the_points_that_no_other_beats() {
    let a = curve(&[(1.0, 0.5), (2.0, 0.25), (4.0, 0.125)]);
    let b = curve(&[(1.0, 0.5), (2.0, 0.5), (8.0, 0.125)]);
    let mut guessed = curve(&[]);
    guessed.points = vec![Point::estimate(1.0, 1.0, 0.01, || 0.0)];
    let front = pareto_front(&[a, b, guessed]);
    assert_eq!(front[..2], [[true, true, true], [true, false, false]]);
    assert_eq!(front[2], [false]);
}

#[test]
fn half_a_grey_level_is_a_mark_for_light_that_more_work_improves() {
    let mut experiment = of_slope(-1.0, 0.0);
    let (falling, rising) = (
        curve(&[(1.0, 0.5), (9.0, 0.1)]),
        curve(&[(1.0, 0.1), (9.0, 0.5)]),
    );
    assert!(experiment.can_be_seen(&[falling]));
    assert!(!experiment.can_be_seen(&[rising]));
    experiment.unit = Unit::Other("radii");
    assert!(!experiment.can_be_seen(&[curve(&[(1.0, 0.5), (9.0, 0.1)])]));
}

#[test]
fn slopes_near_the_expected_ones_pass() {
    let near = [of_slope(-1.0, 0.01), of_slope(-1.5, 0.6)];
    check_slopes(&near, Effort::Quick);
}

#[test]
#[should_panic(expected = "halving: method: Some")]
fn other_slopes_fail() {
    check_slopes(&[of_slope(-1.5, 0.4)], Effort::Quick);
}

/// Shares have a largest value, and so no slope.
#[test]
#[should_panic(expected = "halving: method: None")]
fn shares_have_no_slope() {
    let mut shares = of_slope(-1.0, 0.1);
    shares.unit = Unit::Share;
    check_slopes(&[shares], Effort::Quick);
}

#[test]
fn each_point_is_a_line_with_its_counted_work() {
    let lines = counted(&of_slope(-1.0, 0.0), Effort::Quick);
    let line = |n: f64, error: &str| format!("{:24} {n:>12} {n:>14} {error:>9}", "method");
    let expected = [
        "halving ( counted)".to_owned(),
        line(1.0, "1.0e0"),
        line(4.0, "2.5e-1"),
        line(16.0, "6.2e-2"),
    ];
    assert_eq!(lines, expected.join("\n"));
}
