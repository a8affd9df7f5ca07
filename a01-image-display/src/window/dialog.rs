//! `Dialog`: a dialog of the system, in which a person chooses a file. The window goes on meanwhile, because some
//! systems have a dialog that never answers.

use std::mem;
use std::path::PathBuf;
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

use command_line::Gallery;
use rfd::FileDialog;

/// A person takes longer to cancel a dialog; what ends sooner was none.
const AT_ONCE: Duration = Duration::from_millis(150);

/// The dialog that was asked last.
pub struct Dialog {
    purpose: Purpose,
    /// The file, and the time after which it was chosen.
    answer: Receiver<(Option<PathBuf>, Duration)>,
    /// Whether the person knows that its answer would be lost with the window.
    is_warned: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Purpose {
    Open,
    Save,
}

impl Dialog {
    /// Lets a person choose a picture to show.
    pub fn open(dialog: &mut Option<Self>, gallery: &mut Gallery) {
        if dialog.is_some() {
            return gallery
                .say("the dialog of the system is open; --open FILE names a picture, too");
        }
        let choose = FileDialog::new()
            .set_title("Open a picture")
            .add_filter("pictures", &["png", "jpg", "jpeg", "bmp"]);
        *dialog = Some(Self::ask(Purpose::Open, || choose.pick_file()));
    }

    /// Lets a person choose where the picture is saved. If the system has no dialog, or it is asked in vain, the
    /// picture is saved in the usual folder.
    pub fn save(dialog: &mut Option<Self>, gallery: &mut Gallery) {
        if dialog.is_some() || !gallery.has_picture() {
            return gallery.save(None);
        }
        let choose = FileDialog::new()
            .set_title("Save the picture")
            .set_file_name(gallery.file_name() + ".png")
            .add_filter("PNG", &["png"]);
        gallery.say("the system asks for a file; S again saves the picture in out/");
        *dialog = Some(Self::ask(Purpose::Save, || choose.save_file()));
    }

    fn ask(purpose: Purpose, choose: impl FnOnce() -> Option<PathBuf> + Send + 'static) -> Self {
        let asked = Instant::now();
        let (sender, answer) = mpsc::channel();
        // Nobody receives the answer if the window is closed meanwhile.
        let ask = move || {
            let path = choose();
            drop(sender.send((path, asked.elapsed())));
        };
        if cfg!(target_os = "macos") {
            // There, only the thread of the window may open another.
            ask();
        } else {
            thread::spawn(ask);
        }
        Self {
            purpose,
            answer,
            is_warned: false,
        }
    }

    /// Whether the window stays although a person closes it, to say once that a dialog is open.
    pub fn delays_end(dialog: &mut Option<Self>, gallery: &mut Gallery) -> bool {
        let Some(open) = dialog else {
            return false;
        };
        if !open.is_warned {
            gallery.say("the dialog of the system is open; Esc again closes the window without it");
        }
        !mem::replace(&mut open.is_warned, true)
    }

    /// Opens or saves the file of a dialog that has been answered. True if it has.
    pub fn is_answered(dialog: &mut Option<Self>, gallery: &mut Gallery) -> bool {
        let Some(asked) = dialog else {
            return false;
        };
        if asked.purpose == Purpose::Save && gallery.is_rendering() {
            // The picture is saved when it is finished.
            return false;
        }
        let Ok((path, time)) = asked.answer.try_recv() else {
            return false;
        };
        match (asked.purpose, path) {
            (Purpose::Open, Some(path)) => gallery.open(path),
            (Purpose::Open, None) => gallery.note_no_file(),
            (Purpose::Save, None) if time > AT_ONCE => gallery.end_answer(),
            (Purpose::Save, path) => gallery.save(path),
        }
        *dialog = None;
        true
    }
}
