//! Checks a student's file: builds the test program of a stage with it, and runs it.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, io};

use common::text;
use judge::answers::{MODE, Mode, SECONDS};

use crate::build::{Build, build};
use crate::exercise::Exercise;
use crate::files;
use crate::output::OutputReader;
use crate::phase::{Phase, Watcher};
use crate::process::{limited, run};
use crate::progress::Progress;
use crate::public_items::{PublicItem, public_items};
use crate::refusal::refusal;
use crate::report::Report;
use crate::screen::Space;
use crate::starter::starter;
use crate::student_file;

/// The longest time in seconds that a check may take, unless the variable [`SECONDS`] is another.
const MAX_SECONDS: u64 = 10;

/// The folder of the checks in a stage.
const CHECKS: &str = "tests/exercises/";

/// Checks a student's file, and records whether it is done. Output is cut to the space.
pub fn check_file(e: &Exercise, progress: &mut Progress, space: Space, watcher: Watcher) -> Report {
    let file = student_file::path(e);
    let text = match files::text_of(&file) {
        Ok(text) => text,
        Err(problem) => return Report::new(e, &problem),
    };
    let mut report = match build_and_run(e, Mode::Student, space, watcher) {
        Ok(Some(report)) => report,
        Ok(None) => return Report::new(e, "stopped"),
        Err(problem) => return Report::new(e, &problem),
    };
    // A lecturer's grader does not judge such a file.
    if let Some(refused) = refusal(e, &text) {
        if !report.words.is_empty() {
            report.words.push('\n');
        }
        report.words += &refused;
        if report.is_done {
            report.is_done = false;
            report.verdict = Report::new(e, "not yet").verdict;
        }
    }
    if let Err(problem) = progress.record(e, &text, report.is_done) {
        report
            .words
            .extend(["what is done is not kept: ", &problem]);
    }
    report
}

/// What a student's shape answers to the rays of the corpus.
pub fn ask_corpus(e: &Exercise, space: Space, watcher: Watcher) -> Result<String, String> {
    let report = build_and_run(e, Mode::Corpus, space, watcher)?;
    Ok(match report {
        Some(report) if report.is_done => report.words,
        Some(report) => report.verdict,
        None => String::new(),
    })
}

/// Builds and runs the check in a mode. There is no report if the watcher stops it.
fn build_and_run(
    e: &Exercise,
    mode: Mode,
    space: Space,
    watcher: Watcher,
) -> Result<Option<Report>, String> {
    match build(e, space, watcher)? {
        Build::Program(program) => {
            let mut check = limited(program.as_ref());
            check.arg(e.name).env(MODE, mode.name());
            run_program(e, check, program.as_ref(), space, watcher)
        }
        Build::Failed(printed) => Ok(Some(does_not_compile(e, &printed))),
        Build::Stopped => Ok(None),
    }
}

/// The compiler's words, without errors in the check, into which they would send the student.
fn does_not_compile(e: &Exercise, printed: &str) -> Report {
    let file = student_file::path(e);
    let text = files::text_of(&file).unwrap_or_default();
    let (message, place) = first_error(printed);
    let is_own = place.starts_with(&*text::path(&file));
    let lacks = lacks(e, &text);
    if let Some(lacks) = lacks.as_ref().filter(|_| !is_own) {
        return Report::new(e, lacks);
    }
    if printed.contains(CHECKS)
        && let Some(differs) = differing_signature(e, &text)
    {
        return Report::new(e, &differs);
    }
    if place.contains(CHECKS) {
        let words = format!(
            "it does not fit the check: {message}; look at the names and types of the starter"
        );
        return Report::new(e, &words);
    }
    let errors = printed.split("\n\n");
    let own: Vec<_> = errors.filter(|error| !error.contains(CHECKS)).collect();
    Report {
        printed: own.join("\n\n"),
        words: lacks.unwrap_or_default(),
        ..Report::new(e, "does not compile")
    }
}

/// A public function of the starter that takes or returns other types in a student's file, in words.
fn differing_signature(e: &Exercise, text: &str) -> Option<String> {
    let yours = public_items(text).ok()?;
    let wanted = starter(e).and_then(|starter| public_items(&starter));
    for item in wanted.ok()? {
        let is_other = |other: &&PublicItem| other.name == item.name && other.types != item.types;
        if item.beginning.ends_with(&format!("fn {}", item.name))
            && let Some(other) = yours.iter().find(is_other)
        {
            let (yours, starter) = (&other.signature, &item.signature);
            return Some(format!(
                "`{yours}` must be `{starter}`, as the check calls it"
            ));
        }
    }
    None
}

/// The public items of the starter that a student's file lacks, in words; none if all are there, or if the file
/// cannot be read.
#[must_use]
pub fn lacks(e: &Exercise, text: &str) -> Option<String> {
    let yours = public_items(text).ok()?;
    let wanted = starter(e).and_then(|starter| public_items(&starter));
    let mut lacking = Vec::new();
    for item in wanted.ok()? {
        if !yours.iter().any(|other| other.name == item.name) {
            lacking.push(format!("`{}`", item.beginning));
        }
    }
    (!lacking.is_empty()).then(|| format!("the file lacks {}", lacking.join(" and ")))
}

/// The compiler's first error, and its file and line.
fn first_error(printed: &str) -> (String, String) {
    let plain = console::strip_ansi_codes(printed);
    let mut lines = plain.lines().skip_while(|line| !line.starts_with("error"));
    let message = lines.next().and_then(|line| line.split_once(": "));
    let (_, message) = message.unwrap_or_default();
    let place = lines.find_map(|line| line.trim_start().strip_prefix("--> "));
    (message.to_owned(), place.unwrap_or_default().to_owned())
}

/// Runs the test program. There is no report if the watcher stops it.
fn run_program(
    e: &Exercise,
    mut check: Command,
    program: &Path,
    space: Space,
    watcher: Watcher,
) -> Result<Option<Report>, String> {
    let with_path = files::with_path(program);
    let (output, to_output) = io::pipe().map_err(&with_path)?;
    check.env("RUST_BACKTRACE", "0");
    check.stdout(to_output.try_clone().map_err(&with_path)?);
    check.stderr(to_output);
    let output = OutputReader::start(output);

    let limit = env::var(SECONDS).ok();
    let seconds = limit.and_then(|n| n.parse().ok()).unwrap_or(MAX_SECONDS);
    check.env(SECONDS, seconds.to_string());
    let limit = Duration::from_secs(seconds);
    let start = Instant::now();
    let status = run(check, &mut || {
        let elapsed = start.elapsed();
        elapsed < limit && watcher(Phase::Checking, elapsed)
    });
    let is_late = start.elapsed() >= limit;
    let output = output.finish();
    let (is_done, verdict) = match status.map_err(with_path)? {
        Some(status) if status.success() => (true, "done".to_owned()),
        Some(_) if output.overflows_stack() => (
            false,
            "the stack overflows, probably by a recursion without end".to_owned(),
        ),
        Some(_) if output.exhausts_memory() => (
            false,
            "it needs more memory than the limit of 2 GiB, probably for a list that grows without end".to_owned(),
        ),
        // The program says why.
        Some(_) => (false, "not yet".to_owned()),
        None if is_late => (
            false,
            format!("no end after {seconds} seconds, probably a loop without end"),
        ),
        None => return Ok(None),
    };
    let printed = output.beginning(space.lines);
    // What a student's program prints may move the cursor.
    let printed = text::message(&printed.replace('\t', "    "));
    Ok(Some(Report {
        is_done,
        printed,
        words: text::message(&output.words),
        ..Report::new(e, &verdict)
    }))
}

#[cfg(test)]
mod tests {
    use super::first_error;

    #[test]
    fn the_first_error_is_no_warning() {
        let [own, check] = ["exercises/own.rs:1:2", "tests/exercises/own.rs:3:4"];
        let warning = format!("warning: unused\n --> {check}\n");
        let colored =
            format!("\u{1b}[1merror[E0308]\u{1b}[0m: types\n  \u{1b}[94m--> \u{1b}[0m{own}\n");
        let note = format!("note: called here\n --> {check}\n");
        let error = |message: &str, place: &str| (message.to_owned(), place.to_owned());
        let printed = [warning, colored, note].concat();
        assert_eq!(first_error(&printed), error("types", own));
        let of_check = format!("error: no such function\n --> {check}\n");
        assert_eq!(first_error(&of_check), error("no such function", check));
        assert_eq!(first_error("error: no target"), error("no target", ""));
    }
}
