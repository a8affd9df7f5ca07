use super::*;
use crate::example::{curve, experiment};
use crate::experiment::Axis;

/// The errors of 1, 1/4 and 1/16 fall to 1/510 at (1/510)^-2 steps; three points are
/// measured in nine rounds.
#[test]
fn the_table_shows_slope_price_and_remark() {
    let experiment = experiment();
    let mut steps = Vec::new();
    let progress = |done, all| steps.push((done, all));
    let table = Measured::new(&experiment, Effort::Quick, progress).table();
    assert!(steps.into_iter().eq((0..=27).map(|done| (done, 27))));
    let summary = "  a < b: slope -0.500 ± 0.000, R² 1.0000 (theory -0.5); \
                   1/510 takes 260100 steps, extrapolated";
    assert!(table.contains(summary), "{table}");
    assert_eq!(table.matches("* a < b").count(), 3, "{table}");
}

/// Two curves whose first points have the same parameter, with invented times: the
/// second quotients are 1, 5/4 and 3/4. Nothing beats the other curve's first point.
fn measured<'e>(experiment: &'e Experiment<'static>) -> Measured<'e, 'static> {
    let mut first = curve(&[(10.0, 0.5), (20.0, 0.25)]);
    first.points[0].times.seconds = vec![0.002, 0.003, 0.002];
    first.points[1].times.seconds = vec![0.004, 0.006, 0.004];
    let mut other = curve(&[(10.0, 0.1), (20.0, 0.5), (30.0, 0.5)]);
    other.method = "clever, new";
    other.points[0].times.seconds = vec![0.001, 0.0015, 0.001];
    other.points[1].times.seconds = vec![0.004, 0.0075, 0.003];
    other.points[2].times.seconds = vec![3.0, 4.5, 3.0];
    let curves = vec![first, other];
    Measured { experiment, curves }
}

#[test]
fn remarks_are_computed_from_errors_and_times() {
    let mut experiment = experiment();
    let rows = "\
square-root: Is the error one over the square root?
  rms error (white = 1), against 0
  method                              n          steps     error      99 %       max condition       time  time / first method
  a < b                              10             10    5.0e-1    5.0e-1    5.0e-1                2.0ms
  a < b                              20             20    2.5e-1    2.5e-1    2.5e-1                4.0ms
* clever, new                        10             10    1.0e-1    1.0e-1    1.0e-1                1.0ms  0.50 (0.50-0.50)
  clever, new                        20             20    5.0e-1    5.0e-1    5.0e-1                4.0ms  no difference beyond 34 %
  clever, new                        30             30    5.0e-1    5.0e-1    5.0e-1                 3.0s
";
    let table = measured(&experiment).table();
    assert!(table.starts_with(rows), "{table}");
    let remarks = "  \
  clever, new: no power law: less than a decade; beside a < b at 20: 2.00 times its error, time \
  no difference beyond 34 %
  unbeaten in error and time: clever, new (1.0e-1 in 1.0ms)
";
    assert!(table.ends_with(remarks), "{table}");
    // Against the parameter there is no price, and no Pareto front.
    experiment.against = Axis::Parameter;
    let table = measured(&experiment).table();
    assert!(table.starts_with(&rows.replace('*', " ")), "{table}");
    // Problems do not compete: no star, no quotient, no front.
    experiment.against = Axis::Work;
    experiment.curves_are = Curves::Problems;
    let problems = measured(&experiment);
    let (table, row) = (problems.table(), problems.row());
    let remarks = ["* clever", "0.50 (", "beside", "unbeaten"];
    assert!(remarks.iter().all(|remark| !table.contains(remark)));
    assert_eq!(row, None);
}

#[test]
fn csv_has_all_digits_below_its_origin_and_is_written_with_plots() {
    let experiment = experiment();
    let csv = measured(&experiment).csv();
    for name in ["machine", "version", "seed: 3 4", "error"] {
        assert!(csv.contains(&format!("\n# {name}")), "{name}: {csv}");
    }
    let table = "\
experiment,method,n,steps,rms error,99 %,max,condition,problem's error,seconds,low,high,pareto
square-root,a < b,10,10,5e-1,5e-1,5e-1,,,2e-3,2e-3,3e-3,false
square-root,a < b,20,20,2.5e-1,2.5e-1,2.5e-1,,,4e-3,4e-3,6e-3,false
square-root,\"clever, new\",10,10,1e-1,1e-1,1e-1,,,1e-3,1e-3,1.5e-3,true
square-root,\"clever, new\",20,20,5e-1,5e-1,5e-1,,,4e-3,3e-3,7.5e-3,false
square-root,\"clever, new\",30,30,5e-1,5e-1,5e-1,,,3e0,3e0,4.5e0,false
";
    assert!(csv.ends_with(table), "{csv}");

    let folder = tempfile::tempdir().unwrap();
    check_writable(&experiment, folder.path(), "a00").unwrap();
    let paths = measured(&experiment).write(folder.path(), "a00").unwrap();
    let names = [".csv", ".svg", "-time.svg"].map(|ending| format!("a00-square-root{ending}"));
    assert!(paths.iter().eq(&names.map(|name| folder.path().join(name))));
    assert!(check_writable(&experiment, &folder.path().join("missing"), "a00").is_err());
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
    let measured = Measured::new(&experiment, Effort::Quick, |_, _| ());
    for text in [measured.table(), measured.csv()] {
        let mut digits = text.split(|letter: char| !letter.is_ascii_digit());
        assert!(digits.all(|digits| digits.len() <= 17), "{text}");
    }
    let table = measured.table();
    assert!(table.contains("1/510 takes 4.89e67 steps"), "{table}");
    assert!(!measured.csv().contains('\u{1B}'));
}

#[test]
fn numbers_take_few_characters() {
    let shown = [12e-9, 3.44e-5, 0.25, 2.0].map(duration);
    assert_eq!(shown, ["12.0ns", "34.4µs", "250.0ms", "2.0s"]);
    let shown = [0.0, 0.123_46, 9.9e-4, 9e9, 1e10].map(compact);
    assert_eq!(shown, ["0", "0.1235", "9.90e-4", "9000000000", "1.00e10"]);
}
