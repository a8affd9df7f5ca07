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
            return print(&has_none);
        }
        return Err(Error::Usage(has_none));
    }
    let cases = extremes::select(cases, names)?;
    for case in &cases {
        print(&case.to_string())?;
    }
    let failed = cases.iter().filter(|case| !case.holds()).count();
    print(&format!("{} cases, {failed} of them failed", cases.len()))?;
    if failed > 0 {
        return Err(Error::Extremes(failed));
    }
    Ok(())
}

/// Prints the worst inputs of the formulas of a shape.
pub fn show_worst(stage: &Stage, shape: &str) -> Result<(), Error> {
    let none = || Error::Usage(format!("{} searches no shapes; 4 and 7 do", stage.name));
    print(&stage.search.ok_or_else(none)?(shape)?)
}

#[cfg(test)]
mod tests {
    use measure::extremes::{Bound, Case};

    use super::*;

    #[test]
    fn only_named_cases_are_counted() {
        let mut stage = crate::stage_of(Vec::new());
        let failed = |stage: &Stage, names: &[&str]| {
            let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
            show_extremes(stage, &names)
        };
        assert!(failed(&stage, &[]).is_ok());
        assert!(matches!(failed(&stage, &["A01"]), Err(Error::Usage(_))));
        stage.extremes = |_| {
            let cases = [("A01", 1.0), ("B01", 2.0), ("B02", 3.0), ("B03", 1.0)];
            cases
                .map(|(id, ours)| Case::new(id, "", 1.0, Bound::Equal, ours))
                .into()
        };
        assert!(matches!(failed(&stage, &[]), Err(Error::Extremes(2))));
        assert!(matches!(failed(&stage, &["B01"]), Err(Error::Extremes(1))));
        assert!(failed(&stage, &["A", "B03"]).is_ok());
        assert!(matches!(failed(&stage, &["C"]), Err(Error::Usage(_))));
    }
}
