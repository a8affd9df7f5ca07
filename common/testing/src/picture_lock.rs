//! Locks the pictures of a stage in its tests.
//!
//! A lock has two halves: a text snapshot with the picture's size and the hash of its
//! bytes, and the expected PNG, which is a file of the book. [`lock_pictures!`](crate::lock_pictures) writes the tests;
//! `INSTA_UPDATE=always` accepts a new picture, in both halves, if all renderers draw it.

mod book_pictures;
mod invariance;
mod omission_table;
mod program_run;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use command_line::picture_name;
use common::{Image, Renderer, Scene, Settings, Stage, Transfer, fnv1a, picture_file};

use common::difference::{compare_with_file, leave_pictures};

use crate::FORMULAS;

pub use book_pictures::{BookPicture, check_book_pictures};
pub use invariance::{check_narrow_sizes, check_omissions, check_threads};
pub use omission_table::check_book;
pub use program_run::check_program;

/// The paths of a stage's tests.
pub struct TestPaths {
    /// The folder of the stage's crate.
    pub stage: &'static str,
    /// A folder for the pictures of failed tests.
    pub scratch: &'static str,
    /// The stage's program.
    pub program: &'static str,
}

impl TestPaths {
    fn expected(&self, name: &str) -> PathBuf {
        Path::new(self.stage)
            .join("../book/src/pictures")
            .join(name)
    }
}

/// Writes a lock for each scene of a stage, with its name, and a test that no scene is
/// left out. The caller has a constant `TEST_PATHS`.
#[macro_export]
macro_rules! lock_scenes {
    ($complete:ident: $stage:expr; $($scene:ident)+) => {
        $(
            #[test]
            fn $scene() {
                $crate::picture_lock::check(&$stage, stringify!($scene), &TEST_PATHS);
            }
        )+

        #[test]
        fn $complete() {
            $crate::picture_lock::check_complete(&$stage, &[$(stringify!($scene)),+]);
        }
    };
}

/// Writes the tests of a stage's pictures: a lock for each scene, with its name, and
/// tests of all scenes.
///
/// ```ignore
/// testing::lock_pictures! { a04_intersections::stage(); scene_1 scene_2 }
/// ```
#[macro_export]
macro_rules! lock_pictures {
    ($stage:expr; $($scene:ident)+) => {
        const TEST_PATHS: $crate::picture_lock::TestPaths = $crate::picture_lock::TestPaths {
            stage: env!("CARGO_MANIFEST_DIR"),
            scratch: env!("CARGO_TARGET_TMPDIR"),
            program: env!(concat!("CARGO_BIN_EXE_", env!("CARGO_PKG_NAME"))),
        };

        $crate::lock_scenes! { every_scene_is_locked: $stage; $($scene)+ }

        #[test]
        fn one_thread_and_eight_give_the_same_bytes() {
            $crate::picture_lock::check_threads(&$stage);
        }

        #[test]
        fn skipped_work_changes_no_byte() {
            $crate::picture_lock::check_omissions(&$stage);
        }

        #[test]
        fn the_table_of_skipped_work_in_the_book_is_right() {
            $crate::picture_lock::check_book(&$stage, &TEST_PATHS);
        }

        #[test]
        fn pictures_of_one_pixel_and_of_one_row_are_rendered() {
            $crate::picture_lock::check_narrow_sizes(&$stage);
        }

        #[test]
        fn without_a_display_the_program_leaves_its_first_picture() {
            $crate::picture_lock::check_program(&$stage, &TEST_PATHS);
        }
    };
}

fn render(scene: &Scene, settings: &Settings) -> Image {
    let image = scene.render(settings, &()).expect("the scene renders");
    assert_eq!(image.count_non_finite(), 0, "no pixel is NaN or infinite");
    image
}

/// Whether new pictures replace the expected ones.
fn accepts() -> bool {
    env::var("INSTA_UPDATE").as_deref() == Ok("always")
}

/// Writes a picture into the folder of failed tests, under the name of the expected one.
fn put_aside(image: &Image, transfer: Transfer, expected: &Path, places: &TestPaths) -> PathBuf {
    let name = expected.file_name().expect("a name");
    let file = Path::new(places.scratch).join(name);
    picture_file::save_png(&file, image.size(), &image.to_rgb8(transfer)).expect("it is written");
    file
}

/// The other renderers, each with a message about a picture that differs from the lesson's.
const RENDERERS: [(Renderer, &str); 2] = [
    (
        Renderer::Engine,
        "by the fast renderer (--fast) is not the lesson's",
    ),
    (
        Renderer::NoOmissions,
        "by the renderer of all work (--no-omit) is not the lesson's",
    ),
];

/// The scene of a file that the program exports from a scene, if the stage reads scene files.
fn read_again(stage: &Stage, scene: &Scene, places: &TestPaths) -> Option<Scene> {
    let open = stage.open?;
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join(scene.name).with_extension("toml");
    let mut program = Command::new(places.program);
    program.args(["export", scene.name, "--to", "toml", "-o"]);
    let output = program.arg(&file).output().expect("the program runs");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {stderr}", scene.name);
    let wrong = |error| {
        panic!(
            "{error}:
{}",
            fs::read_to_string(&file).unwrap()
        )
    };
    Some(open(&file).unwrap_or_else(wrong))
}

/// Renders a scene by the lesson and compares the picture with its lock, then by the other renderers, which must draw
/// the lesson's picture. The engine draws the same from the scene file that the scene's export makes, if the stage reads
/// scene files. A scene that traces no rays is painted in one way. A new picture replaces the lock when all draw it.
pub fn check(stage: &Stage, test: &str, places: &TestPaths) {
    let scene = stage.scene(&test.replace('_', "-")).expect("a scene");
    let locked = places.expected(&picture_name(stage, &scene));
    let lesson = draw(&scene, Renderer::Lesson);
    let mut expected = locked.clone();
    if let Err(difference) = compare_with_file(&locked, &lesson) {
        if !accepts() {
            let difference = format!("the picture of {} has changed: {difference}", scene.name);
            let left = leave_pictures(Path::new(places.scratch), &locked, &lesson, &difference);
            panic!("{left}\n  if the new picture is right, INSTA_UPDATE=always accepts it");
        }
        expected = put_aside(&lesson, Transfer::Linear, &locked, places);
    }
    let mut others = Vec::new();
    if scene.rays().is_ok() {
        others.extend(RENDERERS.map(|(renderer, differs)| (scene.clone(), renderer, differs)));
    }
    if let Some(again) = read_again(stage, &scene, places) {
        others.push((again, Renderer::Engine, "from its file is another one"));
    }
    for (scene, renderer, differs) in others {
        let image = draw(&scene, renderer);
        if let Err(difference) = compare_with_file(&expected, &image) {
            let difference = format!("the picture of {} {differs}: {difference}", scene.name);
            let scratch = Path::new(places.scratch);
            panic!(
                "{}\n{FORMULAS}",
                leave_pictures(scratch, &expected, &image, &difference)
            );
        }
    }
    if expected != locked {
        fs::copy(&expected, &locked).expect("the locked picture is written");
    }
    check_hash(&scene, &lesson, places);
}

fn draw(scene: &Scene, renderer: Renderer) -> Image {
    let settings = Settings {
        renderer,
        ..scene.defaults.clone()
    };
    render(scene, &settings)
}

/// Compares the picture of the lesson with the snapshot of its hash: behind all pictures, so that the message about a
/// changed picture shows pictures.
fn check_hash(scene: &Scene, image: &Image, places: &TestPaths) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new(places.stage).join("tests/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description(format!("{}: {}", scene.name, scene.about));
    let (size, rgb) = (image.size(), image.to_rgb8(Transfer::Linear));
    let hash = format!("size {size}\nhash {:016x}", fnv1a(&rgb));
    settings.bind(|| insta::assert_snapshot!(scene.name, hash));
}

/// Checks that the tests name all scenes of the stage.
pub fn check_complete(stage: &Stage, tests: &[&str]) {
    let locked: Vec<_> = tests.iter().map(|test| test.replace('_', "-")).collect();
    let scenes: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
    assert_eq!(locked, scenes, "the tests name every scene, in order");
}
