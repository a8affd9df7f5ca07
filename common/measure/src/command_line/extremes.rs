//! `extremes`: the stiff and extreme cases, for a reader.

use command_line::print;
use common::Error;

use crate::{Effort, Laboratory, extremes};

/// Prints the cases whose ids begin with one of the names. An error if one of them
/// does not hold, or if the stage has no cases.
pub fn show_extremes(laboratory: &Laboratory, names: &[String]) -> Result<(), Error> {
    let cases = (laboratory.extremes)(Effort::of_build());
    if cases.is_empty() {
        let has_none = format!("{} has no extreme cases", laboratory.stage.name);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extremes::{Case, Number};

    fn show(laboratory: &Laboratory, names: &[&str]) -> Result<(), Error> {
        let names: Vec<_> = names.iter().map(|name| (*name).to_owned()).collect();
        show_extremes(laboratory, &names)
    }

    /// Two of these rows fail.
    fn cases() -> Vec<Case> {
        [("A01", 1.0), ("B01", 2.0), ("B02", 3.0), ("B03", 1.0)]
            .map(|(id, ours)| Case {
                id: id.to_owned(),
                exact: Number(1.0),
                ours: Number(ours),
                ..Case::default()
            })
            .into()
    }

    #[test]
    fn only_named_cases_are_counted() {
        let mut laboratory = crate::example::laboratory(Vec::new());
        assert!(show(&laboratory, &[]).is_ok());
        assert!(matches!(show(&laboratory, &["A01"]), Err(Error::Usage(_))));
        laboratory.extremes = |_| cases();
        assert!(matches!(show(&laboratory, &[]), Err(Error::Extremes(2))));
        let only_one = show(&laboratory, &["B01"]);
        assert!(matches!(only_one, Err(Error::Extremes(1))));
        assert!(show(&laboratory, &["A", "B03"]).is_ok());
        assert!(matches!(show(&laboratory, &["C"]), Err(Error::Usage(_))));
    }
}
