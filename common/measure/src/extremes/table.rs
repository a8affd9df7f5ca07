//! Selects and checks the rows of the table of extreme cases.

use common::Error;

use super::Case;

/// The cases whose ids begin with one of the names; without a name, all cases.
pub fn select(cases: Vec<Case>, names: &[String]) -> Result<Vec<Case>, Error> {
    let begins = |case: &Case, name: &String| {
        let (id, name) = (case.id.as_bytes(), name.as_bytes());
        id.len() >= name.len() && id[..name.len()].eq_ignore_ascii_case(name)
    };
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
    let wanted = |case: &Case| names.is_empty() || names.iter().any(|name| begins(case, name));
    Ok(cases.into_iter().filter(wanted).collect())
}

/// Checks a stage's table in a test: it has rows, and each of them holds. A test of the
/// last stage checks that no id occurs twice.
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extremes::Bound;

    /// Rows with these ids, whose exact outcome is 1.
    fn cases(ids: &[&'static str], outcome: f64) -> Vec<Case> {
        let case = |id: &&'static str| Case::new(id, "", 1.0, Bound::Equal, outcome);
        ids.iter().map(case).collect()
    }

    #[test]
    fn names_select_by_the_beginning_of_the_id() {
        let ids = |names: &[&str]| {
            let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
            let selected = select(cases(&["A01", "B01", "A02"], 1.0), &names);
            selected.map(|cases| cases.iter().map(|case| case.id).collect::<Vec<_>>())
        };
        assert_eq!(ids(&[]).unwrap(), ["A01", "B01", "A02"]);
        assert_eq!(ids(&["a"]).unwrap(), ["A01", "A02"]);
        assert_eq!(ids(&["A02", "B01"]).unwrap(), ["B01", "A02"]);
        assert!(ids(&["A01B"]).is_err(), "longer than an id");
        let error = ids(&["X"]).unwrap_err().to_string();
        assert!(error.ends_with("begin with A, B"), "{error}");
    }

    #[test]
    #[should_panic(expected = "1 cases fail")]
    fn a_case_that_does_not_hold_fails() {
        check(&cases(&["A01"], 2.0));
    }
}
