//! `Press`: a key that has been pressed.

use winit::event::{ElementState, KeyEvent};
use winit::keyboard::{Key, ModifiersState, NamedKey};

/// A pressed key.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Press {
    /// The name of the key, such as `S`, `Ctrl +` or `Shift Left`.
    pub key: String,
    /// The text that it types.
    pub text: String,
}

impl Press {
    /// The press that an event reports; none for a release, and for a letter that repeats itself.
    pub fn new(event: &KeyEvent, modifiers: ModifiersState) -> Option<Self> {
        let is_letter = matches!(event.logical_key, Key::Character(_));
        let typed = event.text.as_deref().unwrap_or_default();
        let mut press = Self::of(&event.logical_key, modifiers, typed)?;
        if event.repeat && is_letter {
            // A held letter fills a text, and does not repeat a command.
            press.key.clear();
        }
        (event.state == ElementState::Pressed).then_some(press)
    }

    fn of(key: &Key, modifiers: ModifiersState, typed: &str) -> Option<Self> {
        // On a Mac, commands have the key Command.
        let command = if cfg!(target_os = "macos") {
            ModifiersState::SUPER
        } else {
            ModifiersState::CONTROL
        };
        let is_command = modifiers.contains(command);
        let (name, takes_shift) = match key {
            Key::Named(NamedKey::Space) => ("Space".to_owned(), false),
            Key::Named(named) => {
                let name = format!("{named:?}");
                (name.trim_start_matches("Arrow").to_owned(), true)
            }
            Key::Character(text) if text.as_str() == "=" => ("+".to_owned(), false),
            Key::Character(text) => (text.to_uppercase(), false),
            Key::Unidentified(_) | Key::Dead(_) => return None,
        };
        let prefix = if is_command {
            "Ctrl "
        } else if takes_shift && modifiers.shift_key() {
            "Shift "
        } else {
            ""
        };
        let is_text = !is_command && !modifiers.alt_key() && !typed.contains(char::is_control);
        let text = if is_text { typed } else { "" };
        Some(Self {
            key: format!("{prefix}{name}"),
            text: text.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_the_names_that_the_menu_shows() {
        let command = if cfg!(target_os = "macos") {
            ModifiersState::SUPER
        } else {
            ModifiersState::CONTROL
        };
        let named = Key::Named;
        let letter = |text: &str| Key::Character(text.into());
        for (key, modifiers, typed, name, text) in [
            (letter("s"), ModifiersState::empty(), "s", "S", "s"),
            (letter("S"), ModifiersState::SHIFT, "S", "S", "S"),
            (letter("s"), command, "\u{13}", "Ctrl S", ""),
            (letter("="), command, "=", "Ctrl +", ""),
            (letter("/"), ModifiersState::empty(), "/", "/", "/"),
            (
                named(NamedKey::Space),
                ModifiersState::empty(),
                " ",
                "Space",
                " ",
            ),
            (
                named(NamedKey::Tab),
                ModifiersState::empty(),
                "\t",
                "Tab",
                "",
            ),
            (
                named(NamedKey::Tab),
                ModifiersState::SHIFT,
                "",
                "Shift Tab",
                "",
            ),
            (
                named(NamedKey::Backspace),
                ModifiersState::empty(),
                "\u{8}",
                "Backspace",
                "",
            ),
            (
                named(NamedKey::Enter),
                ModifiersState::empty(),
                "\r",
                "Enter",
                "",
            ),
            (
                named(NamedKey::ArrowLeft),
                ModifiersState::SHIFT,
                "",
                "Shift Left",
                "",
            ),
        ] {
            let press = Press::of(&key, modifiers, typed).unwrap();
            assert_eq!((press.key.as_str(), press.text.as_str()), (name, text));
        }
    }
}
