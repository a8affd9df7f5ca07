//! The window while a rendering goes on. Where Xvfb or xdotool is missing
//! nothing is tested, and a line says so.

use std::path::Path;

use common::{Sampling, Settings, Size};
use testing::display::{Picture, Shown, wait_for};

/// Takes hours.
const LONG: &str = "show striped-sky --samples 1000000 --sampling random --threads 1";

/// Runs a test with the program and its current folder, which is empty.
fn with_window(line: &str, test: impl FnOnce(Shown, &Path)) {
    let folder = tempfile::tempdir().expect("a folder");
    let program = env!("CARGO_BIN_EXE_a03-rays-cameras");
    if let Some(window) = Shown::start(program, line, folder.path(), [800, 600]) {
        test(window, folder.path());
    }
}

/// Whether the strip at the bottom shows the progress of the rendering.
fn has_progress(look: &Picture) -> bool {
    let notices = look.notices();
    let last = notices.last().map_or("", |notice| notice);
    last.contains(" %  ") && last.ends_with(" to go")
}

#[test]
fn closing_ends_a_long_rendering_which_is_not_saved() {
    with_window(LONG, |window, folder| {
        window.wait_to_show("the progress", has_progress);
        window.press("s");
        window.wait_to_show("the reason", |look| {
            has_progress(look) && look.notices()[0] == "the picture is not finished yet"
        });
        window.press("Escape");
        assert_eq!(window.wait_for_end(), (Some(0), String::new()));
        assert_eq!(folder.read_dir().expect("a folder").count(), 0, "no file");
    });
}

#[test]
fn the_picture_grows_and_ends_as_the_one_that_render_makes() {
    let settings = Settings {
        size: Size::new(300, 160).expect("a size"),
        samples: 2000,
        sampling: Sampling::Random,
        ..Settings::default()
    };
    let line = "show striped-sky --size 300x160 --samples 2000 --sampling random --threads 1";
    with_window(line, |window, _| {
        let is_black = |look: &Picture, y| (0..300).all(|x| look.at(x, y) == 0);
        window.wait_to_show("finished rows beside unfinished ones", |look| {
            let rows = || Picture::LINE..142;
            let black = rows().filter(|y| is_black(look, *y)).count();
            has_progress(look) && 0 < black && black < rows().count()
        });
        let stage = a03_rays_cameras::stage();
        let scene = stage.scene("striped-sky").expect("a scene");
        let image = scene.render(&settings, &()).expect("a picture");
        let picture = Picture::from(&image);
        window.wait_to_show("the finished picture, and no strip", |look| {
            look.below_bar() == picture
        });
    });
}

#[test]
fn another_scene_takes_the_place_of_a_rendering() {
    with_window(LONG, |window, _| {
        let [first, second] =
            ["", "-straight"].map(|end| format!("a03-rays-cameras: striped-sky{end}"));
        for title in [&second, &first, &second] {
            window.wait_to_show("the progress", has_progress);
            window.press("Right");
            wait_for(title, || (window.title() == *title).then_some(()));
        }
        // The window's thread, the one that waits and the one that renders.
        wait_for("the end of the first renderings", || {
            (window.status("Threads:") == 3).then_some(())
        });
        window.press("Escape");
        assert_eq!(window.wait_for_end(), (Some(0), String::new()));
    });
}
