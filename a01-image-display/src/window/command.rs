//! `Command`: the commands of the window, by key, by menu or by mouse.

use common::Renderer;
use minifb::Key;

/// A command of the window. Two numbers are a way to the right and down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    Save,
    Open,
    Close,
    Scene(usize),
    RenderWith(Renderer),
    /// Zooms in or out.
    Zoom(bool),
    Fit,
    /// Makes letters larger or smaller.
    Letters(bool),
    Theme,
    /// Shows a page of the panel, or hides it.
    Page(Page),
    Reset,
    /// Explains the pixel under the mouse, or in the middle.
    Explain,
    /// Chooses the slider of a number.
    Slider(usize),
    Arrow(i32, i32),
    Turn(i32, i32),
    Pan(i32, i32),
    /// Scrolls the panel by lines.
    Scroll(i32),
    /// Executes the selected entry of the menu.
    Choose,
    /// Leaves the selected entry, else the explained pixel, else closes the window.
    Escape,
}

/// A page of the panel beside the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    Menu,
    /// The numbers of the scene, by sliders.
    Scene,
    /// The numbers behind a pixel.
    Pixel,
}

use Command::{Letters, RenderWith, Zoom};

/// The menu, with the characters that are typed for its entries.
pub const MENU: [(&str, &str, Command); 16] = [
    ("Save as PNG", "S", Command::Save),
    ("Open …", "Ctrl O", Command::Open),
    ("Close", "Ctrl W", Command::Close),
    ("The lesson", "L", RenderWith(Renderer::Lesson)),
    ("The engine, --fast", "E", RenderWith(Renderer::Engine)),
    ("All work, --no-omit", "A", RenderWith(Renderer::AllWork)),
    ("All back to the start", "R", Command::Reset),
    ("Explain a pixel", "I", Command::Explain),
    ("Zoom in", "+", Zoom(true)),
    ("Zoom out", "-", Zoom(false)),
    ("Fit to the window", "0", Command::Fit),
    ("Larger letters", "Ctrl +", Letters(true)),
    ("Smaller letters", "Ctrl -", Letters(false)),
    ("Dark or light", "D", Command::Theme),
    ("Numbers of the scene", "N", Command::Page(Page::Scene)),
    ("This menu", "H", Command::Page(Page::Menu)),
];

/// The effects of the mouse and of the other keys.
pub const HELP: [(&str, &str); 8] = [
    ("Previous, next scene", "← →"),
    ("Menu, sliders, pixels", "↑ ↓ ← →"),
    ("Choose; back or close", "Enter; Esc"),
    ("Zoom, scroll", "wheel, Page ↑ ↓"),
    ("Move the picture", "drag, Shift ← →"),
    ("Turn the camera", "right drag, Ctrl ← →"),
    ("Explain a pixel", "click"),
    ("Fit to the window", "double click"),
];

/// Pixels of the mouse's way that an arrow key stands for.
const WAY: i32 = 20;

impl Command {
    /// The command of a key, with or without Ctrl and Shift.
    pub fn of_key(key: Key, ctrl: bool, shift: bool) -> Option<Self> {
        let arrow = |x, y| match (ctrl, shift) {
            (true, _) => Self::Turn(WAY * x, WAY * y),
            (_, true) => Self::Pan(-WAY * x, -WAY * y),
            _ => Self::Arrow(x, y),
        };
        Some(match key {
            Key::Left => arrow(-1, 0),
            Key::Right => arrow(1, 0),
            Key::Up => arrow(0, -1),
            Key::Down => arrow(0, 1),
            Key::PageUp => Self::Scroll(-8),
            Key::PageDown => Self::Scroll(8),
            Key::F1 | Key::F10 => Self::Page(Page::Menu),
            Key::Tab => Self::Page(Page::Scene),
            Key::Enter | Key::NumPadEnter => Self::Choose,
            Key::Escape => Self::Escape,
            _ => return None,
        })
    }

    /// The command of a character; Ctrl and a letter are a control character.
    pub fn of_character(character: char, ctrl: bool) -> Option<Self> {
        let letter = match character {
            '\0'..=' ' => char::from(character as u8 + b'@'),
            '=' => '+',
            letter => letter.to_ascii_uppercase(),
        };
        let has_ctrl = ctrl || character < ' ';
        let key = if has_ctrl {
            format!("Ctrl {letter}")
        } else {
            letter.to_string()
        };
        let mut menu = MENU.iter();
        // Ctrl changes nothing for a letter that has a meaning without it.
        let found = menu.find(|(_, known, _)| *known == key || "Ctrl S" == key && *known == "S");
        found.map(|(.., command)| *command)
    }
}
