//! `Page`: an exercise on the screen, from its task to what its check says, and what its keys do.

mod words;

use std::mem;
use std::time::Duration;

use common::text;
use console::Key;

use crate::check::check_file;
use crate::exercise::Exercise;
use crate::hints::hints;
use crate::keys::Typed;
use crate::report::Report;
use crate::screen::Screen;
use crate::student_file::{self, Saved};
use crate::watch::{PAUSE, Session};

const KEYS: &str = "h hint  n next  l list  q quit";
const KEYS_OF_CHECK: &str = "s stop  h hint  n next  q quit";

/// Where the student goes.
pub enum Step {
    Following,
    Quit,
}

/// An exercise on the screen.
pub struct Page {
    pub exercise: &'static Exercise,
    /// What the check says about the file.
    report: Option<Report>,
    /// The file that the report is about; none if the file is to be checked.
    checked: Option<Saved>,
    /// Answers to keys since the check.
    notes: Vec<String>,
    /// How many hints have been asked for.
    hints: usize,
    /// The width for which it is drawn.
    width: Option<usize>,
}

impl Page {
    pub fn new(exercise: &'static Exercise) -> Self {
        Self {
            exercise,
            report: None,
            checked: None,
            notes: Vec::new(),
            hints: 0,
            width: None,
        }
    }

    /// Checks the file whenever it is saved, and obeys keys, until the student goes on.
    pub fn work(&mut self, session: &mut Session) -> Result<Step, String> {
        loop {
            let saved = student_file::saved(self.exercise);
            let mut key = None;
            if self.checked != Some(saved) {
                self.checked = Some(saved);
                if saved.is_some() {
                    key = self.check(session, saved);
                } else {
                    self.say_deleted(session);
                }
            } else if self.width != session.screen.width() {
                self.draw(session);
            }
            self.say_other_saved(session);
            let typed = match key {
                _ if session.screen.is_closed() => Typed::End,
                Some(key) => Typed::Key(key),
                None => session.keys.read(PAUSE),
            };
            match typed {
                Typed::Nothing => {}
                Typed::End => return Ok(Step::Quit),
                Typed::Key(key) => {
                    if let Some(step) = self.obey(&key, session)? {
                        return Ok(step);
                    }
                }
            }
        }
    }

    /// Checks the file. Returns a key that has stopped the check.
    fn check(&mut self, session: &mut Session, saved: Saved) -> Option<Key> {
        let e = self.exercise;
        let Session {
            progress,
            screen,
            keys,
            ..
        } = session;
        self.report = None;
        self.notes.clear();
        self.width = screen.width();
        screen.show(&self.task_and_notes(screen), "");
        let mut stopping_key = None;
        let mut shown = String::new();
        let report = check_file(e, progress, screen.space(), &mut |phase, elapsed| {
            let status = format!("{}  {KEYS_OF_CHECK}", phase.words(elapsed));
            if shown != status {
                screen.show_status(&status);
                shown = status;
            }
            match keys.read(Duration::ZERO) {
                Typed::Key(Key::Char('h')) => {
                    let hint = self.next_hint(screen);
                    self.notes.push(hint.clone());
                    screen.show(&self.task_and_notes(screen), &hint);
                    shown.clear();
                }
                Typed::Key(Key::Char('s')) => return false,
                Typed::Key(key @ (Key::Char('n' | 'q') | Key::CtrlC)) => {
                    stopping_key = Some(key);
                    return false;
                }
                // No other key stops a check.
                _ => {}
            }
            student_file::saved(e) == saved
        });
        self.report = Some(report);
        // After another save the next check follows at once.
        if student_file::saved(e) == saved && stopping_key.is_none() {
            self.draw(session);
        }
        stopping_key
    }

    fn say_deleted(&mut self, session: &Session) {
        self.report = None;
        self.notes.clear();
        let file = student_file::path(self.exercise);
        let note = format!("{} is deleted; Enter begins it again", text::path(&file));
        self.note(session, &note);
    }

    /// Says that the file of another exercise is saved, which nothing checks here.
    fn say_other_saved(&mut self, session: &mut Session) {
        let saved: Vec<_> = session.course.iter().map(student_file::saved).collect();
        let before = mem::replace(&mut session.saved, saved);
        let all = session.course.iter().zip(&before).zip(&session.saved);
        let mut other = None;
        for ((e, before), now) in all {
            if before != now && now.is_some() && e != self.exercise {
                other = Some(e.name);
            }
        }
        let Some(name) = other else {
            return;
        };
        let note = format!(
            "{name}.rs is saved, the file of another exercise: `cargo learn {name}` checks it"
        );
        if self.notes.last() != Some(&note) {
            self.note(session, &note);
        }
    }

    /// Does what a key asks for.
    fn obey(&mut self, key: &Key, session: &mut Session) -> Result<Option<Step>, String> {
        let e = self.exercise;
        match key {
            Key::Char('q') | Key::CtrlC => return Ok(Some(Step::Quit)),
            Key::Char('n') => return Ok(Some(Step::Following)),
            Key::Enter if session.progress.is_done(e) => return Ok(Some(Step::Following)),
            Key::Enter => {
                student_file::begin(e)?;
                self.checked = None;
            }
            Key::Char('h') => {
                let hint = self.next_hint(&session.screen);
                self.note(session, &hint);
            }
            Key::Char('l') => self.list(session),
            // A stray key of a terminal changes nothing; a wrong line in a pipe is answered.
            _ if session.screen.is_terminal() => {}
            _ => self.note(session, KEYS),
        }
        Ok(None)
    }

    /// The hint after the last one that was asked for.
    fn next_hint(&mut self, screen: &Screen) -> String {
        let hints = hints(self.exercise);
        let Some(hint) = hints.get(self.hints) else {
            self.hints = 0;
            self.notes.clear();
            return "there is no further hint; h shows the first one again".to_owned();
        };
        self.hints += 1;
        screen.wrap_markdown(hint.trim())
    }

    /// Lists the exercises of the stage, which fit below the task.
    fn list(&mut self, session: &Session) {
        let mut lines = Vec::new();
        for e in session.course {
            if e.stage == self.exercise.stage {
                lines.push(session.progress.row(e));
            }
        }
        lines.push("`cargo learn list` has all stages, `cargo learn NAME` begins one".to_owned());
        self.note(session, &lines.join("\n"));
    }

    /// Adds an answer to a key.
    fn note(&mut self, session: &Session, note: &str) {
        self.notes.push(note.to_owned());
        session.screen.show(&self.text(session), note);
    }

    fn draw(&mut self, session: &Session) {
        self.width = session.screen.width();
        let text = self.text(session);
        session.screen.show(&text, &text);
    }
}
