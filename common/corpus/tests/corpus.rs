//! The file of cases is whole, and verdicts are fair.

use std::collections::BTreeSet;

use corpus::{Answer, CASES, Case, DOUBLE, SINGLE, SINGLE_CASES, Tally, Verdict, judge, read};

fn case(id: &str) -> Case {
    let cases = read(CASES).unwrap();
    let case = cases.into_iter().find(|case| case.question.id == id);
    case.unwrap_or_else(|| panic!("{id} is missing"))
}

#[test]
fn each_case_has_a_name_of_its_own_a_source_and_an_exact_answer() {
    let cases = read(CASES).unwrap();
    let ids: BTreeSet<_> = cases.iter().map(|case| &case.question.id).collect();
    assert_eq!(ids.len(), cases.len());
    assert!(cases.len() >= 413, "{}", cases.len());
    let public = cases.iter().filter(|case| case.question.source != "ours");
    assert!(public.count() >= 56);
    for Case { question, .. } in &cases {
        let is_address = question.source.starts_with("https://");
        assert!(is_address || question.source == "ours", "{}", question.id);
        assert!(question.says.ends_with('.'), "{}", question.id);
        assert!(question.id.starts_with(&question.family), "{}", question.id);
    }
    for case in read(SINGLE_CASES).unwrap() {
        assert!(ids.contains(&case.question.id), "{}", case.question.id);
    }
}

fn verdict(decision: impl Into<Option<bool>>, value: impl Into<Option<bool>>) -> Verdict {
    Verdict {
        decision: decision.into(),
        value: value.into(),
    }
}

#[test]
fn a_value_may_be_off_by_sixteen_times_the_condition() {
    // 10000001, of condition 2.
    let case = case("public-35");
    let Answer::Hit(hit) = &case.answer else {
        panic!()
    };
    assert_eq!(hit.digits, "10000001");
    let found = |ulps: f64| judge(&case, Some(hit.t * (1.0 + ulps * f64::EPSILON)), DOUBLE);
    assert_eq!(found(31.0), verdict(true, true));
    assert_eq!(found(33.0), verdict(true, false));
    assert_eq!(judge(&case, None, DOUBLE), verdict(false, None));
    let nan = judge(&case, Some(f64::NAN), DOUBLE);
    assert_eq!(nan, verdict(true, false));
    // One unit of single precision.
    let rounded = judge(&case, Some(10_000_002.0), SINGLE);
    assert_eq!(rounded, verdict(true, true));
}

/// The hit is the end of the interval, so that a closed interval has it.
#[test]
fn on_a_border_decisions_are_not_counted_and_values_have_a_range() {
    let border = case("contact-13");
    assert_eq!(border.answer, Answer::Miss);
    assert_eq!(judge(&border, None, DOUBLE), verdict(None, None));
    assert_eq!(judge(&border, Some(4.0), DOUBLE), verdict(None, true));
    assert_eq!(judge(&border, Some(4.1), DOUBLE), verdict(None, false));
    let nan = judge(&border, Some(f64::NAN), DOUBLE);
    assert_eq!(nan, verdict(None, false));
}

/// A needle that the ray misses, if its numbers differ by rounding in single precision: any decision is right, but
/// no `t` of another size.
#[test]
fn a_wrong_value_at_a_border_is_wrong() {
    let cases = read(SINGLE_CASES).unwrap();
    let needle = cases.iter().find(|case| case.question.id == "needle-11");
    let needle = needle.unwrap();
    assert_eq!(judge(needle, None, SINGLE), verdict(None, None));
    assert_eq!(judge(needle, Some(1.0), SINGLE), verdict(None, true));
    assert_eq!(judge(needle, Some(1.000_14), SINGLE), verdict(None, false));
}

#[test]
fn what_no_answer_can_fail_is_not_counted() {
    let coplanar = case("public-38");
    for found in [None, Some(1.0)] {
        assert!(!judge(&coplanar, found, DOUBLE).is_counted());
    }
    // A condition of 1e9 leaves no digit of single precision: the decision alone is asked.
    let cases = read(SINGLE_CASES).unwrap();
    let inside = cases.iter().find(|case| case.question.id == "inside-18");
    let found = judge(inside.unwrap(), Some(23.0), SINGLE);
    assert_eq!(found, verdict(true, None));
}

#[test]
fn parts_are_counted() {
    let mut tally = Tally::default();
    for verdict in [
        verdict(true, true),
        verdict(true, false),
        verdict(false, None),
        verdict(None, true),
        verdict(None, None),
    ] {
        tally.add(verdict);
    }
    let expected = Tally {
        asked: 4,
        right: 2,
        decisions: 3,
        right_decisions: 2,
        values: 3,
        right_values: 2,
    };
    assert_eq!(tally, expected);
}

#[test]
fn a_mistake_in_the_file_is_named() {
    let line = "[[case]]\nid = \"a-1\"\nfamily = \"a\"\nsays = \"s\"\nsource = \"ours\"\n";
    let rest = "ray = { origin = [0, 0, 0], direction = [0, 0, 1] }\nwithin = [0.0, inf]\n";
    let said = |text: String| read(&text).unwrap_err().to_string();
    assert_eq!(
        said("[[case]]\nfamily = 3".to_owned()),
        "case number 1: id is missing, or is not a text"
    );
    assert_eq!(
        said(format!(
            "{line}sphere = {{ center = [0, 0], radius = 1 }}\n{rest}"
        )),
        "case a-1: center is missing, or is not as many numbers in brackets as it has"
    );
    assert!(said("[[case]".to_owned()).starts_with("no TOML"));
    let unanswered = format!("{line}sphere = {{ center = [0, 0, 1], radius = 1 }}\n{rest}");
    assert_eq!(
        said(unanswered),
        "case a-1: answer is missing, or is not a text"
    );
}
