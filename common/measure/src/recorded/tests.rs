use super::*;

const TEXT: &str = "\
# machine: abacus
# date: 2026-11-26
# commit: 123abc
# a00.far: How far? rms error, against 0; no random numbers
experiment,method,parameter,work,unit,error,error low,error high,seconds,seconds low,seconds high,slope
a00.far,\"plain (ours)\",1,8,\"t\",1e-9,0,1,2,1,3,
a00.far,\"plain (ours)\",2,8,\"t\",1e-9,0,1,1,1,3,
a00.far,\"careful, new\",1,8,\"t\",2.5e-11,0,1,6,1,3,-0.4996
a00.far,\"careful, new\",2,8,\"t\",0,0,1,0.52,1,3,-0.4996
a00.near,\"plain\",1,8,\"all = 1\",0.455,0,1,1,1,3,
";

#[test]
fn anchors_become_figures() {
    let recording = Recording::parse(TEXT).unwrap();
    for (anchor, expected) in [
        ("time a00.far.careful-new/plain-ours", "0.52"),
        ("time a00.far.careful-new/plain-ours@1", "3"),
        ("error a00.far.careful-new@1", r"$2.5 \cdot 10^{-11}$"),
        ("error a00.far.careful-new", "0"),
        ("error a00.near.plain", "46 %"),
        ("slope a00.far.careful-new", "−0.50"),
        ("slope a00.far.plain-ours", "no power law"),
        ("where", "abacus; 123abc; 2026-11-26"),
    ] {
        let page = format!("It takes {{{{recorded {anchor}}}}} of that.");
        let filled = recording.fill(&page).unwrap();
        assert_eq!(filled, format!("It takes {expected} of that."));
    }
}

#[test]
fn a_figure_that_is_not_recorded_is_an_error() {
    let recording = Recording::parse(TEXT).unwrap();
    for anchor in [
        "time a00.far.slow/plain-ours",
        "time a00.far.careful-new",
        "time a00.far.careful-new/plain-ours@7",
        "error a00.far.plain-ours@7",
        "error a00.far",
        "weight a00.far.plain-ours",
        "somewhere",
    ] {
        let wrong = recording.figure(anchor).unwrap_err();
        assert!(wrong.contains(anchor), "{wrong}");
    }
    for text in [
        TEXT.replace("1e-9", "one"),
        TEXT.replace(",0.52,", ","),
        TEXT.replace('"', ""),
    ] {
        assert!(Recording::parse(&text).is_err(), "{text}");
    }
}
