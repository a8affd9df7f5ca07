//! Copies: hand-ins whose code is that of another student or of the workbook, but for names, comments and layout.
//!
//! This finds what is copied as it is. The page for lecturers names tools that find more.

use std::collections::{BTreeMap, BTreeSet};

use crate::outcome::Graded;
use crate::structure::Structure;

/// Whose code the workbook's own is.
const WORKBOOK: &str = "the workbook";

/// The workbook's own code, by the names of exercises and sheets.
#[derive(Debug, Default)]
pub struct WorkbooksCode(BTreeMap<String, Vec<Structure>>);

impl WorkbooksCode {
    pub fn add(&mut self, name: &str, text: &str) {
        let of_name = self.0.entry(name.to_owned()).or_default();
        of_name.extend(Structure::read(text));
    }
}

/// Writes into each hand-in who else has the same code, and returns a line for each.
pub fn mark(graded: &mut [Graded], workbooks: &WorkbooksCode) -> Vec<String> {
    let mut owners = BTreeMap::<_, BTreeSet<&str>>::new();
    for (name, structures) in &workbooks.0 {
        for structure in structures {
            owners
                .entry((name, structure))
                .or_default()
                .insert(WORKBOOK);
        }
    }
    for student in &*graded {
        for judged in &student.results {
            for file in &judged.files {
                let owners = owners.entry((&judged.name, &file.structure)).or_default();
                owners.insert(&student.name);
            }
        }
    }
    let mut same = Vec::new();
    for student in &*graded {
        for judged in &student.results {
            // The student's files that agree, by the others.
            let mut others = BTreeMap::<&str, Vec<&str>>::new();
            for file in &judged.files {
                for owner in &owners[&(&judged.name, &file.structure)] {
                    others.entry(owner).or_default().push(&file.path);
                }
            }
            others.remove(&*student.name);
            let others = others.iter();
            let words = others.map(|(other, files)| format!("{other} ({})", files.join(", ")));
            same.push(words.collect::<Vec<_>>().join(", "));
        }
    }
    let mut lines = Vec::new();
    let mut same = same.into_iter();
    for student in graded {
        for judged in &mut student.results {
            judged.same_code_as = same.next().unwrap_or_default();
            if !judged.same_code_as.is_empty() {
                let (name, others) = (&judged.name, &judged.same_code_as);
                lines.push(format!("  {name} of {}: as that of {others}", student.name));
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Judged, Outcome, State};
    use crate::structure::ComparedFile;

    /// A function whose name, comment and layout a copy changes, or whose number differs.
    fn code(name: &str, comment: &str, number: u32) -> String {
        let line = format!("{comment}\n    {name}_sum = {name}_sum * x + f64::from({number});\n");
        let lines = line.repeat(20);
        format!(
            "pub fn {name}(x: f64) -> f64 {{\n    let mut {name}_sum = x;\n{lines}    {name}_sum\n}}\n"
        )
    }

    #[test]
    fn copies_are_found_under_other_names() {
        let hand_in = |student: &str, code: &str| Graded {
            name: student.to_owned(),
            file_name: student.to_owned(),
            results: vec![Judged {
                stage: "sheet",
                name: "glass".to_owned(),
                file: String::new(),
                files: vec![ComparedFile {
                    path: "src/glass.rs".to_owned(),
                    structure: Structure::read(code).unwrap(),
                }],
                same_code_as: String::new(),
                outcome: Outcome::without_answers(State::Right, ""),
            }],
        };
        let mut graded = [
            hand_in("ada", &code("refract", "", 3)),
            hand_in("bob", &code("bend", "// my own\n\n", 3)),
            hand_in(
                "eva",
                &format!("//! Mine.\n{}", code("bend", "/// Mine, too.\n", 3)),
            ),
            hand_in("cleo", &code("refract", "", 4)),
            hand_in("dan", &code("solved", "", 5)),
        ];
        let mut workbooks = WorkbooksCode::default();
        workbooks.add("glass", &code("answer", "", 5));
        let lines = mark(&mut graded, &workbooks);
        let same: Vec<_> = graded
            .iter()
            .map(|of| &*of.results[0].same_code_as)
            .collect();
        let [ada, bob, eva, workbook] =
            ["ada", "bob", "eva", WORKBOOK].map(|other| format!("{other} (src/glass.rs)"));
        let pair = |a: &str, b: &str| format!("{a}, {b}");
        let expected = [pair(&bob, &eva), pair(&ada, &eva), pair(&ada, &bob)];
        assert_eq!(same[..3], expected);
        assert_eq!(same[3..], ["", &*workbook]);
        let line = "  glass of bob: as that of ada (src/glass.rs), eva (src/glass.rs)";
        assert_eq!(lines[1], line);
    }
}
