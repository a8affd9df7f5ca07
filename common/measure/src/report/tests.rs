use super::*;
use crate::example::{curve, experiment};
use crate::experiment::{Axis, Errors, Times, Unit};

/// Three points are measured in nine rounds.
#[test]
fn the_table_shows_the_slope() {
    let mut steps = Vec::new();
    let progress = |done, all| steps.push((done, all));
    let table = Measured::new(experiment(), 9, progress).table(None);
    assert!(steps.into_iter().eq((0..=27).map(|done| (done, 27))));
    let summary = "  a < b: slope -0.500 ± 0.001 (theory -0.5)\n";
    assert!(table.contains(summary), "{table}");
}

/// Two curves whose first points have the same parameter, with invented times: the
/// second quotients are 1, 5/4 and 3/4.
fn measured(experiment: Experiment<'static>) -> Measured<'static> {
    let median = |low, value, high| Median { low, value, high };
    let times = |seconds, over_first| {
        let mut times = Times::of(|| ());
        (times.seconds, times.over_first) = (seconds, over_first);
        times
    };
    let mut first = curve(&[(10.0, 0.5), (20.0, 0.25)]);
    first.points[0].times = times(median(0.002, 0.002, 0.003), None);
    first.points[1].times = times(median(0.004, 0.004, 0.006), None);
    let mut other = curve(&[(10.0, 0.1), (20.0, 0.5), (30.0, 0.5)]);
    other.method = "clever, new";
    let all = [
        times(median(0.001, 0.001, 0.001), Some(median(0.5, 0.5, 0.5))),
        times(median(0.003, 0.004, 0.005), Some(median(0.75, 1.0, 1.25))),
        times(median(3.0, 3.0, 4.5), None),
    ];
    for (point, times) in other.points.iter_mut().zip(all) {
        point.times = times;
    }
    Measured {
        experiment,
        curves: vec![first, other],
    }
}

#[test]
fn slopes_and_fronts_are_computed_from_errors_and_times() {
    let rows = "\
square-root: Is the error one over the square root?
  rms error (white = 1), against 0
  ± is half of the interval of 95 %, which for a time holds in this run; max is of 1 inputs: with 95 %, at most 95 % of all inputs have a greater error
  method                              n          steps             error       max             time  time / first method
  a < b                              10             10  (5.00 ± 0.01)e-1    5.0e-1     2.0ms ± 50 %
  a < b                              20             20  (2.50 ± 0.01)e-1    2.5e-1     4.0ms ± 50 %
* clever, new                        10             10  (1.00 ± 0.01)e-1    1.0e-1      1.0ms ± 0 %  0.50 (0.50-0.50)
  clever, new                        20             20  (5.00 ± 0.01)e-1    5.0e-1     4.0ms ± 25 %  no difference beyond 34 %
  clever, new                        30             30  (5.00 ± 0.01)e-1    5.0e-1      3.0s ± 50 %
";
    let table = measured(experiment()).table(None);
    assert!(table.starts_with(rows), "{table}");
    let remarks = "  \
  clever, new: no power law: less than a decade
  Pareto front of error and time, on this machine: clever, new
";
    assert!(table.ends_with(remarks), "{table}");
    // Where the parameter changes the problem, each value has its front.
    let of_problems = measured(Experiment {
        against: Axis::Parameter,
        ..experiment()
    });
    let front = of_problems.front(None);
    let front: Vec<_> = front.iter().map(|one| (one.parameter, one.curve)).collect();
    assert_eq!(front, [(10.0, 1), (20.0, 0), (30.0, 1)]);
    // Problems do not compete: no star, no front.
    let problems = measured(Experiment {
        curves_are: Curves::Problems,
        ..experiment()
    });
    let table = problems.table(None);
    let remarks = ["* clever", "Pareto front"];
    assert!(remarks.iter().all(|remark| !table.contains(remark)));
}

/// A method with one mistake everywhere is useless, how few of the opposite it may make.
#[test]
fn opposite_mistakes_have_one_front() {
    let decisions = |name, opposite, fractions: [f64; 2]| {
        let mut curves = Vec::new();
        for (method, fraction) in ["reckless", "careful"].into_iter().zip(fractions) {
            let mut curve = curve(&[(1.0, 0.0)]);
            curve.method = method;
            curve.points[0].errors = Errors::fraction(fraction, 1000);
            curve.points[0].times.seconds = Median::of(vec![1.0; 9]);
            curves.push(curve);
        }
        Measured {
            experiment: Experiment {
                unit: Unit::Fraction,
                opposite: Some(opposite),
                ..Experiment::new(name)
            },
            curves,
        }
    };
    let all = [
        decisions("acne", "leaks", [0.0, 0.0]),
        decisions("leaks", "acne", [1.0, 0.0]),
    ];
    assert!(all[0].table(None).contains("see report acne leaks"));
    for measured in &all {
        let front = measured.front(opposite_of(measured, &all));
        assert_eq!(measured.names_of(&front), "careful");
    }
}

#[test]
fn csv_has_all_digits_below_its_origin_and_is_written_with_plots() {
    let folder = tempfile::tempdir().unwrap();
    let paths = measured(experiment()).write(folder.path(), "a00", None);
    let paths = paths.unwrap();
    let names = [".csv", ".svg", "-time.svg"].map(|ending| format!("a00-square-root{ending}"));
    assert!(paths.iter().eq(&names.map(|name| folder.path().join(name))));

    let csv = std::fs::read_to_string(&paths[0]).unwrap();
    for origin in ["# machine: ", "\n# version: ", "against 0; seeds 3 4\n"] {
        assert!(csv.contains(origin), "{origin}: {csv}");
    }
    let table = "
experiment,method,parameter,work,unit,error,error low,error high,seconds,seconds low,seconds high,slope,slope low,slope high
square-root,\"a < b\",10,10,\"white = 1\",5e-1,5.000e-1,5.000e-1,2.000e-3,2.000e-3,3.000e-3,,,
square-root,\"a < b\",20,20,\"white = 1\",2.5e-1,2.500e-1,2.500e-1,4.000e-3,4.000e-3,6.000e-3,,,
square-root,\"clever, new\",10,10,\"white = 1\",1e-1,1.000e-1,1.000e-1,1.000e-3,1.000e-3,1.000e-3,,,
square-root,\"clever, new\",20,20,\"white = 1\",5e-1,5.000e-1,5.000e-1,4.000e-3,3.000e-3,5.000e-3,,,
square-root,\"clever, new\",30,30,\"white = 1\",5e-1,5.000e-1,5.000e-1,3.000e0,3.000e0,4.500e0,,,
";
    assert!(csv.ends_with(table), "{csv}");
}

#[test]
fn no_number_of_a_report_has_more_than_17_digits() {
    let points = [10, 30, 68].map(|power| {
        let work = libm::pow(10.0, f64::from(power));
        (work, libm::pow(work, -1.0 / 25.0))
    });
    let experiment = Experiment {
        work: "steps",
        curves: Box::new(move || vec![curve(&points)]),
        ..Experiment::new("name\u{1B}[2J")
    };
    let measured = Measured::new(experiment, 9, |_, _| ());
    let named = Named {
        name: measured.experiment.name.to_owned(),
        measured: &measured,
    };
    let csv = csv(&[], &[named]);
    for text in [measured.table(None), csv.clone()] {
        let mut digits = text.split(|letter: char| !letter.is_ascii_digit());
        assert!(digits.all(|digits| digits.len() <= 17), "{text}");
    }
    assert!(!csv.contains('\u{1B}'));
}

#[test]
fn times_have_the_unit_with_few_digits() {
    let shown = [12e-9, 3.44e-5, 0.25, 2.0].map(table::duration);
    assert_eq!(shown, ["12.0ns", "34.4µs", "250.0ms", "2.0s"]);
}
