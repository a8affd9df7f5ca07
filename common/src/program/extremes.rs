//! `extremes`: the stiff and extreme cases, for a reader.

use super::say;
use crate::{Effort, Error, Stage, extremes};

/// Prints the cases whose ids begin with one of the names; an error if one
/// does not hold.
pub fn show_extremes(stage: &Stage, names: &[String]) -> Result<(), Error> {
    let cases = (stage.extremes)(Effort::of_build());
    if cases.is_empty() {
        let stage = stage.name;
        return Err(Error::Usage(format!("{stage} has no extreme cases")));
    }
    let cases = extremes::select(cases, names)?;
    for case in &cases {
        say(&case.to_string());
    }
    let failed = cases.iter().filter(|case| !case.holds()).count();
    say(&format!("{} cases, {failed} of them failed", cases.len()));
    if failed > 0 {
        return Err(Error::Extremes(failed));
    }
    Ok(())
}
