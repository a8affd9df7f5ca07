//! The extreme cases of a stage, computed on the page: exact, the protocol's, ours.

use common::Error;
use measure::Effort;

use crate::{Answer, Answered};

/// All cases of a stage as text, one below the other with an empty line between them,
/// and how many there are and hold. With as few rays as the quick reports take.
pub fn extremes(stage: &str) -> Answered {
    let laboratory = match stage.get(..3).unwrap_or_default() {
        "a02" => a02_lab::laboratory(),
        "a03" => a03_lab::laboratory(),
        "a04" => a04_lab::laboratory(),
        "a05" => a05_lab::laboratory(),
        "a06" => a06_lab::laboratory(),
        "a07" => a07_lab::laboratory(),
        _ => {
            let missing = format!("stage \"{stage}\" has no extreme cases");
            return Err(Error::Usage(missing));
        }
    };
    let cases = (laboratory.extremes)(Effort::Quick);
    let held = cases.iter().filter(|case| case.holds()).count();
    let rows: Vec<_> = cases
        .iter()
        .map(|case| case.to_string().trim_end().to_owned())
        .collect();
    Ok(Answer::text(rows.join("\n\n"))
        .with("cases", [cases.len() as f64])
        .with("held", [held as f64]))
}
