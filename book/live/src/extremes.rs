//! The extreme cases of a stage, computed on the page: exact, the protocol's, ours.

use common::Error;
use measure::Effort;

use crate::{Answer, Answered, catalogue};

/// All cases of a stage as text, one below the other with an empty line between them,
/// and how many there are and hold. With as few rays as the quick reports take.
pub fn extremes(stage: &str) -> Answered {
    let mut stages = catalogue::stages().into_iter();
    let missing = || Error::Usage(format!("there is no stage \"{stage}\""));
    let stage = stages
        .find(|known| known.name == stage)
        .ok_or_else(missing)?;
    let cases = (stage.extremes)(Effort::Quick);
    let held = cases.iter().filter(|case| case.holds()).count();
    let rows: Vec<_> = cases
        .iter()
        .map(|case| case.to_string().trim_end().to_owned())
        .collect();
    Ok(Answer::text(rows.join("\n\n"))
        .with("cases", [cases.len() as f64])
        .with("held", [held as f64]))
}
