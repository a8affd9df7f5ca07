//! `extremes`: the stiff and extreme cases, for a reader.

use common::Error;
use measure::{Effort, Stage, extremes};

use crate::print::print;

/// Prints the cases whose ids begin with one of the names. An error if one of them
/// does not hold, or if the stage has no cases.
pub fn show_extremes(stage: &Stage, names: &[String]) -> Result<(), Error> {
    let cases = (stage.extremes)(Effort::of_build());
    if cases.is_empty() {
        let has_none = format!("{} has no extreme cases", stage.name);
        if names.is_empty() {
            print(&has_none);
            return Ok(());
        }
        return Err(Error::Usage(has_none));
    }
    let cases = extremes::select(cases, names)?;
    for case in &cases {
        print(&case.to_string());
    }
    let failed = cases.iter().filter(|case| !case.holds()).count();
    print(&format!("{} cases, {failed} of them failed", cases.len()));
    if failed > 0 {
        return Err(Error::Extremes(failed));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use measure::extremes::{Bound, Case};

    use super::*;

    fn stage(extremes: fn(Effort) -> Vec<Case>) -> Stage {
        Stage {
            name: "a00",
            about: "",
            scenes: Vec::new(),
            experiments: Vec::new,
            extremes,
        }
    }

    fn cases() -> Vec<Case> {
        let case = |id, ours: f64| Case::new(id, "", 1.0, Bound::Equal, ours);
        vec![
            case("A01", 1.0),
            case("B01", 2.0),
            case("B02", 3.0),
            case("B03", 1.0),
        ]
    }

    #[test]
    fn only_named_cases_are_counted() {
        let stage = stage(|_| cases());
        let failed = |names: &[&str]| {
            let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
            show_extremes(&stage, &names)
        };
        assert!(matches!(failed(&[]), Err(Error::Extremes(2))));
        assert!(matches!(failed(&["B01"]), Err(Error::Extremes(1))));
        assert!(failed(&["A", "B03"]).is_ok());
        assert!(matches!(failed(&["C"]), Err(Error::Usage(_))));
    }

    #[test]
    fn a_stage_without_cases_is_an_error() {
        let stage = stage(|_| Vec::new());
        assert!(show_extremes(&stage, &[]).is_ok());
        let error = show_extremes(&stage, &["A01".to_owned()]).unwrap_err();
        assert_eq!(error.to_string(), "a00 has no extreme cases");
    }
}
