//! The commands from keys, menu and mouse, and their execution.

use minifb::MouseButton;
use program::Gallery;

use super::Screen;
use crate::window::command::Command;
use crate::window::menu_bar::{ITEMS, PLATFORM_HAS_MENU};
use crate::window::placement::Zoom;
use crate::window::{NO_FILE, choose_file};

/// The mouse at the last update.
#[derive(Default)]
pub(super) struct Mouse {
    is_down: bool,
    cursor: Option<(i32, i32)>,
}

/// The work that remains after a command.
pub(super) enum After {
    Nothing,
    Render,
    Close,
}

impl Screen {
    /// The commands since the last call, by key, menu and click.
    pub(super) fn commands(&mut self) -> Vec<Command> {
        // Releases of keys are not reported while another window has the keyboard.
        let is_active = self.window.is_active();
        if self.is_active && !is_active {
            self.keyboard.release_all();
        }
        self.is_active = is_active;
        let mut commands = Vec::new();
        for typed in self.keyboard.take() {
            commands.extend(self.menu.handle(typed));
        }
        let chosen = self.window.is_menu_pressed().and_then(|id| ITEMS.get(id));
        commands.extend(chosen.map(|item| item.command));

        let mouse = Mouse {
            is_down: self.window.get_mouse_down(MouseButton::Left),
            cursor: self.cursor(),
        };
        if let Some((x, y)) = mouse.cursor.filter(|_| !PLATFORM_HAS_MENU) {
            // A mouse that rests leaves the menu to the keys.
            if mouse.cursor != self.mouse.cursor {
                self.menu.hover(x, y);
            }
            if mouse.is_down && !self.mouse.is_down {
                commands.extend(self.menu.click(x, y));
            }
        }
        self.mouse = mouse;
        commands
    }

    pub(super) fn execute(&mut self, command: Command, gallery: &mut Gallery) -> After {
        match command {
            Command::Close => return After::Close,
            Command::Save => self.save(gallery),
            Command::Open if gallery.opens_files() => match choose_file() {
                Some(file) => {
                    gallery.open(file);
                    return self.change_to(gallery);
                }
                None => self.notify(NO_FILE.to_owned()),
            },
            Command::Next => {
                gallery.go_to_next();
                return self.change_to(gallery);
            }
            Command::Previous => {
                gallery.go_to_previous();
                return self.change_to(gallery);
            }
            Command::Inspect => self.inspects = !self.inspects,
            Command::Help => self.helps = !self.helps,
            Command::ZoomIn => self.zoom = self.placement().zoomed_in(self.cursor()),
            Command::ZoomOut => self.zoom = self.placement().zoomed_out(self.cursor()),
            Command::ZoomReset => self.zoom = Zoom::Fit,
            // The menu has handled the rest.
            _ => {}
        }
        After::Nothing
    }

    fn change_to(&mut self, gallery: &Gallery) -> After {
        self.title = gallery.title();
        self.window.set_title(&self.title);
        self.menu.can_open = gallery.opens_files();
        self.zoom = Zoom::Fit;
        self.notice = None;
        self.outcome = None;
        After::Render
    }

    fn save(&mut self, gallery: &Gallery) {
        let notice = match &self.outcome {
            None => "the picture is not finished yet".to_owned(),
            Some(Err(_)) => "there is no picture to save".to_owned(),
            Some(Ok(image)) => match gallery.save(image) {
                Ok(path) => format!("saved {}", path.display()),
                Err(error) => format!("error: {error}"),
            },
        };
        self.notify(notice);
    }
}
