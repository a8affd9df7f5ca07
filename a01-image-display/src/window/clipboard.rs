//! `Clipboard`: texts that other programs copy and paste.

/// The clipboard of the system, which is asked for when it is first needed.
#[derive(Default)]
pub struct Clipboard(Option<arboard::Clipboard>);

impl Clipboard {
    fn system(&mut self) -> Result<&mut arboard::Clipboard, arboard::Error> {
        let known = match self.0.take() {
            Some(known) => known,
            None => arboard::Clipboard::new()?,
        };
        Ok(self.0.insert(known))
    }

    /// Copies a text. On X11 it is lost when the program ends, unless another program keeps it.
    pub fn copy(&mut self, text: &str) -> Result<(), String> {
        let copied = self.system().and_then(|system| system.set_text(text));
        copied.map_err(|error| format!("the clipboard cannot be written: {error}"))
    }

    /// The copied text.
    pub fn text(&mut self) -> Result<String, String> {
        let text = self.system().and_then(arboard::Clipboard::get_text);
        text.map_err(|error| format!("the clipboard cannot be read: {error}"))
    }
}
