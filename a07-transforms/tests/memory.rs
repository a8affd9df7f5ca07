//! The memory of many uses of a mesh is that of one. The test is alone in its program, because it
//! looks at the memory of all of it.
#![cfg(target_os = "linux")]

use std::fmt::Write;
use std::fs;
use std::path::Path;

use a07_transforms::stage;
use common::{Renderer, Settings};

/// A hilly wall of 968 triangles as an OBJ file.
fn wall() -> String {
    let mut text = String::new();
    for i in 0..23 * 23 {
        let (x, y) = (f64::from(i / 23), f64::from(i % 23));
        let _ = writeln!(text, "v {} {} {}", x / 8.0, y / 8.0, x * y % 3.0 / 8.0);
    }
    for i in (1..22 * 23).filter(|i| i % 23 > 0) {
        let _ = writeln!(text, "f {i} {} {} {}", i + 1, i + 24, i + 23);
    }
    text
}

/// A scene of the mesh, by ten times ten times ten copies or by one.
fn scene(copies: usize) -> String {
    format!(
        "[camera]\neye = [15, 15, 60]\nlook_at = [15, 15, 0]\nangle = 40\n\
         [[directional_light]]\ncolor = \"white\"\ndirection = [-1, -1, -1]\n\
         [material.m]\ndiffuse = \"tomato\"\n\
         [[repeat]]\nmaterial = \"m\"\ncount = {copies}\ntranslate = [3, 0, 0]\n\
         [[repeat.repeat]]\ncount = {copies}\ntranslate = [0, 3, 0]\n\
         [[repeat.repeat.repeat]]\ncount = {copies}\ntranslate = [0.1, 0, -3]\nrotate = [0, 9, 0]\n\
         [[repeat.repeat.repeat.mesh]]\nfile = \"wall.obj\"\n"
    )
}

/// The most memory that the program has had so far, in kibibytes.
fn most_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.unwrap().trim_end_matches("kB").trim().parse().unwrap()
}

/// Reads and renders a scene with the engine, and returns its picture's number of colours.
fn render(path: &Path, text: &str) -> usize {
    fs::write(path, text).unwrap();
    let scene = (stage().open.unwrap())(path).unwrap();
    let settings = Settings {
        renderer: Renderer::Engine,
        ..scene.defaults.clone()
    };
    let image = scene.render(&settings, &()).unwrap();
    let pixels = image.pixels().iter();
    pixels.filter(|pixel| pixel.channels() != [0.0; 3]).count()
}

#[test]
fn a_thousand_uses_of_a_mesh_take_at_most_a_fifth_more_memory_than_one() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("wall.obj"), wall()).unwrap();
    let path = folder.path().join("scene.toml");
    let seen = render(&path, &scene(1));
    let one = most_memory();
    let all_seen = render(&path, &scene(10));
    let all = most_memory();
    assert!(all_seen > 20 * seen, "{all_seen} of {seen} pixels");
    assert!(5 * all <= 6 * one, "{all} KiB instead of {one} KiB");
}
