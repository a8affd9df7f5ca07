//! `List`: the exercises on the terminal, to choose one: with the arrow keys, or by words of its name
//! and title.

#[cfg(test)]
mod tests;

use std::time::Duration;

use console::{Key, style, truncate_str};

use crate::exercise::Exercise;
use crate::keys::Typed;
use crate::progress::Progress;
use crate::watch::Session;

/// Time between two looks at the size of the terminal.
const PAUSE: Duration = Duration::from_millis(100);

/// Lines above and below the exercises.
const FRAME: usize = 5;

const KEYS: &str = "↑ ↓ Enter  / search  Esc back  q quit";

/// What the reader leaves the list for.
pub enum Choice {
    Exercise(&'static Exercise),
    /// The exercise from which the list was opened.
    Back,
    Quit,
}

struct List {
    course: &'static [Exercise],
    /// The words that are searched for.
    words: String,
    /// Whether keys are letters of these words.
    is_searching: bool,
    /// The chosen one of the exercises that are listed.
    chosen: usize,
    /// The first one that the terminal shows.
    top: usize,
}

/// Lets the reader choose an exercise, first the current one.
pub fn choose(current: &Exercise, session: &mut Session) -> Choice {
    let Session {
        course,
        progress,
        screen,
        keys,
        ..
    } = session;
    let mut list = List::new(course, current);
    let mut shown = None;
    loop {
        let size = screen.size().unwrap_or((24, 80));
        if shown != Some(size) {
            screen.show(&list.lines(progress, size).join("\n"), "");
            shown = Some(size);
        }
        match keys.read(PAUSE) {
            Typed::Nothing => {}
            Typed::End | Typed::Key(Key::CtrlC) => return Choice::Quit,
            Typed::Key(key) => {
                if let Some(choice) = list.obey(&key, size.0) {
                    return choice;
                }
                shown = None;
            }
        }
    }
}

impl List {
    fn new(course: &'static [Exercise], current: &Exercise) -> Self {
        Self {
            course,
            words: String::new(),
            is_searching: false,
            chosen: course.iter().position(|e| e == current).unwrap_or(0),
            top: 0,
        }
    }

    /// The exercises that are listed.
    fn listed(&self) -> Vec<&'static Exercise> {
        let words = self.words.to_lowercase();
        let mut listed = Vec::new();
        for e in self.course {
            let text = format!("{} {} {}", e.stage, e.name, e.title).to_lowercase();
            if text.contains(&words) {
                listed.push(e);
            }
        }
        listed
    }

    /// Does what a key asks for.
    fn obey(&mut self, key: &Key, rows: usize) -> Option<Choice> {
        if self.is_searching {
            self.search(key);
            return None;
        }
        let listed = self.listed();
        let last = listed.len().saturating_sub(1);
        let page = rows.saturating_sub(FRAME + 1).max(1);
        match key {
            Key::ArrowUp => self.chosen = self.chosen.saturating_sub(1),
            Key::ArrowDown => self.chosen = (self.chosen + 1).min(last),
            Key::PageUp => self.chosen = self.chosen.saturating_sub(page),
            Key::PageDown => self.chosen = (self.chosen + page).min(last),
            Key::Home => self.chosen = 0,
            Key::End => self.chosen = last,
            Key::Char('/') => {
                self.is_searching = true;
                self.words.clear();
            }
            Key::Enter => return listed.get(self.chosen).copied().map(Choice::Exercise),
            Key::Escape | Key::Char('l') => return Some(Choice::Back),
            Key::Char('q') => return Some(Choice::Quit),
            _ => {}
        }
        None
    }

    fn search(&mut self, key: &Key) {
        match key {
            Key::Enter => self.is_searching = false,
            Key::Escape => {
                self.is_searching = false;
                self.words.clear();
            }
            Key::Backspace => {
                self.words.pop();
            }
            Key::Char(letter) if !letter.is_control() => self.words.push(*letter),
            _ => {}
        }
        self.chosen = 0;
    }

    /// The screen with its rows and columns.
    fn lines(&mut self, progress: &Progress, (rows, columns): (usize, usize)) -> Vec<String> {
        let listed = self.listed();
        self.chosen = self.chosen.min(listed.len().saturating_sub(1));
        let visible = rows.saturating_sub(FRAME).max(1);
        self.top = self
            .top
            .min(self.chosen)
            .max((self.chosen + 1).saturating_sub(visible));

        let shown = listed.iter().enumerate().skip(self.top).take(visible);
        let fitted = |text: &str| truncate_str(text, columns.saturating_sub(1), "…").into_owned();
        let first = (self.top + 1).min(listed.len());
        let last = listed.len().min(self.top + visible);
        let mut heading = format!("exercises {first} to {last} of {}", listed.len());
        if !self.words.is_empty() {
            heading += " with ";
            heading += &self.words;
        }
        let mut lines = vec![fitted(&heading), String::new()];
        for (number, e) in shown {
            let is_chosen = number == self.chosen;
            let sign = if is_chosen { '>' } else { ' ' };
            let row = style(fitted(&format!("{sign} {}", progress.row(e))));
            let row = match is_chosen {
                true => row.reverse(),
                false if progress.is_done(e) => row.green(),
                false => row,
            };
            lines.push(row.to_string());
        }
        lines.push(String::new());
        lines.push(fitted(&if self.is_searching {
            format!("/{}_  Enter keeps it, Esc shows all", self.words)
        } else {
            KEYS.to_owned()
        }));
        lines
    }
}
