//! `Window`: shows the scenes of a stage while they are rendered.

mod command;
mod drawing;
mod frame;
mod input;
mod keyboard;
mod log;
mod menu_bar;
mod placement;
mod screen;
mod text;

use common::{Image, Size};
use program::{Gallery, NotShown, Viewer};

use screen::Screen;

/// Shown when the file dialog is cancelled.
const NO_FILE: &str = "no file was chosen; the argument --open FILE shows one, too";

/// A window that has the size of the picture and can save it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Window;

impl Viewer for Window {
    fn show(&self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let asks = gallery.opens_files() && !gallery.has_file();
        let chosen = asks.then(choose_file).flatten();
        let has_chosen = chosen.is_some();
        if let Some(file) = chosen {
            gallery.open(file);
        }
        if let Some(picture) = gallery.picture() {
            return Screen::open(gallery, picture.size())?.run(gallery);
        }
        // The size of a file is not known before it has been read.
        gallery.start()?;
        let outcome = match gallery.wait() {
            // A file of the command line: the error goes to the terminal.
            Err(error) if !has_chosen => return Err(error.into()),
            outcome => outcome,
        };
        let size = outcome.as_ref().map_or(Size::COURSE, Image::size);
        let mut screen = Screen::open(gallery, size)?;
        screen.finish(gallery, outcome);
        if asks && !has_chosen {
            screen.notify(NO_FILE.to_owned());
        }
        screen.run(gallery)
    }
}

fn choose_file() -> Option<std::path::PathBuf> {
    rfd::FileDialog::new()
        .set_title("Open a picture")
        .add_filter("pictures", &["png", "jpg", "jpeg", "bmp"])
        .pick_file()
}
