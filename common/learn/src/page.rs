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
use crate::session::{PAUSE, Session};
use crate::student_file::{self, Saved};

const CHOOSE: &str = "up and down, or k and j, choose an exercise of any stage, and Enter opens it";
const KEYS: &str = "h hint  n next  l list  q quit";
const KEYS_OF_CHECK: &str = "s stop  h hint  n next  q quit";

/// Where the student goes.
pub enum Step {
    Following,
    To(&'static Exercise),
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
    /// The number of the exercise that is chosen in the list; none while no list is shown.
    chosen: Option<usize>,
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
            chosen: None,
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
        self.chosen = None;
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
        if let Some(chosen) = self.chosen.take() {
            let last = session.course.len() - 1;
            match key {
                Key::Enter => return Ok(Some(Step::To(&session.course[chosen]))),
                Key::ArrowUp | Key::Char('k') => self.chosen = Some(chosen.saturating_sub(1)),
                Key::ArrowDown | Key::Char('j') => self.chosen = Some(last.min(chosen + 1)),
                _ => {}
            }
            if self.chosen.is_some() {
                self.show_list(session);
                return Ok(None);
            }
        }
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
            Key::Char('l') => {
                self.chosen = session.course.iter().position(|other| other == e);
                self.show_list(session);
            }
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

    /// The exercises of the stage in which one is chosen, which fit below the task; empty if none is.
    fn list(&self, session: &Session) -> String {
        let Some(chosen) = self.chosen.map(|number| &session.course[number]) else {
            return String::new();
        };
        let mut lines = Vec::new();
        for e in session.course.iter().filter(|e| e.stage == chosen.stage) {
            let mark = if e == chosen { "> " } else { "  " };
            lines.push(format!("{mark}{}", session.progress.row(e)));
        }
        lines.push(CHOOSE.to_owned());
        session.screen.wrap(&lines.join("\n"))
    }

    fn show_list(&self, session: &Session) {
        session
            .screen
            .show(&self.text(session), &self.list(session));
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
