//! `Log`: a file with a line for each state of the window, which the tests read.

use std::fs::File;
use std::io::Write;

use common::fnv1a;

use super::drawing::Look;
use super::input::Input;

/// The file that the environment variable `WORKBOOK_WINDOW_LOG` names, if it is set.
pub struct Log {
    file: Option<File>,
    picture: Option<u64>,
    last: String,
}

impl Log {
    pub fn open() -> Self {
        let path = std::env::var_os("WORKBOOK_WINDOW_LOG");
        Self {
            file: path.and_then(|path| File::create(path).ok()),
            picture: None,
            last: String::new(),
        }
    }

    /// Remembers the hash of a finished picture as it is drawn; none of an unfinished one.
    pub fn set_picture(&mut self, pixels: Option<&[u32]>) {
        self.picture = pixels.filter(|_| self.file.is_some()).map(|pixels| {
            let bytes = pixels.iter().flat_map(|color| color.to_le_bytes());
            fnv1a(&bytes.collect::<Vec<_>>())
        });
    }

    /// Writes a state, unless it is the last one.
    pub fn write(&mut self, look: &Look, input: &Input) {
        if let Some(file) = &mut self.file {
            let state = format!("{look:?} {input:?} picture: {:?}", self.picture);
            if state != self.last {
                let _ = writeln!(file, "{state}");
                self.last = state;
            }
        }
    }
}
