//! `CheckAll`: checks every file that the student has begun, one after the other.

use std::fmt;
use std::time::Duration;

use console::Key;

use crate::exercise::Exercise;
use crate::files;
use crate::judgement::judge;
use crate::keys::Typed;
use crate::phase::Phase;
use crate::progress::Progress;
use crate::screen::Space;
use crate::watch::Session;

const KEYS: &str = "s stop  q quit";

/// What came of it.
#[derive(Default)]
pub struct CheckAll {
    /// The names of the files that are right, and of those that are not.
    pub done: Vec<&'static str>,
    pub open: Vec<&'static str>,
    /// Whether it has been stopped before the last file.
    pub is_stopped: bool,
    /// Whether the student wants to quit.
    pub quits: bool,
}

impl CheckAll {
    /// Checks all, and tells the watcher what is checked. It answers whether the checks go on.
    pub fn run(
        course: &[Exercise],
        progress: &mut Progress,
        space: Space,
        watcher: &mut dyn FnMut(&str, Phase, Duration) -> bool,
    ) -> Self {
        let mut all = Self::default();
        let begun: Vec<_> = course.iter().filter(|e| files::is_begun(e)).collect();
        for (number, e) in begun.iter().enumerate() {
            let words = format!(", {} of {}: {}", number + 1, begun.len(), e.name);
            let report = judge(e, progress, space, &mut |phase, elapsed| {
                all.is_stopped |= !watcher(&words, phase, elapsed);
                !all.is_stopped
            });
            if all.is_stopped {
                break;
            }
            let names = if report.is_done {
                &mut all.done
            } else {
                &mut all.open
            };
            names.push(e.name);
        }
        all
    }

    /// Checks all; a key stops it.
    pub fn run_with_keys(session: &mut Session) -> Self {
        let Session {
            course,
            progress,
            screen,
            keys,
            ..
        } = session;
        screen.show("checking all files\n", "");
        let mut quits = false;
        let mut shown = String::new();
        let mut all = Self::run(
            course,
            progress,
            screen.space(),
            &mut |words, phase, elapsed| {
                let status = format!("{}  {KEYS}", phase.words(words, elapsed));
                if shown != status {
                    screen.show_status(&status);
                    shown = status;
                }
                match keys.read(Duration::ZERO) {
                    Typed::Key(Key::Char('s')) => false,
                    Typed::Key(Key::Char('q') | Key::CtrlC) => {
                        quits = true;
                        false
                    }
                    _ => true,
                }
            },
        );
        all.quits = quits;
        all
    }
}

impl fmt::Display for CheckAll {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (done, open) = (self.done.len(), self.open.len());
        write!(
            f,
            "{} files are checked, {done} of them are done",
            done + open
        )?;
        if open > 0 {
            write!(f, "; open: {}", self.open.join(", "))?;
        }
        if self.is_stopped {
            write!(f, "; stopped before the last")?;
        }
        Ok(())
    }
}
