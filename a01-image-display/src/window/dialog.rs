//! The dialogs of the system that choose a file.

use std::time::{Duration, Instant};

use program::Gallery;
use rfd::FileDialog;

/// A person takes longer to cancel a dialog; what ends sooner was none.
const AT_ONCE: Duration = Duration::from_millis(150);

/// Lets a person choose a picture, and shows it.
pub fn open(gallery: &mut Gallery) {
    let dialog = FileDialog::new()
        .set_title("Open a picture")
        .add_filter("pictures", &["png", "jpg", "jpeg", "bmp"]);
    match dialog.pick_file() {
        Some(path) => gallery.open(path),
        None => gallery.note_no_file(),
    }
}

/// Saves the picture where a person wants it; in the usual folder if the system has no dialog.
pub fn save(gallery: &mut Gallery) {
    if gallery.is_rendering() {
        // It says so.
        return gallery.save(None);
    }
    let start = Instant::now();
    let dialog = FileDialog::new()
        .set_title("Save the picture")
        .set_file_name(gallery.file_name() + ".png")
        .add_filter("PNG", &["png"]);
    let path = dialog.save_file();
    if path.is_some() || start.elapsed() < AT_ONCE {
        gallery.save(path);
    }
}
