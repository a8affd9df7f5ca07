//! Selects and checks the rows of the table of extreme cases.

use common::Error;

use super::Case;

/// The cases whose ids begin with one of the names; without a name, all cases.
pub fn select(mut cases: Vec<Case>, names: &[String]) -> Result<Vec<Case>, Error> {
    for name in names {
        if !cases.iter().any(|case| begins(case, name)) {
            let mut letters: Vec<_> = cases.iter().map(|case| &case.id[..1]).collect();
            letters.sort_unstable();
            letters.dedup();
            return Err(Error::Usage(format!(
                "there is no case \"{name}\"; the ids begin with {}",
                letters.join(", ")
            )));
        }
    }
    if !names.is_empty() {
        cases.retain(|case| names.iter().any(|name| begins(case, name)));
    }
    Ok(cases)
}

/// Whether the id of a case begins with a name, in small letters or capital ones.
fn begins(case: &Case, name: &str) -> bool {
    let (id, name) = (case.id.as_bytes(), name.as_bytes());
    id.len() >= name.len() && id[..name.len()].eq_ignore_ascii_case(name)
}

/// Checks tables in a test: they have rows, each of them holds, and each states its condition or why there is
/// none.
///
/// # Panics
///
/// If the table fails the check; the message shows all rows that do not hold.
pub fn check(cases: &[Case]) {
    assert!(!cases.is_empty(), "there are no cases");
    let failed = cases.iter().filter(|case| !case.holds());
    let failed: Vec<_> = failed.map(Case::to_string).collect();
    let (count, rows) = (failed.len(), failed.join("\n"));
    assert!(failed.is_empty(), "{count} cases fail\n{rows}");
    let silent = cases.iter().filter(|case| !case.states_its_condition());
    let silent: Vec<_> = silent.map(|case| case.id.as_str()).collect();
    assert!(
        silent.is_empty(),
        "these cases state neither their condition nor why there is none: {}",
        silent.join(", ")
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extremes::Number;

    /// A row whose exact outcome is 1.
    fn case(id: &str, outcome: f64) -> Case {
        Case {
            id: id.to_owned(),
            exact: Number(1.0),
            ours: Number(outcome),
            ..Case::default()
        }
    }

    fn selected(names: &[&str]) -> Result<Vec<String>, Error> {
        let cases = ["A01", "B01", "A02"].map(|id| case(id, 1.0)).into();
        let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
        let selected = select(cases, &names)?;
        Ok(selected.into_iter().map(|case| case.id).collect())
    }

    #[test]
    fn names_select_by_the_beginning_of_the_id() {
        assert_eq!(selected(&[]).unwrap(), ["A01", "B01", "A02"]);
        assert_eq!(selected(&["a"]).unwrap(), ["A01", "A02"]);
        assert_eq!(selected(&["A02", "B01"]).unwrap(), ["B01", "A02"]);
        assert!(selected(&["A01B"]).is_err(), "longer than an id");
        let error = selected(&["X"]).unwrap_err().to_string();
        assert!(error.ends_with("begin with A, B"), "{error}");
    }

    #[test]
    #[should_panic(expected = "1 cases fail")]
    fn a_case_that_does_not_hold_fails() {
        check(&[case("A01", 2.0)]);
    }

    #[test]
    #[should_panic(expected = "why there is none: A01")]
    fn a_case_without_a_word_of_its_condition_fails() {
        check(&[case("A01", 1.0)]);
    }
}
