//! The last hint of a core exercise: the lines of a solution in another order, a Parsons problem.
//! (Parsons and Haden, Parson's Programming Puzzles, 2006)

use crate::exercise::Exercise;
use crate::files;

/// The first words of the hint.
pub const BEGINNING: &str = "These are the lines of a solution";

/// The lines that a solution has and the starter lacks, sorted by their letters; none of an exercise
/// beyond the core path.
pub fn hint(e: &Exercise) -> Option<String> {
    if !e.is_core {
        return None;
    }
    let solution = files::read(&e.solution_file()).ok()?;
    let starter = files::starter(e).ok()?;
    let given: Vec<_> = starter.lines().map(str::trim).collect();
    let mut lines = Vec::new();
    for line in solution.lines().map(str::trim) {
        let has_words = line.contains(char::is_alphanumeric);
        let is_code = has_words && !line.starts_with("//") && !line.contains("missing!(");
        if is_code && !given.contains(&line) {
            lines.push(line);
        }
    }
    if lines.is_empty() {
        return None;
    }
    lines.sort_unstable();
    let lines = lines.join("\n");
    Some(format!(
        "{BEGINNING}, sorted by their letters, without indents,\ncomments and brackets that stand \
         alone. Which line needs the result of which?\n\n```text\n{lines}\n```"
    ))
}
