//! Shows students the faults of their code.

use std::collections::BTreeSet;
use std::env;
use std::panic::{self, Location, PanicHookInfo};
use std::process::ExitCode;
use std::sync::Mutex;

use judge::answers::{BEGUN, MARK, Mode, Record, SECONDS, WORDS_MARK, print_answers};

use super::corpus::ask_corpus;
use super::exercise::{Exercise, StudentPicture};
use super::findings::Reader;
use super::folder::StageFolder;
use super::hang::name_hang;
use super::{Entry, Missing, take_missing};

/// Asks the student's file of the exercise that the argument names.
#[must_use]
pub fn run(folder: &StageFolder, entries: Vec<Entry>) -> ExitCode {
    let name = env::args().nth(1).unwrap_or_default();
    let entry = entries.into_iter().find(|entry| entry.name == name);
    if let Some(entry) = entry {
        return ask_student(folder, &entry);
    }
    say(&format!(
        "this program has no exercise {name:?}: `cargo learn` builds it for one, and `cargo course prove` for all"
    ));
    ExitCode::FAILURE
}

/// Runs the examples of a student's file, asks its code, prints the findings, and exits with
/// 0 if the code is right, with 1 if it is not, and with [`BEGUN`] if parts are still missing.
fn ask_student(folder: &StageFolder, entry: &Entry) -> ExitCode {
    let name = entry.name;
    let mut exercise = (entry.exercise)();
    // A starter's examples fail, and nothing is wrong yet.
    let is_begun = folder.is_begun(name);
    let lines = Mutex::new(BTreeSet::new());
    panic::set_hook(Box::new(move |panic| {
        let line = panic.location().map_or(0, Location::line);
        // A line may panic for each input, and in each row of a picture.
        if is_begun && lines.lock().is_ok_and(|mut lines| lines.insert(line)) {
            say(&panic_words(name, panic));
        }
    }));
    if let Some(seconds) = env::var(SECONDS).ok().and_then(|n| n.parse().ok()) {
        name_hang(seconds, say);
    }
    let mode = Mode::of_environment();
    if mode == Mode::Corpus {
        let words = ask_corpus(name, &exercise);
        // Code that is not written answers each ray by a miss.
        if !take_missing().is_empty() {
            return ExitCode::from(BEGUN);
        }
        say(&words);
        return ExitCode::SUCCESS;
    }
    let record = match folder.record(name, &mut exercise) {
        Ok(record) => record,
        Err(problem) => {
            say(&problem);
            return ExitCode::FAILURE;
        }
    };
    let is_printed = mode.prints_answers();
    if let Some(question) = record.unanswered().filter(|_| !is_printed) {
        say(&format!(
            "the question {} has no answer yet, which this records: \
             INSTA_UPDATE=always cargo course prove {name}",
            question.arguments
        ));
    }
    let reader = if is_printed {
        Reader::Grader
    } else {
        Reader::Student
    };
    // The grader compares, and its right answers are not where a student's program could read them.
    let right = (!is_printed).then_some(&record);
    let found = exercise.run(entry.examples, right, folder, reader);
    if let Some(image) = found.image.filter(|_| !is_printed) {
        say(&folder.save(&image, &format!("{}-{name}.png", folder.stage().name)));
    }
    if !found.missing.is_empty() {
        for Missing { what, line } in &found.missing {
            say(&format!(
                "to do: {what}\n    in {name}.rs, line {line}, instead of `testing::missing(…)`"
            ));
        }
        return ExitCode::from(BEGUN);
    }
    for words in &found.verdict.wrong {
        say(words);
    }
    if let Some(words) = &found.verdict.known {
        say(words);
    }
    if is_printed {
        print!("{}", print_answers(&found.given, found.painted.as_ref()));
    }
    if mode == Mode::Mistake {
        record_picture(folder, &exercise);
        let record = Record {
            mistakes: Vec::new(),
            ..record.with_answers(exercise.right_answers())
        };
        print!("{MARK}{record}");
    }
    ExitCode::from(u8::from(!found.verdict.wrong.is_empty()))
}

/// Where the author records, saves the picture of a scene with few samples, with which checks compare.
fn record_picture(folder: &StageFolder, exercise: &Exercise<()>) {
    let records = env::var("INSTA_UPDATE").is_ok_and(|update| update == "always");
    let StudentPicture::Scene(scene, _) = &exercise.picture else {
        return;
    };
    if records && let Err(error) = folder.record_picture(scene) {
        say(&format!("the picture of scene {scene}: {error}"));
    }
}

/// The words about a panic of a student's code, which may happen in a library.
fn panic_words(name: &str, panic: &PanicHookInfo) -> String {
    let message = panic.payload_as_str().unwrap_or_default();
    let own_file = format!("{name}.rs");
    let (file, line) = match panic.location() {
        Some(location) if !location.file().ends_with(&own_file) => {
            (location.file(), location.line())
        }
        location => (&*own_file, location.map_or(0, Location::line)),
    };
    format!("{file}, line {line}: {message}")
}

/// Prints words, for a student each line behind a mark.
fn say(words: &str) {
    let is_marked = !Mode::of_environment().prints_answers();
    for line in words.lines() {
        if is_marked {
            println!("{WORDS_MARK}{line}");
        } else {
            println!("{line}");
        }
    }
}
