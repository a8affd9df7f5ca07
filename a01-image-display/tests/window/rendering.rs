//! The window while a rendering goes on, and afterwards.

use std::path::Path;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::{Duration, Instant};
use std::{env, fs};

use a01_image_display::viewer;
use common::{Color, Error, Image, Progress, Scene, Settings};
use measure::Stage;

use crate::display::{Display, picture, wait_for};
use crate::{packed, wait_for_picture, with_window, with_window_of};

/// A row each five milliseconds.
fn slow(settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    let color = |x, y| Color::from_bytes([x as u8, y as u8, 9]);
    let image = Image::from_fn(settings.size, color)?;
    for (y, row) in (0..).zip(image.rows()) {
        sleep(Duration::from_millis(5));
        progress.row(y, &mut row.iter().copied());
    }
    Ok(image)
}

/// Goes on until it is stopped.
fn endless(_: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    while !progress.stopped() {
        sleep(Duration::from_millis(5));
    }
    Err(Error::Stopped)
}

/// The program of the tests below, which start it in a process of its own.
#[test]
#[ignore = "is no test"]
fn program_of_long_renderings() {
    let stage = Stage {
        name: "stage",
        about: "",
        scenes: vec![
            Scene::traced("endless", "", endless),
            Scene::traced("slow", "", slow),
            Scene::traced("endless-too", "", endless),
        ],
        experiments: Vec::new,
        extremes: |_| Vec::new(),
        search: None,
        open: None,
    };
    let line = ["stage", "--threads", "1"].map(Into::into);
    assert_eq!(program::run_with(&stage, viewer(), line), ExitCode::SUCCESS);
}

fn with_rendering(test: impl FnOnce(Display, &Path)) {
    let program = env::current_exe().expect("this test");
    let line = "rendering::program_of_long_renderings --exact --ignored";
    with_window_of(&program, line, test);
}

fn threads(window: &Display) -> usize {
    window.process().join("task").read_dir().unwrap().count()
}

#[test]
fn closing_ends_a_rendering_which_is_not_saved() {
    with_rendering(|window, folder| {
        window.wait_for(&[" to go\"]", "picture: None"]);
        window.press("s");
        window.wait_for(&["texts: [\"the picture is not finished yet\", ", " to go\"]"]);
        window.press("Escape");
        window.wait_for_end();
        assert_eq!(folder.read_dir().unwrap().count(), 0, "no file");
    });
}

#[test]
fn the_picture_grows_and_another_scene_takes_its_place() {
    with_rendering(|window, _| {
        window.wait_for(&[" to go\"]"]);
        let of_one_rendering = threads(&window);
        window.press("Right");
        wait_for("finished rows beside unfinished ones", || {
            let state = window.state();
            let done = state
                .split_once("\"stage: slow\"")?
                .1
                .split_once("done: ")?;
            let done: f64 = done.1.split_once(" }")?.0.parse().ok()?;
            (0.0 < done && done < 1.0).then_some(())
        });
        let image = slow(&Settings::default(), &()).unwrap();
        let finished = picture(640, 480, |x, y| packed(&image, x, y));
        window.wait_for(&[&finished, "texts: []"]);

        for (key, scene) in [("Left", "endless"), ("Left", "endless-too")] {
            window.press(key);
            window.wait_for(&[&format!("\"stage: {scene}\""), "picture: None"]);
        }
        wait_for("the end of the first renderings", || {
            (threads(&window) == of_one_rendering).then_some(())
        });
        window.press("Escape");
        window.wait_for_end();
    });
}

#[test]
fn a_finished_window_has_one_thread_and_hardly_computes() {
    with_window("show painter", |window, _| {
        wait_for_picture(&window, "painter");
        wait_for("the end of other threads", || {
            (threads(&window) == 1).then_some(())
        });
        // Nanoseconds that the thread had a processor.
        let time = || {
            let statistics = fs::read_to_string(window.process().join("schedstat")).unwrap();
            let nanoseconds = statistics.split(' ').next().unwrap().parse();
            Duration::from_nanos(nanoseconds.unwrap())
        };
        let (start, before) = (Instant::now(), time());
        std::thread::sleep(Duration::from_secs(3));
        let (time, elapsed) = (time().abs_diff(before), start.elapsed());
        assert!(time < elapsed / 10, "{time:?} in {elapsed:?}");
    });
}
