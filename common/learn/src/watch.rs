//! `watch`: shows an exercise, and checks the file whenever it is saved.

use std::time::Duration;

use crate::exercise::Exercise;
use crate::keys::Keys;
use crate::page::{Page, Step};
use crate::progress::Progress;
use crate::screen::Screen;
use crate::student_file::{self, Saved};

/// Time between two looks at the file and the keyboard.
pub const PAUSE: Duration = Duration::from_millis(50);

const END: &str = "all exercises are done; `cargo learn program FOLDER` brings your functions into your own program";

/// What all pages share: the exercises, which of them are done, and the terminal.
pub struct Session {
    pub course: &'static [Exercise],
    pub progress: Progress,
    pub screen: Screen,
    pub keys: Keys,
    /// The files of all exercises when they were last looked at.
    pub saved: Vec<Saved>,
}

/// Shows one exercise after the other until the student quits. Returns how many are done.
pub fn watch(course: &'static [Exercise], first: &'static Exercise) -> Result<String, String> {
    let mut session = Session {
        course,
        progress: Progress::read(),
        screen: Screen::new(),
        keys: Keys::default(),
        saved: course.iter().map(student_file::saved).collect(),
    };
    let mut page = Page::new(first);
    loop {
        student_file::begin(page.exercise)?;
        page = match page.work(&mut session)? {
            Step::Quit => break,
            Step::To(chosen) => Page::new(chosen),
            Step::Following => match session.progress.next(course, Some(page.exercise)) {
                Some(next) => Page::new(next),
                None => return Ok(format!("{}\n{END}", session.progress.summary(course))),
            },
        };
    }
    Ok(session.progress.summary(course))
}
