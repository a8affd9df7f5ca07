use super::*;
use crate::example::{curve, experiment, falling};
use crate::experiment::{Axis, Deviation, Errors, Times, Unit};

/// The errors of 1, 1/4 and 1/16 fall to 1/510 at (1/510)^-2 steps; three points are
/// measured in nine rounds.
#[test]
fn the_table_shows_slope_price_and_remark() {
    let experiment = experiment();
    let mut steps = Vec::new();
    let progress = |done, all| steps.push((done, all));
    let table = Measured::new(experiment, Effort::Quick, progress).table(None);
    assert!(steps.into_iter().eq((0..=27).map(|done| (done, 27))));
    let summary = "  a < b: slope -0.500 ± 0.000, R² 1.0000 (theory -0.5); \
                   1/510 takes 260100 steps, extrapolated";
    assert!(table.contains(summary), "{table}");
}

/// Two curves whose first points have the same parameter, with invented times: the
/// second quotients are 1, 5/4 and 3/4.
fn measured(experiment: Experiment<'static>) -> Measured<'static> {
    let median = |low, value, high| Median { low, value, high };
    let mut first = curve(&[(10.0, 0.5), (20.0, 0.25)]);
    first.points[0].times = Times::recorded(median(0.002, 0.002, 0.003), None);
    first.points[1].times = Times::recorded(median(0.004, 0.004, 0.006), None);
    let mut other = curve(&[(10.0, 0.1), (20.0, 0.5), (30.0, 0.5)]);
    other.method = "clever, new";
    let times = [
        Times::recorded(median(0.001, 0.001, 0.001), Some(median(0.5, 0.5, 0.5))),
        Times::recorded(median(0.003, 0.004, 0.005), Some(median(0.75, 1.0, 1.25))),
        Times::recorded(median(3.0, 3.0, 4.5), None),
    ];
    for (point, times) in other.points.iter_mut().zip(times) {
        point.times = times;
    }
    Measured {
        experiment,
        curves: vec![first, other],
        provenance: Provenance::here(3),
    }
}

#[test]
fn remarks_are_computed_from_errors_and_times() {
    let rows = "\
square-root: Is the error one over the square root?
  rms error (white = 1), against 0
  method                              n          steps     error      99 %       max condition       time  time / first method
  a < b                              10             10    5.0e-1              5.0e-1                2.0ms
  a < b                              20             20    2.5e-1              2.5e-1                4.0ms
* clever, new                        10             10    1.0e-1              1.0e-1                1.0ms  0.50 (0.50-0.50)
  clever, new                        20             20    5.0e-1              5.0e-1                4.0ms  no difference beyond 34 %
  clever, new                        30             30    5.0e-1              5.0e-1                 3.0s
";
    let table = measured(experiment()).table(None);
    assert!(table.starts_with(rows), "{table}");
    let remarks = "  \
  clever, new: no power law: less than a decade; beside a < b at 20: 2.00 times its error, time \
  no difference beyond 34 %
  Pareto front of error and time: clever, new (0.1)
";
    assert!(table.ends_with(remarks), "{table}");
    // Where the parameter changes the problem, each value has its front.
    let of_problems = Experiment {
        against: Axis::Parameter,
        ..experiment()
    };
    let table = measured(of_problems).table(None);
    let front = "Pareto front of error and time: a < b (at 20), clever, new (at 10 and at 30)\n";
    assert!(table.ends_with(front), "{table}");
    // Problems do not compete: no star, no front.
    let problems = measured(Experiment {
        curves_are: Curves::Problems,
        ..experiment()
    });
    let table = problems.table(None);
    let remarks = ["* clever", "Pareto front"];
    assert!(remarks.iter().all(|remark| !table.contains(remark)));
    assert_eq!(problems.row(None), None);
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
            provenance: Provenance::here(9),
        }
    };
    let all = [
        decisions("acne", "leaks", [0.0, 0.0]),
        decisions("leaks", "acne", [1.0, 0.0]),
    ];
    assert!(all[0].table(None).contains("see report acne leaks"));
    for measured in &all {
        let opposite = opposite_of(measured, &all);
        let front = measured.unbeaten(opposite);
        assert_eq!(front, "careful (no error)");
    }
}

#[test]
fn csv_has_all_digits_below_its_origin_and_is_written_with_plots() {
    let csv = measured(experiment()).csv();
    for name in ["machine", "version", "date", "seeds: 3 4", "error"] {
        assert!(csv.contains(&format!("\n# {name}")), "{name}: {csv}");
    }
    let table = "\
method,n,steps,rms error,its low,its high,99 %,max,condition,problem's error,over problem,seconds,low,high,time over first,its low,its high
a < b,10,10,5e-1,5.000e-1,5.000e-1,,5.000e-1,,,,2.000e-3,2.000e-3,3.000e-3,,,
a < b,20,20,2.5e-1,2.500e-1,2.500e-1,,2.500e-1,,,,4.000e-3,4.000e-3,6.000e-3,,,
\"clever, new\",10,10,1e-1,1.000e-1,1.000e-1,,1.000e-1,,,,1.000e-3,1.000e-3,1.000e-3,0.5000,0.5000,0.5000
\"clever, new\",20,20,5e-1,5.000e-1,5.000e-1,,5.000e-1,,,,4.000e-3,3.000e-3,5.000e-3,1.0000,0.7500,1.2500
\"clever, new\",30,30,5e-1,5.000e-1,5.000e-1,,5.000e-1,,,,3.000e0,3.000e0,4.500e0,,,
";
    assert!(csv.ends_with(table), "{csv}");

    let folder = tempfile::tempdir().unwrap();
    check_writable(&experiment(), folder.path(), "a00").unwrap();
    let paths = measured(experiment())
        .write(folder.path(), "a00", None)
        .unwrap();
    let names = [".csv", ".svg", "-time.svg"].map(|ending| format!("a00-square-root{ending}"));
    assert!(paths.iter().eq(&names.map(|name| folder.path().join(name))));
    assert!(check_writable(&experiment(), &folder.path().join("missing"), "a00").is_err());
}

/// What was written is read again: the same file, table and plots.
#[test]
fn a_file_is_read_as_it_was_written() {
    let of_errors = || {
        let mut measured = measured(Experiment {
            against: Axis::Parameter,
            unit: Unit::FractionOf("t"),
            opposite: Some("other"),
            ..experiment()
        });
        let numbers = (1..=500).map(|n| Deviation::new(f64::from(n), 3.0, 2.0));
        measured.curves[0].points[0].errors = Errors::of(numbers);
        measured.curves[0].slope = falling().slope;
        measured
    };
    let csv = of_errors().csv();
    let read = Measured::parse(&csv).unwrap();
    assert_eq!(read.csv().replace("no random numbers", "3 4"), csv);
    assert_eq!(read.table(None), of_errors().table(None));
    let wrong = Measured::parse("# experiment: a\nmethod\na,1\n")
        .err()
        .unwrap();
    assert_eq!(wrong.to_string(), "line 3: no row of measurements");
    assert!(Measured::parse("").is_err());
}

/// The earlier quotient of 0.6 is less than a fifth from the new interval and stays, that of 2 does
/// not; seconds follow from both.
#[test]
fn a_time_stays_while_the_new_one_is_equal() {
    let median = |value: f64, half: f64| Median {
        low: value - half,
        value,
        high: value + half,
    };
    let with = |quotients: [Median; 2]| {
        let mut measured = measured(experiment());
        for (point, quotient) in measured.curves[1].points.iter_mut().zip(quotients) {
            point.times.over_first = Some(quotient);
        }
        measured
    };
    let mut now = with([median(0.5, 0.03), median(1.0, 0.1)]);
    now.keep(&with([median(0.6, 0.03), median(2.0, 0.1)]));
    let [first, second, _] = &now.curves[1].points[..] else {
        panic!("three points");
    };
    assert_eq!(first.times.over_first, Some(median(0.6, 0.03)));
    assert_eq!(first.times.seconds.value, 0.6 * 0.002);
    assert_eq!(second.times.over_first, Some(median(1.0, 0.1)));
}

#[test]
fn no_number_of_a_report_has_more_than_17_digits() {
    // The error is the 25th root of one over the work, which is 1/510 at 5e67.
    let points = [10, 30, 68].map(|power| {
        let work = libm::pow(10.0, f64::from(power));
        (work, libm::pow(work, -1.0 / 25.0))
    });
    let experiment = Experiment {
        work: "steps",
        curves: Box::new(move |_| vec![curve(&points)]),
        ..Experiment::new("name\u{1B}[2J")
    };
    let measured = Measured::new(experiment, Effort::Quick, |_, _| ());
    for text in [measured.table(None), measured.csv()] {
        let mut digits = text.split(|letter: char| !letter.is_ascii_digit());
        assert!(digits.all(|digits| digits.len() <= 17), "{text}");
    }
    let table = measured.table(None);
    assert!(table.contains("1/510 takes 4.89e67 steps"), "{table}");
    assert!(!measured.csv().contains('\u{1B}'));
}

#[test]
fn numbers_take_few_characters() {
    let shown = [12e-9, 3.44e-5, 0.25, 2.0].map(table::duration);
    assert_eq!(shown, ["12.0ns", "34.4µs", "250.0ms", "2.0s"]);
    let shown = [0.0, 0.123_46, 9.9e-4, 9e9, 1e10].map(compact);
    assert_eq!(shown, ["0", "0.1235", "9.90e-4", "9000000000", "1.00e10"]);
}
