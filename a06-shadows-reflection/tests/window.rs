//! The window with a scene of rays, on a display of its own: its pictures are those that the
//! lesson renders with the same camera, lights and settings.

#![cfg(all(target_os = "linux", feature = "window"))]

use std::collections::HashSet;

use common::{Settings, Size};
use testing::display::{self, Display};

const PROGRAM: &str = env!("CARGO_BIN_EXE_a06-shadows-reflection");

/// The state of a window that shows the scene `sphere` with changed settings.
fn shown(change: impl FnOnce(&mut Settings)) -> String {
    let stage = a06_shadows_reflection::stage();
    let scene = stage.scene("sphere").unwrap();
    let mut settings = scene.defaults.clone();
    settings.size = Size::new(64, 48).unwrap();
    change(&mut settings);
    display::shown(&scene.render(&settings, &()).unwrap())
}

#[test]
fn camera_and_lights_move_and_return() {
    let Some(window) = Display::start(PROGRAM, "show sphere --size 64x48") else {
        return;
    };
    let start = shown(|_| ());
    // For a pixel of the mouse's way, 0.01 radians.
    let dragged = shown(|settings| settings.edits.orbit = [0.5, 0.2]);
    let turned = shown(|settings| settings.edits.orbit = [0.2, 0.0]);
    let shallow = shown(|settings| {
        settings.edits.orbit = [0.2, 0.0];
        settings.depth = 1;
    });
    let lit = shown(|settings| {
        settings.edits.orbit = [0.2, 0.0];
        settings.depth = 1;
        settings.edits.lights = vec![[0.5, 0.0, 0.0]];
    });
    assert_eq!(
        HashSet::from([&start, &dragged, &turned, &shallow, &lit]).len(),
        5
    );
    window.play(&[
        ("mousemove --window WINDOW 300 100", &start),
        ("mousedown 3", "right: true"),
        ("mousemove --window WINDOW 250 80", &dragged),
        ("mousemove --window WINDOW 300 100", &start),
        ("mouseup 3", "right: false"),
        ("key ctrl+Left", &turned),
        ("item 0 Depth", &shallow),
        // The slider stays selected: the next one is that of the light.
        ("key Down Right Right", &lit),
        ("key r", &start),
        ("key i", "pixel: Some([32, 24]) & explained: true"),
        ("key Right", "pixel: Some([33, 24]) & explained: true"),
    ]);
}

#[test]
fn a_rendering_that_goes_on_answers_and_ends() {
    let Some(window) = Display::start(PROGRAM, "show sphere") else {
        return;
    };
    window.play(&[
        ("item 0.99 Samples", " elapsed & picture: None"),
        ("key s", "the picture is not finished yet"),
    ]);
    assert_eq!(window.folder.path().read_dir().unwrap().count(), 0);
    window.play(&[("key Escape Escape", "")]);
    window.wait_for_end();
}
