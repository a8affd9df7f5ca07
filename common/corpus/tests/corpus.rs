//! The file of cases is whole, and verdicts are fair.

use std::collections::BTreeSet;

use corpus::{CASES, Case, ExactAnswer, SINGLE_CASES, Verdict, read, verdict};

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

fn expected(decision: impl Into<Option<bool>>, value: impl Into<Option<bool>>) -> Verdict {
    Verdict {
        decision: decision.into(),
        value: value.into(),
    }
}

#[test]
fn a_value_may_be_off_by_sixteen_times_the_condition() {
    // 10000001, of condition 2.
    let case = case("public-35");
    let ExactAnswer::Hit(hit) = &case.answer else {
        panic!()
    };
    assert_eq!(hit.digits, "10000001");
    let found = |ulps: f64| verdict(&case, Some(hit.t * (1.0 + ulps * f64::EPSILON)));
    assert_eq!(found(31.0), expected(true, true));
    assert_eq!(found(33.0), expected(true, false));
    assert_eq!(verdict(&case, None), expected(false, None));
    let nan = verdict(&case, Some(f64::NAN));
    assert_eq!(nan, expected(true, false));
}

/// The hit is the end of the interval, so that a closed interval has it.
#[test]
fn on_a_border_decisions_are_not_counted_and_values_have_a_range() {
    let border = case("contact-13");
    assert_eq!(border.answer, ExactAnswer::Miss);
    assert_eq!(verdict(&border, None), expected(None, None));
    assert_eq!(verdict(&border, Some(4.0)), expected(None, true));
    assert_eq!(verdict(&border, Some(4.1)), expected(None, false));
    let nan = verdict(&border, Some(f64::NAN));
    assert_eq!(nan, expected(None, false));
}

#[test]
fn what_no_answer_can_fail_is_not_counted() {
    let coplanar = case("public-38");
    for found in [None, Some(1.0)] {
        assert!(!verdict(&coplanar, found).is_counted());
    }
    // On a border, and with an infinite condition that leaves no digit.
    let touching = verdict(&case("public-54"), Some(23.0));
    assert!(!touching.is_counted());
}

#[test]
fn a_mistake_in_the_file_is_named() {
    let line = "[[case]]\nid = \"a-1\"\nfamily = \"a\"\nsays = \"s\"\nsource = \"ours\"\n";
    let rest = "ray = { origin = [0, 0, 0], direction = [0, 0, 1] }\nwithin = [0.0, inf]\n";
    let said = |text: String| read(&text).unwrap_err();
    assert_eq!(
        said("[[case]]\nid = 3".to_owned()),
        "cases, case 1 (without a name): `id` must be a text"
    );
    assert_eq!(
        said(format!(
            "{line}sphere = {{ center = [0, 0], radius = 1 }}\n{rest}"
        )),
        "cases, case 1 (a-1), sphere: `center` must be a list of 3, each a number"
    );
    assert_eq!(
        said(format!("{line}{rest}")),
        "cases, case 1 (a-1): `triangles` is missing, or another shape"
    );
    assert!(said("[[case]".to_owned()).starts_with("cases: TOML parse error"));
    let unanswered = format!("{line}sphere = {{ center = [0, 0, 1], radius = 1 }}\n{rest}");
    assert_eq!(
        said(unanswered),
        "cases, case 1 (a-1): `answer` is missing; it must be a text"
    );
    let more = format!("{line}sphere = {{ center = [0, 0, 1], radius = 1, colour = 1 }}\n{rest}");
    let more = said(more);
    assert!(more.contains("sphere: `colour` is no key here"), "{more}");
}
