//! The words of a page, as wide as the screen.

use common::text;
use console::style;

use super::{KEYS, Page};
use crate::files;
use crate::report::Report;
use crate::screen::Screen;
use crate::session::Session;
use crate::starter::starter;
use crate::student_file;

const SAVE: &str = "save the file to check it";
const NEXT: &str = "Enter: the next exercise";

impl Page {
    /// The page while the file is checked: the task, and answers to keys.
    pub(super) fn task_and_notes(&self, screen: &Screen) -> String {
        let mut parts = vec![
            self.heading(screen),
            screen.wrap_markdown(&self.exercise.task()),
        ];
        parts.extend(self.notes.iter().map(|note| screen.wrap(note)));
        parts.join("\n\n") + "\n"
    }

    /// The page after a check: the task, the verdict, answers to keys, what is done, and the keys.
    pub(super) fn text(&self, session: &Session) -> String {
        let screen = &session.screen;
        let mut parts = vec![
            self.heading(screen),
            screen.wrap_markdown(&self.exercise.task()),
        ];
        if let Some(report) = &self.report {
            parts.push(self.verdict(report, screen));
            if report.is_done {
                let opened = session.progress.opened_by(session.course, self.exercise);
                parts.extend(opened.map(|words| screen.wrap(&words)));
            }
        }
        parts.extend(self.notes.iter().map(|note| screen.wrap(note)));
        parts.extend(self.chosen.map(|_| self.list(session)));
        parts.push(session.progress.summary(session.course));
        parts.push(screen.wrap(&self.keys()));
        parts.join("\n\n")
    }

    fn heading(&self, screen: &Screen) -> String {
        let e = self.exercise;
        let (title, minutes, file) = (e.title, e.minutes, student_file::path(e));
        let heading = format!("{title}, {minutes} minutes, in {}", text::path(&file));
        screen.link(&screen.wrap(&heading), &file)
    }

    /// What the check says, and where the solution is if there is nothing more to say.
    fn verdict(&self, report: &Report, screen: &Screen) -> String {
        let details = report.details(screen);
        let verdict = style(screen.wrap(&report.verdict)).bold();
        if !report.is_done {
            return format!("{details}{verdict}");
        }
        let verdict = verdict.green();
        // A workbook without solutions has starters in their place.
        let solution = files::read(self.exercise.solution);
        if solution.is_err() || solution == starter(self.exercise) {
            return format!("{details}{verdict}");
        }
        let solution = files::shortest(self.exercise.solution);
        let place = format!("solution: {}", text::path(&solution));
        format!("{details}{verdict}\n{}", screen.link(&place, &solution))
    }

    /// What the keys do.
    fn keys(&self) -> String {
        let is_done = self.report.as_ref().is_some_and(|report| report.is_done);
        format!("{}\n{KEYS}", if is_done { NEXT } else { SAVE })
    }
}
