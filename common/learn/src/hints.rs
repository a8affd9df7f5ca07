//! The hints of an exercise. The last one of a core exercise is a Parsons problem: the lines of a solution in another
//! order. (Parsons and Haden, Parson's Programming Puzzles, 2006)

use std::iter;

use crate::exercise::Exercise;
use crate::files;
use crate::starter::starter;

/// The first words of the last hint.
const BEGINNING: &str = "These are the lines of a solution";

/// The hints, from gentle to plain, each below its number; last, of a core exercise, the lines
/// of a solution.
pub fn hints(e: &Exercise) -> Vec<String> {
    let lines = lines(e);
    let count = e.hints.len() + usize::from(lines.is_some());
    let words = e.hints.iter().map(|words| (*words).to_owned());
    let mut hints = Vec::new();
    for (number, words) in iter::zip(1.., words.chain(lines)) {
        hints.push(format!("Hint {number} of {count}\n\n{words}"));
    }
    hints
}

/// The lines that a solution has and the starter lacks, sorted by their letters; none of an exercise
/// beyond the core path.
fn lines(e: &Exercise) -> Option<String> {
    if !e.is_core {
        return None;
    }
    let solution = files::read(&e.solution_file()).ok()?;
    let starter = starter(e).ok()?;
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::exercise::read_all;

    /// Each exercise has its task, files and hints; starters lack something, and those of the core
    /// path name its steps.
    #[test]
    fn exercises_have_their_files() {
        let mut names = BTreeSet::new();
        for e in read_all().unwrap() {
            let (name, starter) = (e.name, starter(e).unwrap());
            assert!(names.insert(name), "{name} is the name of two exercises");
            assert!(!e.task().is_empty(), "{name}: its title heads no section");
            for part in ["testing::missing(", "testing::examples!"] {
                assert!(starter.contains(part), "{name}: {part}");
            }
            assert!(!starter.contains("missing!("), "{name}");
            if e.is_core {
                let parts = starter.matches("testing::missing(").count();
                for step in ["// 1. ", "// 2. "] {
                    assert_eq!(starter.matches(step).count(), parts, "{name}: {step}");
                }
            }
            let hints = hints(e);
            assert!(
                hints.len() > usize::from(e.is_core),
                "exercises.toml lacks a hint of {name}"
            );
            let last = hints.last().unwrap();
            assert_eq!(last.contains(BEGINNING), e.is_core, "{name}: {last}");
            assert!(
                files::shortest(e.solution).exists(),
                "{name} lacks {}",
                e.solution
            );
            assert_eq!(!e.solution.contains("/solutions/"), e.is_core, "{name}");
            let check = format!("{}/tests/exercises/{name}.rs", e.stage);
            assert!(files::shortest(&check).exists(), "{name} lacks {check}");
        }
    }
}
