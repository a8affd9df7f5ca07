//! `Session`: what all pages share, from the first exercise to the last.

use std::time::Duration;

use crate::exercise::Exercise;
use crate::keys::Keys;
use crate::progress::Progress;
use crate::screen::Screen;
use crate::student_file::Saved;

/// Time between two looks at the file and the keyboard.
pub const PAUSE: Duration = Duration::from_millis(50);

/// The exercises, which of them are done, and the terminal.
pub struct Session {
    pub course: &'static [Exercise],
    pub progress: Progress,
    pub screen: Screen,
    pub keys: Keys,
    /// The files of all exercises when they were last looked at.
    pub saved: Vec<Saved>,
}
