//! Command lines: the whole program of a stage, with arguments made from bytes.
//!
//! Its scenes are small, however large a picture is asked for, and it runs in a
//! folder of its own, which no path leads out of.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;
use std::sync::OnceLock;
use std::{env, fs, thread};

use a02_math::Point3;
use a03_rays_cameras::{PinholeCamera, StripeRule, StripedSky, render};
use common::{Color, Error, Image, Progress, Scene, Settings, Size, picture_file};
use measure::Stage;
use measure::extremes::{Bound, Case};
use program::{Gallery, NotShown, Viewer};
use tempfile::TempDir;

/// Runs the program with these arguments, one a line, and takes away again the
/// files that it has written. Goes to another folder, and so needs a process of
/// its own, which prints the messages of the program.
///
/// # Panics
///
/// If the program panics, if its exit code is none that it documents, or if it
/// leaves a file that is no whole picture.
pub fn check(bytes: &[u8]) {
    static STAGE: OnceLock<(Stage, TempDir)> = OnceLock::new();
    let (stage, folder) = STAGE.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        let place = folder.path().join(PLACE);
        fs::create_dir(&place).expect("a folder");
        env::set_current_dir(&place).expect("a folder");
        (stage(), folder)
    });
    let arguments = bytes.split(|byte| *byte == b'\n').map(argument);
    let arguments = [OsString::from(stage.name)].into_iter().chain(arguments);
    let code = program::run_with(stage, Some(&Looker), arguments);
    let documented = [0, 1, 2].map(ExitCode::from);
    assert!(documented.contains(&code), "{code:?}");
    clear(folder.path(), &folder.path().join(PLACE));
}

/// Where the program runs: one below, as a path may begin with `..`.
const PLACE: &str = "place";

/// The argument, with no separator that could lead out of the folder: `/` stays
/// in fractions.
fn argument(bytes: &[u8]) -> OsString {
    let mut bytes = bytes.to_owned();
    let mut before = None;
    for byte in &mut bytes {
        let is_in_fraction = *byte == b'/' && before.is_some_and(|b: u8| b.is_ascii_digit());
        if b"/\\:".contains(byte) && !is_in_fraction {
            *byte = b'_';
        }
        before = Some(*byte);
    }
    #[cfg(unix)]
    return std::os::unix::ffi::OsStringExt::from_vec(bytes);
    #[cfg(not(unix))]
    return String::from_utf8_lossy(&bytes).into_owned().into();
}

/// Takes away all files below, which must be whole pictures, and all folders
/// but `place`.
fn clear(folder: &Path, place: &Path) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            clear(&path, place);
            if path != place {
                fs::remove_dir(&path).expect("an empty folder");
            }
        } else {
            picture_file::open(&path).expect("a whole picture");
            fs::remove_file(&path).expect("a file");
        }
    }
}

/// Larger pictures are not painted.
const MOST_SAMPLES: u64 = 4096;

fn is_small(settings: &Settings) -> Result<(), Error> {
    let samples = settings.size.pixels() as u64 * u64::from(settings.samples);
    if samples > MOST_SAMPLES {
        return Err(Error::Stopped);
    }
    Ok(())
}

fn painted(settings: &Settings, _: &dyn Progress) -> Result<Image, Error> {
    is_small(settings)?;
    Image::from_fn(settings.size, |x, y| {
        Color::from_bytes([x as u8, y as u8, 0])
    })
}

fn opened(settings: &Settings, _: &dyn Progress) -> Result<Image, Error> {
    match &settings.file {
        Some(file) => picture_file::open(file),
        None => Image::black(settings.size),
    }
}

fn traced(settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    is_small(settings)?;
    let camera = PinholeCamera::new(Point3::ORIGIN, 1.0)?;
    let sky = StripedSky::new(&camera, settings.size, 3, StripeRule::Wall)?;
    render(&camera, |ray| sky.color_for(ray), settings, progress)
}

fn stage() -> Stage {
    let defaults = Settings {
        size: Size::new(3, 2).expect("a size"),
        ..Settings::default()
    };
    let scenes = [
        Scene::traced("traced", "rays", traced).reflecting(),
        Scene::painted("painted", "no rays", painted),
        Scene::opened("opened", "a file", opened),
    ];
    Stage {
        name: "a00",
        about: "A stage for bad command lines",
        scenes: scenes
            .map(|scene| scene.with_defaults(defaults.clone()))
            .into(),
        experiments: Vec::new,
        extremes: |_| vec![Case::new("A01", "a number", 1.0, Bound::Equal, 1.0)],
    }
}

/// A window with a person who looks at each scene, saves it and closes the
/// window.
struct Looker;

impl Viewer for Looker {
    fn show(&self, gallery: &mut Gallery) -> Result<(), NotShown> {
        let title = gallery.title();
        loop {
            let look = |gallery: &Gallery| {
                let picture = thread::scope(|scope| gallery.render(scope)?.join())?;
                gallery.save(&picture)
            };
            look(gallery).map_err(NotShown::Failed)?;
            gallery.go_to_next();
            if gallery.title() == title {
                return Ok(());
            }
        }
    }
}
