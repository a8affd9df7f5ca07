use super::*;
use crate::experiment::{Point, Slope, Unit};

fn experiment() -> Experiment<'static> {
    Experiment {
        name: "square-root",
        about: "Is the error one over the square root?",
        knob: "n",
        work: "steps",
        error: "rms error",
        unit: Unit::Light,
        exact: "against 0",
        seeds: &[3, 4],
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

/// The errors of 1, 1/4 and 1/16 fall to 1/510 at (1/510)^-2 steps.
#[test]
fn the_table_shows_slope_price_and_remark() {
    let experiment = experiment();
    let mut steps = Vec::new();
    let measured = Measured::new(&experiment, Effort::Quick, |done, all| {
        steps.push((done, all));
    });
    let table = measured.table();
    // Three points in nine rounds.
    assert!(steps.into_iter().eq((0..=27).map(|done| (done, 27))));
    let summary = "  plain: slope -0.500 ± 0.000, R² 1.0000 (theory -0.5); \
                   1/510 takes 260100 steps, extrapolated; remarkable";
    assert_eq!(table.lines().last(), Some(summary));
    assert_eq!(table.matches("* plain").count(), 3, "{table}");
}

/// Two curves whose first points have the same parameter, with invented times. Nothing
/// beats the clever method's first point.
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
        curve(
            "clever, new",
            &[[1.0, 10.0, 0.1], [2.0, 20.0, 0.5], [3.0, 30.0, 0.5]],
        ),
    ];
    let times = |seconds: f64| vec![seconds, 1.5 * seconds, seconds];
    Measured {
        experiment,
        curves,
        seconds: vec![
            [0.002, 0.004].map(times).into(),
            vec![times(0.001), vec![0.004, 0.0075, 0.003], times(3.0)],
        ],
    }
}

/// The second ratios are 1, 5/4 and 3/4.
#[test]
fn times_are_compared_at_the_same_parameter() {
    let mut experiment = experiment();
    let rows = |star| {
        [
            "square-root: Is the error one over the square root?".to_owned(),
            "  rms error (white = 1), against 0".to_owned(),
            "  method                              n          steps     error       max       time  time / first method".to_owned(),
            "  plain                               1             10    5.0e-1    5.0e-1     2.0 ms".to_owned(),
            "  plain                               2             20    2.5e-1    2.5e-1     4.0 ms".to_owned(),
            format!("{star} clever, new                         1             10    1.0e-1    1.0e-1     1.0 ms  0.50 (0.50-0.50)"),
            "  clever, new                         2             20    5.0e-1    5.0e-1     4.0 ms  no difference beyond 34 %".to_owned(),
            "  clever, new                         3             30    5.0e-1    5.0e-1     3.00 s".to_owned(),
        ]
    };
    let table = measured(&experiment).table();
    assert!(table.lines().take(8).eq(rows("*")), "{table}");
    // Against the parameter there is no price, and no Pareto front.
    experiment.against = Axis::Knob;
    let table = measured(&experiment).table();
    assert!(table.lines().take(8).eq(rows(" ")), "{table}");
}

#[test]
fn csv_has_all_digits_below_its_origin() {
    let experiment = experiment();
    let csv = measured(&experiment).csv();
    let (head, table): (Vec<_>, Vec<_>) = csv.lines().partition(|line| line.starts_with('#'));
    for name in [
        "machine",
        "compiler",
        "version",
        "date",
        "seed: 3 4",
        "error",
        "seconds",
    ] {
        let names = |line: &&str| line.starts_with(&format!("# {name}"));
        assert!(head.iter().any(names), "{name}: {csv}");
    }
    let lines = [
        "experiment,method,n,steps,rms error,max error,seconds,low,high,estimate,pareto",
        "square-root,plain,1,10,5e-1,5e-1,2e-3,2e-3,3e-3,false,false",
        "square-root,plain,2,20,2.5e-1,2.5e-1,4e-3,4e-3,6e-3,false,false",
        "square-root,\"clever, new\",1,10,1e-1,1e-1,1e-3,1e-3,1.5e-3,false,true",
        "square-root,\"clever, new\",2,20,5e-1,5e-1,4e-3,3e-3,7.5e-3,false,false",
        "square-root,\"clever, new\",3,30,5e-1,5e-1,3e0,3e0,4.5e0,false,false",
    ];
    assert_eq!(table, lines);
}

#[test]
fn csv_and_plots_are_written() {
    let experiment = experiment();
    let folder = tempfile::tempdir().unwrap();
    check_writable(&experiment, folder.path(), "a00").unwrap();
    let paths = measured(&experiment).write(folder.path(), "a00").unwrap();
    let names = [
        "a00-square-root.csv",
        "a00-square-root.svg",
        "a00-square-root-time.svg",
    ];
    assert!(paths.iter().eq(&names.map(|name| folder.path().join(name))));
    let missing = folder.path().join("missing");
    assert!(check_writable(&experiment, &missing, "a00").is_err());
}

#[test]
fn numbers_take_few_characters() {
    assert_eq!(
        [12e-9, 3.44e-5, 0.25, 2.0].map(duration),
        ["12 ns", "34.4 us", "250.0 ms", "2.00 s"]
    );
    let shown = [0.0, 0.123_46, 9.9e-4, 9e9, 1e10].map(compact);
    assert_eq!(shown, ["0", "0.1235", "9.90e-4", "9000000000", "1.00e10"]);
}
