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

const EVERYWHERE: (f64, f64) = (0.0, f64::INFINITY);

#[test]
fn the_mean_and_the_greatest_error_are_computed() {
    let point = Point::new(1.0, 1.0, [3.0, -4.0, 0.0, 0.0], || 0.0);
    assert_eq!((point.rms, point.max), (2.5, 4.0));
}

#[test]
fn the_slope_of_a_power_is_its_exponent() {
    let points: Vec<_> = [1.0, 4.0, 16.0, 64.0, 256.0]
        .map(|n: f64| (n, 0.3 / n.sqrt()))
        .into();
    let slope = curve(&points).fitted_slope(Axis::Work, EVERYWHERE).unwrap();
    assert!((slope + 0.5).abs() < 1e-12, "{slope}");
    let bent = [&[(0.1, 7.0)], points.as_slice(), &[(1e4, 0.3 / 16.0)]].concat();
    let slope = curve(&bent).fitted_slope(Axis::Work, (1.0, 256.0)).unwrap();
    assert!((slope + 0.5).abs() < 1e-12, "{slope}");
}

#[test]
fn a_single_point_and_points_without_error_have_no_slope() {
    assert_eq!(
        curve(&[(1.0, 1.0)]).fitted_slope(Axis::Work, EVERYWHERE),
        None
    );
    let exact = curve(&[(1.0, 0.0), (2.0, 0.0)]);
    assert_eq!(exact.fitted_slope(Axis::Work, EVERYWHERE), None);
}

#[test]
fn the_work_to_reach_an_error_is_read_off_the_curve() {
    let halving = curve(&[(1.0, 0.8), (4.0, 0.4), (16.0, 0.2)]);
    assert_eq!(halving.work_to_reach(1.0), Some((1.0, false)));
    let (work, beyond) = halving.work_to_reach(0.4).unwrap();
    assert!((work - 4.0).abs() < 1e-9 && !beyond);
    let (work, beyond) = halving.work_to_reach(0.1).unwrap();
    assert!((work - 64.0).abs() < 1e-9 && beyond);
    assert_eq!(curve(&[(1.0, 0.5), (9.0, 0.5)]).work_to_reach(0.1), None);
}

#[test]
fn the_front_has_the_points_that_no_other_beats() {
    let a = curve(&[(1.0, 0.5), (4.0, 0.3)]);
    let b = curve(&[(2.0, 0.6), (4.0, 0.2)]);
    let front = pareto_front(&[a, b]);
    assert_eq!(front, [[true, false], [false, true]]);
}

/// Three points that are not on one line: the errors 10^-1, 10^-1 and 10^-4 at 10,
/// 100 and 1000 have the slope -3/2 by least squares.
#[test]
fn the_slope_is_fitted_by_least_squares() {
    let points = curve(&[(10.0, 1e-1), (100.0, 1e-1), (1000.0, 1e-4)]);
    let slope = points.fitted_slope(Axis::Work, EVERYWHERE).unwrap();
    assert!((slope + 1.5).abs() < 1e-12, "{slope}");
}

/// The error falls with the work, from point to point.
#[test]
fn between_two_points_the_work_lies_on_the_line_through_both() {
    let bent = curve(&[(1.0, 1.0), (4.0, 0.25), (400.0, 0.0025)]);
    let (work, beyond) = bent.work_to_reach(0.025).unwrap();
    assert!((work - 40.0).abs() < 1e-9 && !beyond, "{work}");
    let (work, _) = bent.work_to_reach(0.5).unwrap();
    assert!((work - 2.0).abs() < 1e-9, "{work}");
}

/// A point with the same error and the same work does not beat another; a smaller
/// error or less work does.
#[test]
fn equals_do_not_beat_each_other() {
    let a = curve(&[(1.0, 0.5), (2.0, 0.25), (4.0, 0.125)]);
    let b = curve(&[(1.0, 0.5), (2.0, 0.5), (8.0, 0.125)]);
    let front = pareto_front(&[a, b]);
    assert_eq!(front, [[true, true, true], [true, false, false]]);
}

fn of_slope(expected: f64, tolerance: f64) -> Experiment<'static> {
    let curves = move |_| {
        let slope = Slope {
            expected,
            tolerance,
            between: EVERYWHERE,
        };
        vec![Curve {
            slope: Some(slope),
            ..curve(&[(1.0, 1.0), (2.0, 0.5), (4.0, 0.25)])
        }]
    };
    Experiment {
        name: "halving",
        about: "",
        knob: "",
        work: "",
        error: "",
        against: Axis::Work,
        curves: Box::new(curves),
    }
}

#[test]
fn slopes_near_the_expected_ones_pass() {
    let near = [of_slope(-1.0, 0.01), of_slope(-1.5, 0.6)];
    check_slopes(&near, Effort::Quick);
}

#[test]
#[should_panic(expected = "halving: method: Some(-1")]
fn other_slopes_fail() {
    check_slopes(&[of_slope(-1.5, 0.4)], Effort::Quick);
}

#[test]
#[should_panic(expected = "no experiments")]
fn a_stage_without_experiments_fails() {
    check_slopes(&[], Effort::Quick);
}

#[test]
fn points_without_error_do_not_bend_the_slope_of_the_others() {
    let points = curve(&[(1.0, 1.0), (10.0, 0.1), (100.0, 0.0)]);
    let slope = points.fitted_slope(Axis::Work, EVERYWHERE).unwrap();
    assert!((slope + 1.0).abs() < 1e-12, "{slope}");
}

#[test]
fn an_error_that_the_last_point_reaches_is_not_extrapolated() {
    let halving = curve(&[(1.0, 0.8), (4.0, 0.4), (16.0, 0.2)]);
    let (work, beyond) = halving.work_to_reach(0.2).unwrap();
    assert!((work - 16.0).abs() < 1e-9 && !beyond);
}

#[test]
fn each_point_is_a_line_with_its_counted_work() {
    let lines = counted(&of_slope(-1.0, 0.0), Effort::Quick);
    let line = |n: f64, error: &str| format!("{:24} {n:>12} {n:>14} {error:>9}", "method");
    let expected = [
        "halving ( counted)".to_owned(),
        line(1.0, "1.0e0"),
        line(2.0, "5.0e-1"),
        line(4.0, "2.5e-1"),
    ];
    assert_eq!(lines, expected.join("\n"));
}
