use super::words::{coarse, count, in_a_formula, multiple, percent};
use super::*;

/// A recording of two methods at the values 1 and 2 of the parameter, with these quotients of
/// the second over the first.
fn text(quotients: [f64; 2]) -> String {
    let mut text = "# experiment: far\n# against: parameter\nmethod\n".to_owned();
    for (parameter, quotient) in ["1", "2"].into_iter().zip(quotients) {
        let _ = writeln!(
            text,
            "plain (ours),{parameter},9,1e-9,1e-9,1e-9,,,,,,1,1,1,,,"
        );
        let seconds = format!("{quotient},{quotient},{quotient}");
        let _ = writeln!(
            text,
            "careful,{parameter},9,2.5e-11,2e-11,3e-11,,,,,,{seconds},{seconds}"
        );
    }
    text
}

/// The recordings of two builds.
fn texts(fastest: [f64; 2], release: [f64; 2]) -> Texts {
    let builds = [("fastest", fastest), ("release", release)];
    Texts(
        builds
            .map(|(build, quotients)| Text {
                build: build.to_owned(),
                stage: "a00-example".to_owned(),
                csv: text(quotients),
            })
            .into(),
    )
}

fn filled(texts: &Texts, anchor: &str) -> Result<String, NotFilled> {
    let page = format!("It takes {{{{recorded {anchor}}}}} as that.");
    texts.recordings().unwrap().fill(&page)
}

#[test]
fn anchors_become_figures() {
    let texts = texts([3.1, 0.52], [2.9, 0.48]);
    for (anchor, expected) in [
        ("time a00.far.careful/plain shorter", "about half as long"),
        (
            "time a00.far.careful/plain-ours@1 longer",
            "about 3 times as long",
        ),
        ("time a00.far.careful/plain@most", "up to 3 times as long"),
        ("time a00.far.plain/careful", "about twice as long"),
        ("error a00.far.careful@2", r"$2.5 \cdot 10^{-11}$"),
        ("factor a00.far.plain/careful", "40"),
        ("saved a00.far.careful", "−500"),
        // At 1, the careful one is slower: both are on the front.
        ("front a00.far", "plain (ours) (at 1), careful (everywhere)"),
    ] {
        assert_eq!(
            filled(&texts, anchor),
            Ok(format!("It takes {expected} as that."))
        );
    }
}

/// A sentence holds in all builds, or it is none.
#[test]
fn a_sentence_that_a_build_contradicts_is_an_error() {
    let texts = texts([3.1, 1.5], [2.9, 0.8]);
    for (anchor, expected) in [
        (
            "time a00.far.careful/plain longer",
            "is shorter in the build release",
        ),
        (
            "time a00.far.careful/plain same",
            "is longer in the build fastest",
        ),
        (
            "time a00.far.careful/slow",
            "no method slow; there are plain-ours, careful",
        ),
        (
            "time a00.near.careful/plain",
            "no experiment near; there are far",
        ),
        ("time a09.far.careful/plain", "no stage a09"),
        ("time a00.far.careful", "two methods"),
        ("error a00.far.plain@7", "no such value"),
        ("saved a00.far.plain", "no method before it"),
        ("weight a00.far.plain", "no figure \"weight\""),
    ] {
        let wrong = filled(&texts, anchor).unwrap_err();
        assert!(wrong.why.contains(expected), "{anchor}: {}", wrong.why);
        assert_eq!(wrong.at, "It takes ".len());
    }
}

#[test]
fn figures_are_coarse() {
    let shown = [1.04, 1.7, 2.2, 2.3, 38.0].map(coarse);
    assert_eq!(shown, [1.0, 1.5, 2.0, 2.5, 40.0]);
    assert_eq!(
        [1.1, 1.9, 12.2].map(multiple),
        ["1.2 times", "twice", "12 times"]
    );
    let shown = [0.0, 1.26e-7, 5.04, 0.34].map(in_a_formula);
    assert_eq!(shown, ["0", r"$1.3 \cdot 10^{-7}$", "5", "0.34"]);
    assert_eq!(
        [0.0, 0.455, 1.0, 3.3e-4].map(percent),
        ["0", "46 %", "100 %", "0.033 %"]
    );
    assert_eq!(
        [4.2, 1270.4, 43_412.0, 1_654_232.0].map(count),
        ["4", "1270", "43,400", "1,650,000"]
    );
}
