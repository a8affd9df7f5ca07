//! `window`: shows the scenes of a stage while they are rendered.

mod appearance;
mod area;
mod drawing;
mod frame;
mod hand;
mod keyboard;
mod layout;
mod letters;
mod menu;
mod mouse;
mod placement;
mod screen;
mod ui;

use program::{Gallery, NotShown};

/// Shown when the file dialog is cancelled.
const NO_FILE: &str = "no file was chosen; the argument --open FILE shows one, too";

/// Shows the scenes in a window with the picture, menus, and a panel of its numbers.
pub fn show(gallery: &mut Gallery) -> Result<(), NotShown> {
    let asks = gallery.scene.uses.file && gallery.options.open.is_none();
    if asks {
        gallery.options.open = choose_file();
    }
    let has_chosen = asks && gallery.options.open.is_some();
    if gallery.scene.uses.file {
        // The size of a file is not known before it has been read.
        gallery.start()?;
        gallery.wait();
        // A file of the command line: the error goes to the terminal.
        if !has_chosen && let Some(Err(error)) = gallery.outcome.take_if(|it| it.is_err()) {
            return Err(error.into());
        }
    }
    let mut screen = screen::Screen::open(gallery)?;
    if asks && !has_chosen {
        screen.notify(NO_FILE.to_owned());
    }
    screen.run(gallery)
}

fn choose_file() -> Option<std::path::PathBuf> {
    rfd::FileDialog::new()
        .set_title("Open a picture")
        .add_filter("pictures", &["png", "jpg", "jpeg", "bmp"])
        .pick_file()
}
