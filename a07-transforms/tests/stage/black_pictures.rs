//! Scenes whose picture is black all over, and the reason that is found.

use std::fs;

use a07_transforms::stage;
use common::{Scene, Transfer};

const CAMERA: &str = "[picture]\nsize = [40, 30]\n[camera]\neye = [0, 0, 5]\nangle = 40\n";
const AHEAD: &str = "look_at = [0, 0, 0]\n";
const MATERIAL: &str = "[material.m]\ndiffuse = [1, 1, 1]\n";
const BALL: &str = "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
const LAMP: &str = "[[point_light]]\ncolor = [1, 1, 1]\nposition = [3, 4, 5]\n";

fn open(text: &str) -> Scene {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).unwrap();
    (stage().open.unwrap())(&path).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The reason for the black picture of a scene.
fn reason(parts: &[&str]) -> Option<String> {
    let scene = open(&parts.concat());
    let image = scene.render(&scene.defaults, &()).unwrap();
    let bytes = image.to_rgb8(Transfer::Linear);
    assert!(bytes.iter().all(|byte| *byte == 0), "{parts:?}");
    scene.rays().unwrap().why_black(&scene.defaults).unwrap()
}

#[test]
fn a_mistake_gets_its_reason() {
    let around = "[[sphere]]\ncenter = [0, 0, 5]\nradius = 1\nmaterial = \"m\"\n";
    let turned_away = "[[spot_light]]\ncolor = [1, 1, 1]\nposition = [0, 0, 5]\n\
                       direction = [0, 0, 1]\nhalf_angle = 20\n";
    let behind = "[[point_light]]\ncolor = [1, 1, 1]\nposition = [0, 0, -5]\n";
    let lid = "[[box]]\nlbf = [-20, 6, -20]\nrun = [20, 7, 20]\nmaterial = \"m\"\n";
    let above = "[[point_light]]\ncolor = [1, 1, 1]\nposition = [0, 20, 20]\n";
    for (parts, expected) in [
        (
            &[CAMERA, AHEAD, MATERIAL, BALL][..],
            "the scene has no light",
        ),
        (
            &[CAMERA, "gaze = [0, 0, 1]\n", LAMP, MATERIAL, BALL],
            "no ray meets an object: the camera at (0, 0, 5) looks along (0, 0, 1), away from",
        ),
        (
            &[CAMERA, "gaze = [1, 0, 0]\n", LAMP, MATERIAL, BALL],
            "looks along (1, 0, 0), past all objects",
        ),
        (
            &[CAMERA, AHEAD, LAMP, MATERIAL, around, BALL],
            "the camera is within object 1: Sphere",
        ),
        (
            &[CAMERA, AHEAD, turned_away, MATERIAL, BALL],
            "every spot light is turned away",
        ),
        (
            &[CAMERA, AHEAD, behind, MATERIAL, BALL],
            "every lamp is behind the surfaces",
        ),
        (
            &[CAMERA, AHEAD, above, MATERIAL, BALL, lid],
            "no light reaches what is seen",
        ),
    ] {
        let reason = reason(parts).unwrap_or_else(|| panic!("no reason: {parts:?}"));
        assert!(reason.contains(expected), "{reason}: {parts:?}");
    }
}

#[test]
fn a_picture_that_may_be_meant_gets_none() {
    let black = "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\ncolor = \"black\"\n";
    let black_material = "[material.m]\ndiffuse = [0, 0, 0]\n";
    assert_eq!(reason(&[CAMERA, AHEAD, LAMP, black]), None);
    assert_eq!(reason(&[CAMERA, AHEAD, LAMP, black_material, BALL]), None);
}
