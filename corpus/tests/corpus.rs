//! The file of cases is whole, and verdicts are fair.

use std::collections::BTreeSet;

use corpus::{
    Answer, Asks, CASES, Case, DOUBLE, LABORATORY, Outlook, SINGLE, SINGLE_CASES, Tally, Verdict,
    judge, read, read_questions, read_rows, rows,
};

fn case(id: &str) -> Case {
    let cases = read(CASES).unwrap();
    let case = cases.into_iter().find(|case| case.question.id == id);
    case.unwrap_or_else(|| panic!("{id} is missing"))
}

#[test]
fn each_case_has_a_name_of_its_own_a_source_and_numbers() {
    let cases = read(CASES).unwrap();
    let ids: BTreeSet<_> = cases.iter().map(|case| &case.question.id).collect();
    assert_eq!(ids.len(), cases.len());
    assert!(cases.len() >= 200, "{}", cases.len());
    let public = cases.iter().filter(|case| case.question.source != "ours");
    assert!(public.count() >= 27);
    for Case { question, .. } in &cases {
        let is_address = question.source.starts_with("https://");
        assert!(is_address || question.source == "ours", "{}", question.id);
        assert!(question.says.ends_with('.'), "{}", question.id);
        assert!(question.id.starts_with(&question.family), "{}", question.id);
    }
    let of_single = read_questions(SINGLE_CASES).unwrap();
    for question in of_single {
        assert!(ids.contains(&question.id), "{}", question.id);
        for number in question.numbers() {
            assert_eq!(number, f64::from(number as f32), "{}", question.id);
        }
    }
}

/// The rows of the laboratories have names of their own, an exact answer unless there is no shape, and words
/// from which a row of the table is made.
#[test]
fn each_row_of_a_laboratory_says_what_it_expects() {
    let all = read_rows(LABORATORY).unwrap();
    let ids: BTreeSet<_> = all.iter().map(|row| &row.case.question.id).collect();
    assert_eq!(ids.len(), all.len());
    assert!(all.len() >= 118, "{}", all.len());
    for row in &all {
        let Case {
            question, answer, ..
        } = &row.case;
        assert!(question.says.ends_with('.'), "{}", question.id);
        assert_eq!(
            row.distance.is_some(),
            matches!(answer, Answer::Hit(_)),
            "{}",
            question.id
        );
        if *answer == Answer::NoShape {
            assert!(row.expected.is_refused, "{}", question.id);
        }
    }
    let shadows = rows(&["shadow"]).unwrap();
    assert_eq!(shadows.len(), 4);
    assert!(shadows.iter().all(|row| row.expected.asks == Asks::IsLit));
    let [far] = &rows(&["sphere"]).unwrap()[..1] else {
        panic!()
    };
    assert_eq!(far.expected.protocol, Some(Outlook::Fails));
    assert_eq!(far.distance.as_ref().unwrap().digits, "99999999");
}

/// Numbers are written with the fewest digits that are read as the same double: reading and writing one
/// changes nothing.
#[test]
fn numbers_are_shortest() {
    let numbers = CASES.lines().filter(|line| line.starts_with("ray"));
    for line in numbers {
        for word in line.split(['[', ']', ',', ' ']) {
            if let Ok(number) = word.parse::<f64>() {
                assert_eq!(word, format!("{number:?}"));
            }
        }
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
    assert_eq!(found(31.0), Verdict::Right);
    assert_eq!(found(33.0), Verdict::WrongValue);
    assert_eq!(judge(&case, None, DOUBLE), Verdict::WrongDecision);
    assert_eq!(judge(&case, Some(f64::NAN), DOUBLE), Verdict::WrongValue);
    assert_eq!(
        judge(&case, Some(10_000_002.0), SINGLE),
        Verdict::Right,
        "one unit of single precision"
    );
}

#[test]
fn on_a_border_and_in_the_plane_other_answers_are_defensible() {
    // The hit is the end of the interval.
    let border = case("contact-13");
    assert_eq!(border.answer, Answer::Miss);
    assert_eq!(judge(&border, Some(4.0), DOUBLE), Verdict::Border);
    assert_eq!(judge(&border, Some(f64::NAN), DOUBLE), Verdict::WrongValue);
    let coplanar = case("public-38");
    for found in [None, Some(1.0)] {
        assert_eq!(judge(&coplanar, found, DOUBLE), Verdict::Right);
    }
    // 1e-10 beside a ball is beside it in doubles, and on its border in single precision.
    let beside = case("grazing-10");
    assert_eq!(
        judge(&beside, Some(5.0), DOUBLE),
        Verdict::WrongDecision,
        "{beside:?}"
    );
    assert_eq!(judge(&beside, Some(5.0), SINGLE), Verdict::Border);
}

#[test]
fn verdicts_are_counted() {
    let mut tally = Tally::default();
    for verdict in [
        Verdict::Right,
        Verdict::Right,
        Verdict::WrongDecision,
        Verdict::WrongValue,
        Verdict::Border,
    ] {
        tally.add(verdict);
    }
    let expected = Tally {
        asked: 5,
        right: 2,
        wrong_decisions: 1,
        wrong_values: 1,
        borders: 1,
    };
    assert_eq!(tally, expected);
}

#[test]
fn a_mistake_in_the_file_is_named() {
    let line = "[[case]]\nid = \"a-1\"\nfamily = \"a\"\nsays = \"s\"\nsource = \"ours\"\n";
    let rest = "ray = { origin = [0, 0, 0], direction = [0, 0, 1] }\nwithin = [0.0, inf]\n";
    let said = |text: String| read_questions(&text).unwrap_err().to_string();
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
    assert_eq!(read_questions(&unanswered).unwrap().len(), 1);
    assert_eq!(
        read(&unanswered).unwrap_err().to_string(),
        "case a-1: answer is missing, or is not a text"
    );
    let expects = |key: &str| {
        let shape = "sphere = { center = [0, 0, 1], radius = 1 }";
        let row =
            format!("{line}{shape}\n{rest}answer = \"miss\"\ncondition = 0\nmargin = 0\n{key}\n");
        read_rows(&row).unwrap_err().to_string()
    };
    assert_eq!(
        expects("protocol = \"maybe\""),
        "case a-1: protocol is missing, or is not holds or fails"
    );
    assert_eq!(
        expects("bound = { length = 1 }"),
        "case a-1: cosine is missing, or is not a number"
    );
    assert_eq!(
        expects("bound = 3"),
        "case a-1: bound is missing, or is not a table"
    );
}
