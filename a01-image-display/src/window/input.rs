//! `Input`: mouse and keyboard, the commands that they give, and their execution.

use std::mem;

use minifb::{MouseButton, MouseMode};
use program::Gallery;

use super::command::Command;
use super::menu_bar::{ITEMS, PLATFORM_HAS_MENU};
use super::placement::Zoom;
use super::screen::Screen;
use super::{NO_FILE, choose_file};

/// Mouse and keyboard at the last update.
#[derive(Debug, Default)]
pub struct Input {
    /// Whether the window has the keyboard.
    pub is_active: bool,
    /// Whether the left button of the mouse is down.
    pub is_down: bool,
    /// The pixel of the window under the mouse.
    pub cursor: Option<(i32, i32)>,
}

impl Screen {
    /// The commands since the last call, by key, menu and click.
    pub fn commands(&mut self) -> Vec<Command> {
        let cursor = self.window.get_mouse_pos(MouseMode::Discard);
        let input = Input {
            is_active: self.window.is_active(),
            is_down: self.window.get_mouse_down(MouseButton::Left),
            cursor: cursor.map(|(x, y)| (x as i32, y as i32)),
        };
        let before = mem::replace(&mut self.input, input);
        // Releases of keys are not reported while another window has the keyboard.
        if before.is_active && !self.input.is_active {
            self.keyboard.release_all();
        }
        let mut commands = Vec::new();
        for typed in self.keyboard.take() {
            commands.extend(self.menu.handle(typed));
        }
        let chosen = self.window.is_menu_pressed().and_then(|id| ITEMS.get(id));
        commands.extend(chosen.map(|(.., command)| *command));
        if let (Some((x, y)), false) = (self.input.cursor, PLATFORM_HAS_MENU) {
            // A mouse that rests leaves the menu to the keys.
            if self.input.cursor != before.cursor {
                self.menu.hover(x, y);
            }
            if self.input.is_down && !before.is_down {
                commands.extend(self.menu.click(x, y));
            }
        }
        commands
    }

    /// Executes a command other than `Close`. True if another picture is to be rendered.
    pub fn execute(&mut self, command: Command, gallery: &mut Gallery) -> bool {
        match command {
            Command::Next => gallery.go_to_next(),
            Command::Previous => gallery.go_to_previous(),
            Command::Open if gallery.opens_files() => {
                let Some(file) = choose_file() else {
                    self.notify(NO_FILE.to_owned());
                    return false;
                };
                gallery.open(file);
            }
            _ => {
                self.change_view(command, gallery);
                return false;
            }
        }
        self.title = gallery.title();
        self.window.set_title(&self.title);
        self.menu.can_open = gallery.opens_files();
        self.zoom = Zoom::Fit;
        self.notice = None;
        self.outcome = None;
        true
    }

    /// Executes a command for the picture that is shown. The menu has handled the others.
    fn change_view(&mut self, command: Command, gallery: &Gallery) {
        let (placement, cursor) = (self.placement(), self.input.cursor);
        match command {
            Command::Save => self.save(gallery),
            Command::Inspect => self.inspects = !self.inspects,
            Command::Help => self.helps = !self.helps,
            Command::ZoomIn => self.zoom = placement.zoomed_in(cursor),
            Command::ZoomOut => self.zoom = placement.zoomed_out(cursor),
            Command::ZoomReset => self.zoom = Zoom::Fit,
            _ => {}
        }
    }

    fn save(&mut self, gallery: &Gallery) {
        self.notify(match &self.outcome {
            None => "the picture is not finished yet".to_owned(),
            Some(Err(_)) => "there is no picture to save".to_owned(),
            Some(Ok(image)) => match gallery.save(image) {
                Ok(path) => format!("saved {}", path.display()),
                Err(error) => format!("error: {error}"),
            },
        });
    }
}
