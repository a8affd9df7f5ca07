use super::*;

const TEXT: &str = "\
# machine: abacus
# date: 2026-11-26
# commit: 123abc
# a00.far: How far? rms error, against 0; no random numbers
experiment,method,parameter,work,unit,error,error low,error high,seconds,seconds low,seconds high,slope,slope low,slope high
a00.far,\"plain (ours)\",1,8,\"t\",1e-9,0.9e-9,1e-9,2,2,2,,,
a00.far,\"plain (ours)\",2,8,\"t\",0.25,0.2,0.27,1,0.9,1.1,,,
a00.far,\"careful, new\",1,8,\"t\",2.5e-11,2.4e-11,2.62e-11,6,5.9,6.05,-0.4996,-0.52,-0.48
a00.far,\"careful, new\",2,8,\"t\",0,0,0,0.52,0.51,0.53,-0.4996,-0.52,-0.48
a00.far,\"third\",1,8,\"t\",0,0,0,2.1,1.9,2.2,,,
a00.near,\"plain\",1,8,\"all = 1\",0.455,0.44,0.47,1,1,3,,,
a00.near,\"plain\",2,8,\"all = 1\",0,0,0.0004,1,1,3,,,
a00.near,\"plain\",3,8,\"all = 1\",1,0.99961,1,1,1,3,,,
";

#[test]
fn anchors_become_figures_with_their_intervals() {
    let recording = Recording::parse(TEXT).unwrap();
    for (anchor, expected) in [
        ("time a00.far.careful-new/plain-ours", "0.52 ± 0.01"),
        ("time a00.far.careful-new/plain-ours@1", "3.00 ± 0.05"),
        ("time a00.far.plain-ours/careful-new@1", "0.333 ± 0.006"),
        (
            "time a00.far.third/plain-ours",
            "no difference (within 11 %)",
        ),
        ("times a00.far.third/plain-ours", "as long, within 11 %"),
        (
            "times a00.far.careful-new/plain-ours@1",
            "3.00 ± 0.05 times as long",
        ),
        (
            "error a00.far.careful-new@1",
            r"$(2.5 \pm 0.2) \cdot 10^{-11}$",
        ),
        ("error a00.far.careful-new", "0 ± 0"),
        ("error a00.far.plain-ours", "0.25 ± 0.05"),
        ("error a00.near.plain@1", "46 ± 2 %"),
        ("error a00.near.plain@2", "below 0.04 %"),
        ("error a00.near.plain@3", "all"),
        ("slope a00.far.careful-new", "−0.50 ± 0.03"),
        ("slope a00.far.plain-ours", "no power law"),
        ("where", "abacus; 123abc; 2026-11-26"),
    ] {
        let page = format!("It takes {{{{recorded {anchor}}}}} of that.");
        let filled = recording.fill(&page).unwrap();
        assert_eq!(filled, format!("It takes {expected} of that."));
    }
}

/// Elsewhere `careful, new` is faster than `plain (ours)` at 1, and `third` is slower.
#[test]
fn figures_that_turn_elsewhere_are_no_facts() {
    let other = TEXT
        .replace(",6,5.9,6.05,", ",1,0.9,1.1,")
        .replace(",2.1,1.9,2.2,", ",3,2.9,3.1,")
        .replace("abacus", "slide rule");
    let here = Recording::parse(TEXT).unwrap();
    let compared = here.compare(&Recording::parse(&other).unwrap());
    assert_eq!(compared.quotients, 3);
    let said: Vec<_> = compared.turned.iter().map(Turned::to_string).collect();
    let expected = [
        "a00.far at 1: careful, new over plain (ours): 3.00 ± 0.05; elsewhere 0.50 ± 0.05",
        "a00.far at 1: third over plain (ours): no difference (within 11 %); elsewhere 1.50 ± 0.05",
    ];
    assert_eq!(said, expected);
    assert!(compared.turned[0].is_opposite() && !compared.turned[1].is_opposite());
    let turned = Recording::parse(TEXT).unwrap();
    let turned = turned.with_elsewhere(&compared.elsewhere).unwrap();
    for (anchor, expected) in [
        (
            "time a00.far.careful-new/plain-ours@1",
            "3.00 ± 0.05; elsewhere 0.50 ± 0.05",
        ),
        ("time a00.far.careful-new/plain-ours@2", "0.52 ± 0.01"),
        (
            "times a00.far.third/plain-ours",
            "as long, within 11 % here, and 1.50 ± 0.05 times as long elsewhere",
        ),
        ("elsewhere", "slide rule; 123abc; 2026-11-26"),
    ] {
        assert_eq!(turned.figure(anchor).unwrap(), expected);
    }
    assert!(here.compare(&here).turned.is_empty());
}

#[test]
fn a_figure_that_is_not_recorded_is_an_error() {
    let recording = Recording::parse(TEXT).unwrap();
    for anchor in [
        "time a00.far.slow/plain-ours",
        "time a00.far.careful-new",
        "time a00.far.careful-new/plain-ours@7",
        // Both took turns with another one.
        "time a00.far.careful-new/third",
        "error a00.far.plain-ours@7",
        "error a00.far",
        "weight a00.far.plain-ours",
        "somewhere",
    ] {
        let wrong = recording.figure(anchor).unwrap_err();
        assert!(wrong.contains(anchor), "{wrong}");
    }
    for text in [
        TEXT.replace("1e-9,0", "one,0"),
        TEXT.replace(",0.52,0.51", ",0.51"),
        TEXT.replace('"', ""),
    ] {
        assert!(Recording::parse(&text).is_err(), "{text}");
    }
}
