//! `window`: shows the scenes of a stage while they are rendered.

mod appearance;
mod area;
mod clipboard;
mod drawing;
mod events;
mod frame;
mod keyboard;
mod layout;
mod menu;
mod mouse;
mod navigation;
mod notices;
mod path_entry;
mod pixel_page;
mod placement;
mod screen;
mod surface;
mod text;
mod ui;

#[cfg(test)]
mod tests;

use program::{Gallery, NotShown};

/// Shown when the file dialog is cancelled.
const NO_FILE: &str = "no file was chosen; P opens one by its path";

/// Shows the scenes in a window with the picture, menus, and a panel of its numbers.
pub fn show(gallery: &mut Gallery) -> Result<(), NotShown> {
    let mut screen = screen::Screen::default();
    if gallery.uses().file {
        let asks = gallery.options.open.is_none();
        if asks {
            gallery.options.open = choose_file("pictures", PICTURES);
        }
        let has_chosen = asks && gallery.options.open.is_some();
        // The size of a file is not known before it has been read.
        gallery.start()?;
        gallery.wait();
        // A file of the command line: the error goes to the terminal.
        if !has_chosen && let Some(Err(error)) = gallery.outcome.take_if(|it| it.is_err()) {
            return Err(error.into());
        }
        if asks && !has_chosen {
            screen.notify(NO_FILE.to_owned());
        }
    }
    events::run(gallery, screen)
}

/// The endings of pictures, and of scene files.
const PICTURES: &[&str] = &["png", "jpg", "jpeg", "bmp"];
const SCENE_FILES: &[&str] = &["toml"];

/// Lets a person choose a file of this kind; none if no file is chosen, or there is no dialog.
fn choose_file(kind: &str, endings: &[&str]) -> Option<std::path::PathBuf> {
    rfd::FileDialog::new()
        .set_title("Open a file")
        .add_filter(kind, endings)
        .pick_file()
}
