//! The sign of a 0 in a scene file changes no picture.

use a07_transforms::registry::FORMAT;
use common::{Settings, Size};
use random_scene::{SceneText, Style};

use crate::compare::{compare, or_asked};
use crate::scenes::{text, view};

#[test]
fn the_sign_of_a_zero_changes_no_picture() {
    let settings = Settings {
        size: Size::new(24, 18).unwrap(),
        depth: 3,
        ..Settings::default()
    };
    for seed in or_asked(200..230) {
        let text = text(seed, Style::Plain, FORMAT);
        let pictures = [text.with_negative_zeros(), text].map(|text| {
            let again = || view(FORMAT, &text).unwrap();
            view(FORMAT, &text)
                .is_ok()
                .then(|| compare(seed, again, &settings))
        });
        assert!(pictures[0] == pictures[1], "seed {seed}");
    }
}

/// The light lies in the plane of a face, so that its dot product with the normal is 0 or -0.
#[test]
fn light_along_a_face_of_a_mirrored_mesh_does_not_depend_on_a_zero() {
    let scene = "[camera]\neye = [3, 4, 7]\nlook_at = [0, 0, 0]\nangle = 35\n\
        [material.m]\ndiffuse = [1, 1, 1]\n\
        [[directional_light]]\ncolor = [1, 1, 1]\ndirection = [1, 0e0, 0]\n\
        [[mesh]]\nfile = \"plain\"\nsmooth = true\nmaterial = \"m\"\n\
        transform = [{ scale = [1, -1, 1] }]\n";
    let mesh = "v -0.4 0 0.4\nv 0.4 0 1.2\nv 0.4 -0.03 0.4\nv 1.2 0 1.2\nf 1 2 3\nf 3 2 4\n";
    let text = SceneText {
        scene: scene.into(),
        meshes: [("plain", mesh.into())].into(),
    };
    let settings = Settings {
        size: Size::new(160, 120).unwrap(),
        ..Settings::default()
    };
    let [plain, negated] = [text.clone(), text.with_negative_zeros()]
        .map(|text| compare(0, || view(FORMAT, &text).unwrap(), &settings));
    assert!(plain == negated);
}
