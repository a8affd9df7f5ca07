//! `Log`: a file with a line for each state of the window, which the tests read.

use std::fs::File;
use std::io::Write;

/// The file that the environment variable `WORKBOOK_WINDOW_LOG` names, if it is set.
pub struct Log {
    file: Option<File>,
    last: String,
}

impl Log {
    pub fn open() -> Self {
        let path = std::env::var_os("WORKBOOK_WINDOW_LOG");
        Self {
            file: path.and_then(|path| File::create(path).ok()),
            last: String::new(),
        }
    }

    pub const fn is_open(&self) -> bool {
        self.file.is_some()
    }

    /// Writes a state unless it is the last one.
    pub fn write(&mut self, state: String) {
        if let Some(file) = &mut self.file
            && state != self.last
        {
            let _ = writeln!(file, "{state}");
            self.last = state;
        }
    }
}
