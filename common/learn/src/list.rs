//! `List`: the exercises on the terminal, to choose one: with the arrow keys, by words of its name
//! and title, among all, open or done ones.

#[cfg(test)]
mod tests;

use std::time::Duration;

use console::{Key, style, truncate_str};

use crate::exercise::Exercise;
use crate::files;
use crate::keys::Typed;
use crate::progress::Progress;
use crate::watch::Session;

/// Time between two looks at the size of the terminal.
const PAUSE: Duration = Duration::from_millis(100);

/// Lines above and below the exercises.
const FRAME: usize = 4;

const KEYS: &str = "↑ ↓ Enter  / search  f filter  x reset  Esc back  q quit";

/// Which exercises are listed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Filter {
    All,
    Open,
    Done,
}

impl Filter {
    fn next(self) -> Self {
        match self {
            Self::All => Self::Open,
            Self::Open => Self::Done,
            Self::Done => Self::All,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Open => "open",
            Self::Done => "done",
        }
    }
}

/// What keys mean.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    Choosing,
    /// They are letters of the words that are searched for.
    Searching,
    /// They answer the question whether a file begins again.
    Resetting,
}

/// What the reader leaves the list for.
pub enum Choice {
    Exercise(&'static Exercise),
    /// The exercise from which the list was opened.
    Back,
    Quit,
}

struct List {
    course: &'static [Exercise],
    filter: Filter,
    words: String,
    mode: Mode,
    /// The chosen one of the exercises that are listed.
    chosen: usize,
    /// The first one that the terminal shows.
    top: usize,
    message: String,
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
            screen.replace(&list.lines(progress, size));
            shown = Some(size);
        }
        match keys.read(PAUSE) {
            Typed::Nothing => {}
            Typed::End | Typed::Key(Key::CtrlC) => return Choice::Quit,
            Typed::Key(key) => {
                if let Some(choice) = list.obey(&key, progress, size.0) {
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
            filter: Filter::All,
            words: String::new(),
            mode: Mode::Choosing,
            chosen: course.iter().position(|e| e == current).unwrap_or(0),
            top: 0,
            message: String::new(),
        }
    }

    /// The exercises that are listed.
    fn listed(&self, progress: &Progress) -> Vec<&'static Exercise> {
        let words = self.words.to_lowercase();
        let mut listed = Vec::new();
        for e in self.course {
            let is_wanted = match self.filter {
                Filter::All => true,
                Filter::Open => !progress.is_done(e),
                Filter::Done => progress.is_done(e),
            };
            let text = format!("{} {} {}", e.stage, e.name, e.title).to_lowercase();
            if is_wanted && text.contains(&words) {
                listed.push(e);
            }
        }
        listed
    }

    /// Does what a key asks for.
    fn obey(&mut self, key: &Key, progress: &Progress, rows: usize) -> Option<Choice> {
        self.message.clear();
        match self.mode {
            Mode::Searching => self.search(key),
            Mode::Resetting => self.answer(key, progress),
            Mode::Choosing => return self.choose(key, progress, rows),
        }
        None
    }

    fn search(&mut self, key: &Key) {
        match key {
            Key::Enter => self.mode = Mode::Choosing,
            Key::Escape => {
                self.mode = Mode::Choosing;
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

    fn answer(&mut self, key: &Key, progress: &Progress) {
        self.mode = Mode::Choosing;
        if *key != Key::Char('y') {
            return;
        }
        if let Some(e) = self.listed(progress).get(self.chosen) {
            self.message = files::reset(e).unwrap_or_else(|problem| problem);
        }
    }

    fn choose(&mut self, key: &Key, progress: &Progress, rows: usize) -> Option<Choice> {
        let listed = self.listed(progress);
        let last = listed.len().saturating_sub(1);
        let page = rows.saturating_sub(FRAME + 1).max(1);
        match key {
            Key::ArrowUp | Key::Char('k') => self.chosen = self.chosen.saturating_sub(1),
            Key::ArrowDown | Key::Char('j') => self.chosen = (self.chosen + 1).min(last),
            Key::PageUp => self.chosen = self.chosen.saturating_sub(page),
            Key::PageDown => self.chosen = (self.chosen + page).min(last),
            Key::Home | Key::Char('g') => self.chosen = 0,
            Key::End | Key::Char('G') => self.chosen = last,
            Key::Char('/') => {
                self.mode = Mode::Searching;
                self.words.clear();
            }
            Key::Char('f') => {
                self.filter = self.filter.next();
                self.chosen = 0;
            }
            Key::Char('x') if !listed.is_empty() => self.mode = Mode::Resetting,
            Key::Enter => return listed.get(self.chosen).copied().map(Choice::Exercise),
            Key::Escape | Key::Char('l') => return Some(Choice::Back),
            Key::Char('q') => return Some(Choice::Quit),
            _ => {}
        }
        None
    }

    /// The screen with its rows and columns.
    fn lines(&mut self, progress: &Progress, (rows, columns): (usize, usize)) -> Vec<String> {
        let listed = self.listed(progress);
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
        let (all, filter) = (listed.len(), self.filter.name());
        let mut heading = format!("exercises {first} to {last} of {all}: {filter}");
        if !self.words.is_empty() {
            heading += " with ";
            heading += &self.words;
        }
        let mut lines = vec![fitted(&heading), String::new()];
        for (number, e) in shown {
            let row = fitted(&row(e, progress, number == self.chosen));
            let is_done = progress.is_done(e);
            lines.push(if number == self.chosen {
                style(row).reverse().to_string()
            } else if is_done {
                style(row).green().to_string()
            } else {
                row
            });
        }
        lines.push(String::new());
        lines.push(fitted(&self.footer(&listed)));
        lines
    }

    /// The last line: what the keys do now.
    fn footer(&self, listed: &[&Exercise]) -> String {
        let words = &self.words;
        match self.mode {
            Mode::Searching => format!("/{words}_  Enter keeps it, Esc shows all"),
            Mode::Resetting => {
                let name = listed.get(self.chosen).map_or("", |e| e.name);
                format!("begin {name} again? your file is kept; y yes, other keys no")
            }
            Mode::Choosing if !self.message.is_empty() => self.message.replace('\n', "; "),
            Mode::Choosing => KEYS.to_owned(),
        }
    }
}

fn row(e: &Exercise, progress: &Progress, is_chosen: bool) -> String {
    let sign = if is_chosen { '>' } else { ' ' };
    let mark = progress.mark(e);
    let stage = e.stage.split('-').next().unwrap_or_default();
    let path = if e.is_core { "core" } else { "" };
    let (name, title, minutes) = (e.name, e.title, e.minutes);
    format!("{sign} {mark:5}  {stage} {path:4}  {name:17} {minutes:>2} min  {title}")
}
