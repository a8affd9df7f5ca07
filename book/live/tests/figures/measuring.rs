//! A measurement of the page against what follows from equal times.

use live::call;

use super::ask;

/// A page measures in turns as a report does. If all runs take the same time, the most exact point alone is on
/// the front; and one sample in the middle is the regular grid of one.
#[test]
fn a_measurement_on_the_page_takes_turns_as_a_report_does() {
    let methods = "regular,one in the middle";
    let begun = ask(
        &format!("measure begin {methods}|samples-curved-edge"),
        &[1e-3],
    );
    assert_eq!(begun.get("prepared"), [1.0]);
    // The first time of each point says that one run is long enough; then come nine rounds of seven points.
    for turn in 1..=7 + 63 {
        ask("measure run", &[]);
        let answer = ask("measure took", &[2e-3]);
        assert_eq!(answer.get("measured"), [f64::from(u8::from(turn == 70))]);
        if turn == 70 {
            assert_eq!(answer.get("point.seconds"), [2e-3; 7]);
            assert_eq!(
                answer.get("point.parameter"),
                [1.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 1.0]
            );
            // All take the same time, so only the most exact one is not beaten.
            assert_eq!(
                answer.get("point.front"),
                [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]
            );
            let errors = answer.get("point.error");
            assert_eq!(errors[0].to_bits(), errors[6].to_bits());
        }
    }
    let reach = ask("measure soonest", &[0.1]);
    assert_eq!(
        (reach.get("reach.curve"), reach.get("ties")),
        (&[0.0][..], &[1.0][..])
    );
    // Not one between 1 and 4, of which there is no square grid.
    assert_eq!(reach.get("reach.parameter"), [4.0]);
    let picture = ask("measure picture", &[0.0, 5.0]);
    assert_eq!(picture.get("size"), [128.0, 64.0]);
    assert!(call("measure picture", &[2.0, 0.0]).is_err());
}

/// A picture with a switch off takes turns with that of the lesson and with all work. If all runs take the same
/// time, no difference is found.
#[test]
fn what_is_left_out_is_timed_in_turns() {
    let mut answer = ask(
        "measure begin |left-out a05-lighting-phong",
        &[1e-3, 0.0, 1.0],
    );
    while answer.get("measured") != [1.0] {
        ask("measure run", &[]);
        answer = ask("measure took", &[2e-3]);
    }
    let of = |line: &str| line.split('\t').next_back().unwrap_or_default().to_owned();
    // Below the names of the columns.
    let quotients: Vec<_> = answer.text.lines().skip(1).map(of).collect();
    assert_eq!(quotients[0], "");
    assert!(
        quotients[1..]
            .iter()
            .all(|text| text.starts_with("no difference")),
        "{quotients:?}"
    );
    assert_eq!(quotients.len(), 3);
}
