//! Locks the pictures of a stage in its tests.
//!
//! A lock has two halves: a text snapshot with the picture's size, the hash of
//! its bytes and a thumbnail in characters, and the expected PNG, which lies
//! where the book shows it. [`lock_pictures!`](crate::lock_pictures) writes the
//! tests; `INSTA_UPDATE=always` accepts what they see, in both halves.

mod description;
mod difference;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use common::{Image, Sampled, Sampling, Scene, Settings, Size, Transfer, picture_file};
use description::describe;
use difference::{compare, leave_pictures};
use measure::Stage;
use measure::comparison::{Comparison, complete};
use program::picture_name;

/// Where the test crate and its files lie; [`lock_pictures!`](crate::lock_pictures)
/// fills it in.
pub struct Places {
    /// The folder of the stage's crate.
    pub stage: &'static str,
    /// A folder for what a failed test leaves behind.
    pub scratch: &'static str,
    /// The stage's program.
    pub program: &'static str,
}

impl Places {
    fn expected(&self, name: &str) -> PathBuf {
        Path::new(self.stage)
            .join("../book/src/pictures")
            .join(name)
    }
}

/// Writes the tests of a stage's pictures: a lock for each scene, under its
/// name, and what holds for all of them.
///
/// ```ignore
/// testing::lock_pictures! { a04_intersections::stage(); scene_1 scene_2 }
/// ```
#[macro_export]
macro_rules! lock_pictures {
    ($stage:expr; $($scene:ident)+) => {
        const PLACES: $crate::picture_lock::Places = $crate::picture_lock::Places {
            stage: env!("CARGO_MANIFEST_DIR"),
            scratch: env!("CARGO_TARGET_TMPDIR"),
            program: env!(concat!("CARGO_BIN_EXE_", env!("CARGO_PKG_NAME"))),
        };

        $(
            #[test]
            fn $scene() {
                $crate::picture_lock::check(&$stage, stringify!($scene), &PLACES);
            }
        )+

        #[test]
        fn every_scene_is_locked() {
            $crate::picture_lock::check_complete(&$stage, &[$(stringify!($scene)),+]);
        }

        #[test]
        fn one_thread_and_eight_give_the_same_bytes() {
            $crate::picture_lock::check_threads(&$stage);
        }

        #[test]
        fn rows_rendered_alone_are_those_of_the_picture() {
            $crate::picture_lock::check_rows(&$stage);
        }

        #[test]
        fn what_is_left_out_changes_no_byte() {
            $crate::picture_lock::check_omissions(&$stage);
        }

        #[test]
        fn the_book_tells_what_is_left_out() {
            $crate::picture_lock::check_book(&$stage, &PLACES);
        }

        #[test]
        fn pictures_of_one_pixel_and_of_one_row_are_no_trouble() {
            $crate::picture_lock::check_narrow_sizes(&$stage);
        }

        #[test]
        fn without_a_display_the_program_leaves_its_first_picture() {
            $crate::picture_lock::check_program(&$stage, &PLACES);
        }
    };
}

fn render(scene: &Scene, settings: &Settings) -> Image {
    let image = scene.render(settings, &()).expect("the scene renders");
    assert_eq!(image.count_non_finite(), 0, "no pixel is NaN or infinite");
    image
}

/// Renders a scene and compares it with both halves of its lock.
///
/// # Panics
///
/// If the picture differs; the message says how, and where to look at it.
pub fn check(stage: &Stage, test: &str, places: &Places) {
    let scene = stage.scene(&test.replace('_', "-")).expect("a scene");
    let image = render(scene, &scene.defaults);
    let (size, rgb) = (image.size(), image.to_rgb8(Transfer::Linear));

    let name = picture_name(stage, scene);
    let expected = places.expected(&name);
    let comparison = picture_file::open(&expected)
        .map_err(|error| error.to_string())
        .and_then(|stored| compare(&stored, &image));
    let accept = std::env::var("INSTA_UPDATE").as_deref() == Ok("always");
    let report = match comparison {
        Ok(()) => None,
        Err(_) if accept => {
            picture_file::save_png(&expected, size, &rgb).expect("the expected picture is written");
            None
        }
        Err(difference) => Some(leave_pictures(
            Path::new(places.scratch),
            &expected,
            &image,
            &difference,
        )),
    };
    if let Some(report) = &report {
        eprintln!("{report}");
    }

    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new(places.stage).join("tests/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description(format!("{}: {}", scene.name, scene.about));
    settings.bind(|| insta::assert_snapshot!(scene.name, describe(size, &rgb)));
    assert!(report.is_none(), "{}", report.unwrap_or_default());
}

/// Checks that the tests name all scenes of the stage.
///
/// # Panics
///
/// If a scene has no lock.
pub fn check_complete(stage: &Stage, tests: &[&str]) {
    let locked: Vec<_> = tests.iter().map(|test| test.replace('_', "-")).collect();
    let scenes: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
    assert_eq!(locked, scenes, "the tests name every scene, in order");
}

/// Few pixels, so that a scene can be rendered several times.
fn small(scene: &Scene) -> Settings {
    Settings {
        size: Size::new(96, 72).expect("a size"),
        ..scene.defaults.clone()
    }
}

/// Samples anywhere, and several reflections.
fn scattered(scene: &Scene) -> Settings {
    Settings {
        samples: 3,
        sampling: Sampling::Random,
        seed: 5,
        depth: 3,
        ..small(scene)
    }
}

/// Checks that the number of threads changes nothing: with one sample, with
/// scattered ones, and with as many as the picture needs. What these show of the
/// error is a sum over pixels, whose last bits another order would change.
///
/// # Panics
///
/// If it does.
pub fn check_threads(stage: &Stage) {
    for scene in &stage.scenes {
        let adaptive = Settings {
            samples: 64,
            max_error: Some(1.0 / 255.0),
            ..small(scene)
        };
        for settings in [small(scene), scattered(scene), adaptive] {
            let with = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
                let pool = pool.build().expect("threads");
                let told = Mutex::new(Sampled::default());
                let image = pool.install(|| scene.render(&settings, &told));
                let told = told.into_inner().expect("what the samples show");
                (image.expect("the scene renders"), told)
            };
            let one = with(1);
            for threads in 2..=8 {
                assert_eq!(one, with(threads), "{}, {threads} threads", scene.name);
            }
        }
    }
}

/// Checks that bands of rows are what they are in the whole picture.
///
/// # Panics
///
/// If one is not.
pub fn check_rows(stage: &Stage) {
    for scene in stage.scenes.iter().filter(|scene| scene.uses.sampling) {
        let mut settings = Settings {
            samples: 4,
            sampling: Sampling::Stratified,
            ..small(scene)
        };
        let whole = render(scene, &settings);
        // 72 rows make ten bands and two rows more.
        let bands = whole.pixels().chunks(7 * 96);
        for (start, expected) in (0..).step_by(7).zip(bands) {
            settings.rows = Some(start..start + 7);
            let band = render(scene, &settings);
            assert_eq!(band.pixels(), expected, "{}, row {start}", scene.name);
        }
    }
}

/// Checks that work which is left out changes nothing, wherever samples lie and
/// however often rays are mirrored.
///
/// # Panics
///
/// If they do.
pub fn check_omissions(stage: &Stage) {
    for scene in &stage.scenes {
        for settings in [small(scene), scattered(scene)] {
            let [with, without] =
                [settings.clone(), complete(&settings)].map(|settings| render(scene, &settings));
            assert_eq!(with, without, "{}", scene.name);
        }
    }
}

/// Checks that the book's table of what is left out holds what is counted, for
/// all traced scenes of the stage in pictures of 96x72 pixels.
///
/// # Panics
///
/// If it does not; the message says what the table should say.
pub fn check_book(stage: &Stage, places: &Places) {
    let path = Path::new(places.stage).join("../book/src/left-out.md");
    let mut page = std::fs::read_to_string(&path).expect("the page");
    let mut wrong = Vec::new();
    for scene in stage.scenes.iter().filter(|scene| scene.uses.sampling) {
        let (number, _) = stage.name.split_once('-').expect("a number");
        let name = format!("{number} {}", scene.name);
        let comparison = Comparison::new(scene, &small(scene)).expect("the scene renders");
        assert_eq!(comparison.difference, 0.0, "{name}");
        let row = comparison.row(&name);
        let begin = format!("| {name} |");
        let found = page.lines().find(|line| line.starts_with(&begin));
        if found != Some(&row) {
            page = found.map_or_else(|| page.clone(), |found| page.replace(found, &row));
            wrong.push(row);
        }
    }
    if std::env::var("INSTA_UPDATE").as_deref() == Ok("always") {
        std::fs::write(&path, page).expect("the page is written");
    } else {
        assert!(wrong.is_empty(), "it is:\n{}", wrong.join("\n"));
    }
}

/// Renders every scene at the sizes that divide by zero if anything does.
///
/// # Panics
///
/// If a picture has another size than asked for, or pixels that are no numbers.
pub fn check_narrow_sizes(stage: &Stage) {
    for scene in stage.scenes.iter().filter(|scene| scene.uses.size) {
        for (width, height) in [(1, 1), (1, 50), (50, 1)] {
            let size = Size::new(width, height).expect("a size");
            let settings = Settings {
                size,
                ..scene.defaults.clone()
            };
            assert_eq!(render(scene, &settings).size(), size, "{}", scene.name);
        }
    }
}

/// Runs the program with no display and compares the PNG it leaves.
///
/// # Panics
///
/// If the program fails, or does not leave its first picture and say where.
pub fn check_program(stage: &Stage, places: &Places) {
    let folder = tempfile::tempdir().expect("a folder");
    // On these the display cannot be taken from the program, but only declined.
    let always_a_display = cfg!(any(windows, target_os = "macos"));
    let output = Command::new(places.program)
        .args(always_a_display.then_some("--no-window"))
        .current_dir(&folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .expect("the program runs");
    let name = picture_name(stage, &stage.scenes[0]);
    let said = String::from_utf8_lossy(&output.stdout);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    let explained = always_a_display || complaint.starts_with("no window: ");
    assert!(explained, "{complaint}");
    assert!(said.contains(&name), "{said}");
    let open = |path: &Path| picture_file::open(path).expect("a picture");
    let left = open(&folder.path().join("out").join(&name));
    assert_eq!(left, open(&places.expected(&name)));
}
