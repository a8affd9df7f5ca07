use super::*;
use crate::experiment::{Point, Slope};

fn experiment() -> Experiment<'static> {
    Experiment {
        name: "square-root",
        about: "is the error one over the square root?",
        knob: "n",
        work: "steps",
        error: "of nothing",
        against: Axis::Work,
        curves: Box::new(|_| {
            let point = |n: f64| Point::new(n, n, [1.0 / n.sqrt()], move || n);
            vec![Curve {
                method: "plain",
                remark: "remarkable",
                slope: Some(Slope {
                    expected: -0.5,
                    tolerance: 0.01,
                    between: (1.0, 1e9),
                }),
                points: [1.0, 16.0, 256.0].map(point).into(),
            }]
        }),
    }
}

#[test]
fn the_table_shows_slope_price_and_remark() {
    let experiment = experiment();
    let mut steps = Vec::new();
    let measured = Measured::new(&experiment, Effort::Quick, |done, all| {
        steps.push((done, all));
    });
    let table = measured.table();
    // Three points in three rounds.
    assert!(steps.into_iter().eq((0..=9).map(|done| (done, 9))));
    assert!(table.contains("slope -0.50 (theory -0.5)"), "{table}");
    // (1/510)^-2
    assert!(
        table.contains("1/510 takes 260100, extrapolated"),
        "{table}"
    );
    assert!(table.contains("remarkable"), "{table}");
    assert_eq!(table.matches("* plain").count(), 3, "{table}");
}

/// Two curves whose first points have the same parameter, with invented times.
fn measured<'e>(experiment: &'e Experiment<'static>) -> Measured<'e, 'static> {
    let curve = |method, points: &[[f64; 3]]| Curve {
        method,
        remark: "",
        slope: None,
        points: points
            .iter()
            .map(|[knob, work, error]| Point::new(*knob, *work, [*error], || 0.0))
            .collect(),
    };
    let curves = vec![
        curve("plain", &[[1.0, 10.0, 0.5], [2.0, 20.0, 0.25]]),
        curve("clever", &[[1.0, 10.0, 0.1], [3.0, 30.0, 0.5]]),
    ];
    Measured {
        experiment,
        curves,
        seconds: vec![vec![0.002, 0.004], vec![0.001, 3.0]],
    }
}

/// Nothing beats the clever method's first point. The plain one's error has
/// the slope -1; it takes 10 * 0.5 * 510 steps to half a grey level.
#[test]
fn times_are_compared_at_the_same_parameter() {
    let mut experiment = experiment();
    let rows = |star| {
        [
            "square-root: is the error one over the square root?".to_owned(),
            "  error: of nothing".to_owned(),
            "  method                              n          steps rms error       max       time   ratio".to_owned(),
            "  plain                               1             10    5.0e-1    5.0e-1     2.0 ms    1.00".to_owned(),
            "  plain                               2             20    2.5e-1    2.5e-1     4.0 ms    1.00".to_owned(),
            format!("{star} clever                              1             10    1.0e-1    1.0e-1     1.0 ms    0.50"),
            "  clever                              3             30    5.0e-1    5.0e-1     3.00 s        ".to_owned(),
        ]
    };
    let summary = "  plain: slope -1.00; 1/510 takes 2550, extrapolated";
    let rising = "  clever: slope 1.46";
    let lines = |measured: Measured| {
        let table = measured.table();
        table.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let expected = [&rows("*")[..], &[summary.to_owned(), rising.to_owned()]].concat();
    assert_eq!(lines(measured(&experiment)), expected);

    // Against the parameter there is no price, and no Pareto front.
    experiment.against = Axis::Knob;
    let summary = "  plain: slope -1.00".to_owned();
    let expected = [&rows(" ")[..], &[summary, rising.to_owned()]].concat();
    assert_eq!(lines(measured(&experiment)), expected);
}

#[test]
fn a_curve_without_slope_and_remark_has_no_summary() {
    let experiment = experiment();
    let mut measured = measured(&experiment);
    measured.curves[0].points.truncate(1);
    let summary = measured.summary(&measured.curves[0]);
    assert_eq!(summary, "");
    assert!(!measured.table().contains("plain: "));
}

#[test]
fn csv_has_all_digits() {
    let lines = [
        "experiment,method,n,steps,rms error,max error,seconds,pareto",
        "square-root,plain,1,10,5e-1,5e-1,2e-3,false",
        "square-root,plain,2,20,2.5e-1,2.5e-1,4e-3,false",
        "square-root,clever,1,10,1e-1,1e-1,1e-3,true",
        "square-root,clever,3,30,5e-1,5e-1,3e0,false",
    ];
    let experiment = experiment();
    let csv = measured(&experiment).csv();
    assert!(csv.lines().eq(lines), "{csv}");
}

#[test]
fn csv_and_plots_are_written() {
    let experiment = experiment();
    let folder = tempfile::tempdir().unwrap();
    check_writable(&experiment, folder.path(), "a00").unwrap();
    let paths = measured(&experiment).write(folder.path(), "a00").unwrap();
    assert!(paths[0].ends_with("a00-square-root.csv"));
    let csv = std::fs::read_to_string(&paths[0]).unwrap();
    assert_eq!(csv.lines().count(), 5);
    assert!(paths.len() > 1);
    for svg in &paths[1..] {
        assert!(std::fs::read_to_string(svg).unwrap().contains("<svg"));
    }
    let missing = folder.path().join("missing");
    assert!(check_writable(&experiment, &missing, "a00").is_err());
}

#[test]
fn times_are_printed_in_a_fitting_unit() {
    assert_eq!(duration(12e-9), "12 ns");
    assert_eq!(duration(3.44e-5), "34.4 us");
    assert_eq!(duration(0.25), "250.0 ms");
    assert_eq!(duration(2.0), "2.00 s");
}

#[test]
fn numbers_take_few_characters() {
    let shown = [0.0, 1.0, 0.123_46, 1e-3, 9.9e-4, 9e9, 1e10, -2.5].map(compact);
    let expected = [
        "0",
        "1",
        "0.1235",
        "0.001",
        "9.90e-4",
        "9000000000",
        "1.00e10",
        "-2.5",
    ];
    assert_eq!(shown, expected);
}
