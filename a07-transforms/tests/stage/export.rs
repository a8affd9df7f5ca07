//! What the exported scenes say to other programs.

use std::fs;

use a07_transforms::stage;
use common::Scene;

use crate::scene_cases::open;

/// A triangle with normals that are not perpendicular to it. The distances of the second and
/// third one from the first are inserted.
fn triangle(second: f64, third: f64) -> Scene {
    open(&format!(
        "[camera]\neye = [0.3, 0.3, 3]\ngaze = [0, 0, -1]\nangle = 40\n[[directional_light]]\n\
         color = [1, 1, 1]\ndirection = [0, 0, -1]\n[[triangle]]\ncolor = [0.8, 0.8, 0.8]\n\
         corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n\
         normals = [[0.6, 0, 0.8], [0.6, {second:?}, 0.8], [0.6, {third:?}, 0.8]]\n"
    ))
    .unwrap()
}

/// The three normals of the only triangle of an exported scene.
fn normals(exported: &str) -> [[f64; 3]; 3] {
    let (_, triangle) = exported.split_once("smooth_triangle {").unwrap();
    let (triangle, _) = triangle.split_once('}').unwrap();
    let numbers: Vec<f64> = triangle
        .split(['<', '>', ',', ' '])
        .filter_map(|word| word.parse().ok())
        .collect();
    // A corner and a normal in turn.
    [3, 9, 15].map(|at| [numbers[at], numbers[at + 1], numbers[at + 2]])
}

/// POV-Ray 3.7 shades a `smooth_triangle` flat if neither the second nor the third normal is
/// farther than 1e-5 from the first: seen in its pictures with distances of 0.99e-5 and 1.01e-5.
#[test]
fn pov_ray_sees_normals_that_are_equal_as_those_of_a_smooth_triangle() {
    let distance =
        |a: [f64; 3], b: [f64; 3]| libm::hypot(libm::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
    for (second, third, is_moved) in [
        (0.0, 0.0, true),
        (9e-6, 0.0, true),
        (-9e-6, 9e-6, true),
        (0.0, 1e-4, false),
        (1e-4, 0.0, false),
        (0.5, -0.5, false),
    ] {
        let scene = triangle(second, third);
        let export = |language| {
            let rays = scene.rays().unwrap();
            rays.export(language, &scene.defaults).unwrap()
        };
        let [a, b, c] = normals(&export("povray"));
        let farthest = distance(a, b).max(distance(a, c));
        assert!(farthest > 1.1e-5, "{second:?} {third:?}: {farthest:?}");
        // A byte is a step of 1/255, of which the light changes by a small part.
        let length = libm::hypot(1.0, third);
        let moved = distance(c, [0.6 / length, third / length, 0.8 / length]);
        let most = if is_moved { 2.5e-5 } else { 1e-15 };
        assert!(moved < most, "{second:?} {third:?}: {moved:?}");
        // Our own language keeps the bits.
        assert!(second != 0.0 || third != 0.0 || !export("toml").contains("e-5"));
    }
}

/// A misspelt name of a phrase, or of a number in it, would leave out a part of a scene without a word. Exports as scene
/// files are read again; nothing here reads those for POV-Ray.
#[test]
fn pov_ray_gets_every_phrase_of_its_language_with_its_numbers() {
    let mut scenes = stage().scenes;
    scenes.push(triangle(0.5, -0.5));
    for file in fs::read_dir("scenes").unwrap() {
        let path = file.unwrap().path();
        if path.extension() == Some("toml".as_ref()) {
            scenes.push((stage().open.unwrap())(&path).unwrap());
        }
    }
    let mut exported = String::new();
    for scene in &scenes {
        // Some have a part for which POV-Ray has no words.
        let export = scene.rays().unwrap().export("povray", &scene.defaults);
        exported += &export.unwrap_or_default();
    }
    assert!(!exported.contains('['));
    let language = "../common/scene-export/src/languages/povray.txt";
    let language = fs::read_to_string(language).unwrap().replace("\\n", "\n");
    let (_, phrases) = language.split_once("\n\n").unwrap();
    for part in phrases
        .split('\n')
        .flat_map(|line| line.split(['[', ']']).step_by(2))
    {
        let part = part
            .split_once(':')
            .map_or(part, |(_, words)| words.trim_start());
        assert!(exported.contains(part), "no scene has {part}");
    }
}
