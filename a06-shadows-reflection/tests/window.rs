//! The window with a scene of rays, on a display of its own: while it renders, it answers keys and clicks;
//! its camera moves, and returns to the same bytes.

#![cfg(all(target_os = "linux", feature = "window"))]

use std::fs;
use std::path::Path;

use common::{Settings, Size, picture_file};
use testing::display::{Display, wait_for};

const PROGRAM: &str = env!("CARGO_BIN_EXE_a06-shadows-reflection");

/// The bytes of the scene `sphere` with this camera.
fn rendered(orbit: [f64; 2], steps: i32) -> Vec<u8> {
    let stage = a06_shadows_reflection::stage();
    let scene = stage.scene("sphere").unwrap();
    let mut settings = Settings {
        size: Size::new(64, 48).unwrap(),
        ..scene.defaults.clone()
    };
    (settings.edits.orbit, settings.edits.steps) = (orbit, steps);
    let image = scene.render(&settings, &()).unwrap();
    image.to_rgb8(settings.transfer)
}

/// Saves the picture, and returns its bytes.
fn saved(window: &Display) -> Vec<u8> {
    let out = window.folder.path().join("out");
    let _ = fs::remove_dir_all(&out);
    window.wait_for_picture("sphere");
    let path: &Path = &out.join("a06-shadows-reflection-sphere.png");
    wait_for("the file", || {
        window.act("key s");
        path.exists().then_some(())
    });
    picture_file::open(path)
        .unwrap()
        .to_rgb8(Settings::default().transfer)
}

#[test]
fn the_camera_moves_and_returns() {
    let Some(window) = Display::start(PROGRAM, "show sphere --size 64x48") else {
        return;
    };
    window.act("mousemove --window WINDOW 300 100 sleep 0.2 mousedown 3 sleep 0.2");
    window.act("mousemove --window WINDOW 250 80 sleep 0.2 mouseup 3 sleep 0.2");
    // For a pixel of the mouse's way, 0.01 radians.
    assert_eq!(saved(&window), rendered([0.5, 0.2], 0));
    window.act("key c");
    window.wait_for_line("[camera]\neye = [");
    window.act("key r sleep 0.2");
    assert_eq!(saved(&window), rendered([0.0; 2], 0));
    window.act("click 4 sleep 0.2");
    let near = saved(&window);
    // The server reports a step of its wheel once or twice.
    assert!(
        [1, 2]
            .map(|steps| rendered([0.0; 2], steps))
            .contains(&near)
    );
}

#[test]
fn while_it_renders_no_key_is_lost_and_clicks_are_answered() {
    let line = "show sphere --samples 65536";
    let Some(window) = Display::start(PROGRAM, line) else {
        return;
    };
    for _ in 0..20 {
        window.act("keydown c sleep 0.005 keyup c sleep 0.005");
    }
    let cameras = || window.printed("stdout").matches("[camera]").count();
    wait_for("all keys", || (cameras() == 20).then_some(()));
    window.click_until(100, 100, "pixel 100,70\n");
    window.act("key s Escape");
    assert!(!window.folder.path().join("out").exists(), "not finished");
    window.wait_for_end();
}
