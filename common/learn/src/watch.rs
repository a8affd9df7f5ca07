//! `watch`: shows an exercise, and checks the file whenever it is saved.

use crate::exercise::Exercise;
use crate::keys::Keys;
use crate::page::{Page, Step};
use crate::progress::Progress;
use crate::screen::Screen;
use crate::session::Session;
use crate::student_file;

const END: &str = "all exercises are done; `cargo learn program FOLDER` brings your functions into your own program";

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
