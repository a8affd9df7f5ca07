//! `PathEntry`: a line in which a person types or pastes the path of a file.

use std::path::PathBuf;

use program::Gallery;

use super::keyboard::Press;
use super::screen::Screen;

/// A path that is being typed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PathEntry {
    text: String,
}

/// What a key did to the line.
#[derive(Debug, PartialEq, Eq)]
pub enum Typed {
    /// The line stays, with more or fewer letters.
    Stays,
    /// The path is complete.
    Opens(PathBuf),
    /// No path is wanted any more.
    Cancelled,
}

impl PathEntry {
    /// The line as it is shown.
    pub fn prompt(&self) -> String {
        format!(
            "Open: {}|    Enter opens, Ctrl V pastes, Esc cancels",
            self.text
        )
    }

    /// Adds a pasted text. File managers copy an address, or a path in quotation marks.
    pub fn paste(&mut self, text: &str) {
        let line = text.lines().next().unwrap_or_default().trim();
        let line = line.strip_prefix("file://").unwrap_or(line);
        self.text.push_str(line.trim_matches(['"', '\'']));
    }

    /// Takes a key.
    pub fn take(&mut self, press: &Press) -> Typed {
        match press.key.as_str() {
            "Escape" => return Typed::Cancelled,
            "Enter" if self.text.trim().is_empty() => return Typed::Cancelled,
            "Enter" => return Typed::Opens(PathBuf::from(self.text.trim())),
            "Backspace" => {
                self.text.pop();
            }
            "Ctrl Backspace" | "Ctrl U" => self.text.clear(),
            _ => self.text.push_str(&press.text),
        }
        Typed::Stays
    }
}

impl Screen {
    /// Lets the line for a path take a key, if there is one. Returns the key for the window.
    pub fn type_path(&mut self, press: Press, gallery: &mut Gallery) -> String {
        if press.key == "Ctrl V" {
            match self.clipboard.text() {
                Ok(text) => self.path_entry.get_or_insert_default().paste(&text),
                Err(reason) => self.notify_error(&reason),
            }
            return String::new();
        }
        let Some(entry) = &mut self.path_entry else {
            return press.key;
        };
        match entry.take(&press) {
            Typed::Stays => {}
            Typed::Cancelled => self.path_entry = None,
            Typed::Opens(path) => {
                self.path_entry = None;
                self.open_file(&path, gallery);
            }
        }
        String::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(key: &str, text: &str) -> Press {
        Press {
            key: key.to_owned(),
            text: text.to_owned(),
        }
    }

    #[test]
    fn a_path_is_typed_corrected_and_opened() {
        let mut entry = PathEntry::default();
        for (key, text) in [("A", "a"), ("Ä", "ä"), ("Backspace", ""), (".", ".")] {
            assert_eq!(entry.take(&press(key, text)), Typed::Stays);
        }
        entry.paste("toml\n");
        let opens = Typed::Opens("a.toml".into());
        assert_eq!(entry.take(&press("Enter", "")), opens);
        assert_eq!(entry.take(&press("Escape", "")), Typed::Cancelled);
        assert_eq!(
            PathEntry::default().take(&press("Enter", "")),
            Typed::Cancelled
        );
    }

    #[test]
    fn a_pasted_address_is_a_path() {
        for pasted in ["file:///a b/w.toml\r\n", "\"/a b/w.toml\"", " /a b/w.toml "] {
            let mut entry = PathEntry::default();
            entry.paste(pasted);
            let opens = Typed::Opens("/a b/w.toml".into());
            assert_eq!(entry.take(&press("Enter", "")), opens, "{pasted}");
        }
    }
}
