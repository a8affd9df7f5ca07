//! `defence`: questions about the lines of a student's own program, which are the known mistakes of an open sheet.

use std::fmt::Write;

use common::row::{self, Row};
use judge::pictures::Sheet;
use learn::files;
use learn::sheet::{find, read_all};

/// The folder of the mistakes, a file for each sheet.
const MISTAKES: &str = "a07-transforms/lab/sheets/mistakes";

/// Lists questions about a student's program for an open sheet, with their answers
#[derive(clap::Args)]
pub struct Defence {
    /// The sheet, such as glass
    name: String,
}

impl Defence {
    /// Returns the questions.
    pub fn run(&self) -> Result<String, String> {
        let sheets = read_all()?;
        let sheet = find(&sheets, &self.name)?;
        let file = format!("{MISTAKES}/{}.toml", sheet.name);
        let text = files::read(&file)?;
        row::read(&file, &text, |mistakes| questions(sheet, mistakes))
    }
}

/// The edit that makes a mistake, the fact that fails first with both numbers, and the reason.
fn questions(sheet: &Sheet, mistakes: &Row) -> Result<String, String> {
    let mut questions = format!(
        "{}: in the program of the student I make one edit. Which fact fails first, and why?\n",
        sheet.title
    );
    for (number, row) in (1..).zip(mistakes.rows("mistake")?) {
        let text = |key| row.get::<String>(key);
        let (edit, fails) = (text("edit")?, text("fails")?);
        let (measured, forgets) = (text("measured")?, text("forgets")?);
        let fact = sheet.facts.iter().find(|fact| fact.name == fails);
        let fact = fact.ok_or_else(|| row.error("fails", "must be a fact of the sheet"))?;
        let _ = write!(
            questions,
            "\n{number}. {edit}\n   {fails}: {}\n   measured: {measured}; right: {} = {}\n   overlooked: {forgets}\n",
            fact.says, fact.value, fact.formula
        );
    }
    let name = &sheet.name;
    let _ = write!(
        questions,
        "\nTo see it, make the edit in a copy of the program: cargo learn sheet {name} COPY"
    );
    Ok(questions)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_sheet_has_questions_with_both_numbers() {
        for sheet in read_all().unwrap() {
            let questions = Defence {
                name: sheet.name.clone(),
            };
            let questions = questions.run().unwrap();
            for fact in &sheet.facts {
                let words = format!("\n   {}: {}\n   measured: ", fact.name, fact.says);
                assert!(questions.contains(&words), "{words}: {questions}");
            }
        }
    }
}
