//! `mistake`: adds the mistake of a student's file to those that are known. From then on, whoever makes it
//! reads the fact that it overlooks.

use std::fs;
use std::path::PathBuf;

use common::text;
use judge::answers::{
    KnownMistake, MODE, Mode, Record, StudentAnswer, read_answers, read_right_answers, verdict,
};
use learn::exercise::{self as exercises, Exercise};
use learn::files::{self, with_path};

use crate::exercise_grading::run;
use crate::exercise_record::{record, record_file};
use crate::grading_folder::GradingFolder;
use crate::sandbox::End;
use crate::submission::StudentFile;

/// Gives the mistake of a student's file a sentence, which everybody reads who makes it
#[derive(clap::Args)]
pub struct Mistake {
    /// A file of the exercise whose name it has, such as sphere.rs
    file: PathBuf,
    /// The fact that it overlooks: students read "it overlooks that FACT", such as "t counts steps"
    fact: String,
    /// Records a known fact anew, or also by this program
    #[arg(long)]
    again: bool,
}

impl Mistake {
    /// Judges the file, and adds its answers to the recorded ones of the exercise.
    pub fn run(self, course: &'static [Exercise]) -> Result<String, String> {
        let fact = fact(&self.fact)?;
        let name = self.file.file_stem().unwrap_or_default().to_string_lossy();
        let e = exercises::find(&name.to_lowercase())
            .map_err(|problem| format!("{name} is no exercise: {problem}"))?;
        let bytes = fs::read(&self.file).map_err(with_path(&self.file))?;
        let students = text::from_file(bytes)?;
        let mut record = record(e)?;
        let is_known = record.mistakes.iter().any(|known| known.overlooks == fact);
        if is_known && !self.again {
            return Err(format!(
                "a known mistake overlooks that {fact}; with --again, this program's answers count, too"
            ));
        }
        if let Some(question) = record.unanswered() {
            let arguments = &question.arguments;
            return Err(format!("the question {arguments} has no right answer yet"));
        }
        let folder = GradingFolder::new(course, &[e])?;
        let file = StudentFile {
            exercise: e,
            text: &students,
        };
        let output = output(&folder, file)?;
        let (given, _) = read_answers(&output);
        self.check_is_unknown(&record, &given, fact)?;

        let mistake = KnownMistake::new(fact, &record.questions, &read_right_answers(&output));
        let count = mistake.wrong_count();
        let has_same_answers = |known: &KnownMistake| {
            let alone = Record {
                mistakes: vec![known.clone()],
                ..record.clone()
            };
            verdict(&alone, &given).known.is_some()
        };
        let mut known = record.mistakes.iter();
        match known.position(|known| known.overlooks == fact && has_same_answers(known)) {
            Some(place) => record.mistakes[place] = mistake,
            None => record.mistakes.push(mistake),
        }
        let questions: Vec<_> = given.into_iter().map(|given| given.question).collect();
        for known in &record.mistakes {
            let proved = record.prove(known, &questions);
            let overlooks = &known.overlooks;
            proved.map_err(|problem| {
                format!("this record would not tell apart the mistake that overlooks that {overlooks}: {problem}")
            })?;
        }
        let file = files::workspace().join(record_file(e));
        fs::write(&file, record.to_string()).map_err(with_path(&file))?;
        Ok(format!(
            "{} has {count} wrong answers of it; whoever makes it reads: it overlooks that {fact}",
            record_file(e)
        ))
    }

    /// An error if the answers are right, or those of another known mistake.
    fn check_is_unknown(
        &self,
        record: &Record,
        given: &[StudentAnswer],
        fact: &str,
    ) -> Result<(), String> {
        let found = verdict(record, given);
        if found.differ == 0 {
            let why = "its answers are right; a mistake that only its picture or an example shows is not recorded";
            return Err(why.to_owned());
        }
        match found.known {
            Some(known) if !(self.again && known.ends_with(&format!(" that {fact}"))) => Err(known),
            _ => Ok(()),
        }
    }
}

/// The words that complete "it overlooks that".
fn fact(words: &str) -> Result<&str, String> {
    let fact = words.trim().trim_end_matches('.');
    let fact = fact.strip_prefix("that ").unwrap_or(fact);
    if fact.is_empty() || fact.contains(char::is_control) {
        return Err(
            "the fact is words on one line, which complete \"it overlooks that\"".to_owned(),
        );
    }
    Ok(fact)
}

/// The output of a student's program that answers all questions.
fn output(folder: &GradingFolder, file: StudentFile) -> Result<String, String> {
    let asked = format!("{MODE}={}", Mode::Mistake.name());
    let ended = match run(folder, file, &["env".as_ref(), asked.as_ref()])? {
        Ok(ended) => ended,
        Err(outcome) => return Err(text::message(&outcome.message)),
    };
    let (given, _) = read_answers(&ended.output);
    let panics = given.iter().find(|given| given.answer.is_none());
    match (&ended.end, panics) {
        (End::Begun, _) => Err("a part of it is still to do".to_owned()),
        (End::Success | End::Failure, Some(given)) => {
            Err(format!("it panics at: {}", given.question))
        }
        (End::Success | End::Failure, None) if !given.is_empty() => Ok(ended.output),
        _ => Err(text::message(
            &folder.sandbox.words(&ended, "it gives no answers"),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fact_completes_the_sentence() {
        for words in ["t counts steps", " that t counts steps. "] {
            assert_eq!(fact(words), Ok("t counts steps"));
        }
        for words in ["", " . ", "two\nlines"] {
            assert!(fact(words).is_err(), "{words}");
        }
    }
}
