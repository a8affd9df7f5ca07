//! The window while a rendering goes on. Where Xvfb or xdotool is missing
//! nothing is tested, and a line says so.

use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use common::{Sampling, Settings, Size};
use testing::display::{Display, Picture, wait_for};

/// Takes hours.
const LONG: &str = "show striped-sky --samples 1000000 --sampling random";

fn program(folder: &Path, line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_a03-rays-cameras"));
    command.args(line.split_whitespace()).current_dir(folder);
    command
}

/// Whether the strip at the bottom tells how far the rendering is.
fn tells_progress(look: &Picture) -> bool {
    let notices = look.notices();
    let last = notices.last().map_or("", |notice| notice);
    last.contains(" %  ") && last.ends_with(" to go")
}

#[test]
fn closing_ends_a_long_rendering_at_once() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    for key in ["Escape", "ctrl+w"] {
        let window = display.start(&mut program(folder.path(), LONG));
        window.wait_to_show("the progress", tells_progress);
        let start = Instant::now();
        window.press(key);
        assert_eq!(window.wait_for_end(), (Some(0), String::new()));
        let time = start.elapsed();
        let _ = writeln!(std::io::stderr(), "{key} to the end: {time:.2?}");
        // Every thread ends the pixel that it is at. That takes a fraction of
        // a second, but this computer may have other things to do.
        assert!(time < Duration::from_secs(5), "{key}: {time:.2?}");
    }
    let left = folder.path().read_dir().expect("a folder").count();
    assert_eq!(left, 0, "no file");
}

#[test]
fn a_picture_that_is_not_finished_is_not_saved() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = display.start(&mut program(folder.path(), LONG));
    window.press("s");
    window.wait_to_show("the reason", |look| {
        tells_progress(look) && look.notices()[0] == "the picture is not finished yet"
    });
    assert!(window.is_running());
    assert!(!folder.path().join("out").exists());
}

#[test]
fn the_picture_grows_and_ends_as_the_one_that_render_makes() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let line = "show striped-sky --size 300x160 --samples 2000 --sampling random --threads 1";
    let window = display.start(&mut program(folder.path(), line));
    let is_black = |look: &Picture, y| (0..300).all(|x| look.at(x, y) == 0);
    window.wait_to_show("finished rows beside unfinished ones", |look| {
        let rows = || Picture::LINE..142;
        let black = rows().filter(|y| is_black(look, *y)).count();
        tells_progress(look) && 0 < black && black < rows().count()
    });

    let stage = a03_rays_cameras::stage();
    let settings = Settings {
        size: Size::new(300, 160).expect("a size"),
        samples: 2000,
        sampling: Sampling::Random,
        ..Settings::default()
    };
    let scene = stage.scene("striped-sky").expect("a scene");
    let image = scene.render(&settings, &()).expect("a picture");
    let picture = Picture::from(&image);
    window.wait_to_show("the finished picture, and no strip", |look| {
        look.below_bar() == picture
    });
}

#[test]
fn another_scene_takes_the_place_of_a_rendering() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let window = display.start(&mut program(folder.path(), &format!("{LONG} --threads 1")));
    window.wait_to_show("the progress", tells_progress);
    let other = "a03-rays-cameras: striped-sky-straight";
    for title in [other, "a03-rays-cameras: striped-sky"] {
        window.press("Right");
        wait_for(title, || (window.title() == title).then_some(()));
    }
    window.press("Right Right Right");
    // The window's thread, the one that waits and the one that renders.
    wait_for("the end of the first renderings", || {
        (window.title() == other && window.threads() == 3).then_some(())
    });
    window.wait_to_show("the progress", tells_progress);
    window.press("Escape");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
}
