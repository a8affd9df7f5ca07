//! The exercises that count, by the last stage that a course has come to.

use learn::exercise::Exercise;

/// The exercises of the stages up to the last one.
pub fn exercises_until(
    course: &'static [Exercise],
    last: Option<&String>,
) -> Result<&'static [Exercise], String> {
    let is_last = |e: &Exercise| last.is_none_or(|last| e.stage.starts_with(last));
    let end = course.iter().rposition(is_last);
    let end = end.ok_or("no stage is so called; they are a01 to a07")?;
    Ok(&course[..=end])
}
