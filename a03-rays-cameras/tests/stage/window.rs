//! The window while a rendering goes on. Where Xvfb or xdotool is missing
//! nothing is tested, and a line says so.

use std::path::Path;

use common::{Sampling, Settings, Size, Transfer};
use testing::display::{Display, picture, wait_for};

/// Takes hours.
const LONG: &str = "show striped-sky --samples 1000000 --sampling random --threads 1";

/// Runs a test with the program and its current folder, which is empty.
fn with_window(line: &str, test: impl FnOnce(Display, &Path)) {
    let folder = tempfile::tempdir().expect("a folder");
    let program = env!("CARGO_BIN_EXE_a03-rays-cameras");
    if let Some(window) = Display::start(program, line, folder.path()) {
        test(window, folder.path());
    }
}

#[test]
fn closing_ends_a_long_rendering_which_is_not_saved() {
    with_window(LONG, |window, folder| {
        window.wait_for(&[" to go\"]", "picture: None"]);
        window.press("s");
        window.wait_for(&["texts: [\"the picture is not finished yet\", ", " to go\"]"]);
        window.press("Escape");
        window.wait_for_end();
        assert_eq!(folder.read_dir().expect("a folder").count(), 0, "no file");
    });
}

#[test]
fn the_picture_grows_and_ends_as_the_one_that_render_makes() {
    let settings = Settings {
        size: Size::new(300, 160).expect("a size"),
        samples: 500,
        sampling: Sampling::Random,
        ..Settings::default()
    };
    let line = "show striped-sky --size 300x160 --samples 500 --sampling random --threads 1";
    with_window(line, |window, _| {
        wait_for("finished rows beside unfinished ones", || {
            let state = window.state();
            let done = state.split_once("done: ")?.1.split_once(" }")?.0;
            let done: f64 = done.parse().ok()?;
            (0.0 < done && done < 1.0).then_some(())
        });
        let stage = a03_rays_cameras::stage();
        let scene = stage.scene("striped-sky").expect("a scene");
        let image = scene.render(&settings, &()).expect("a picture");
        let color = |x, y| Transfer::Linear.pack(image.get(x, y).expect("a pixel"));
        window.wait_for(&[&picture(300, 160, color), "texts: []"]);
    });
}

#[test]
fn another_scene_takes_the_place_of_a_rendering() {
    with_window(LONG, |window, _| {
        for scene in ["-straight", "", "-straight"] {
            window.press("Right");
            let title = format!("\"a03-rays-cameras: striped-sky{scene}\"");
            window.wait_for(&[&title, "picture: None"]);
        }
        // The window's thread, the one that waits and the one that renders.
        let threads = Path::new("/proc")
            .join(window.process().to_string())
            .join("task");
        wait_for("the end of the first renderings", || {
            (threads.read_dir().ok()?.count() == 3).then_some(())
        });
        window.press("Escape");
        window.wait_for_end();
    });
}
