//! Shapes of a definition that stand in several places: the engine keeps one tree for them.

use a07_transforms::registry::FORMAT;
use common::{Image, Settings, Size};
use random_scene::SceneText;

use crate::compare::compare;
use crate::scenes::view;

/// The lamp is within the rounding error of a huge ball, which therefore does not block its light. A tiny ball of the
/// same definition stands between that surface and the lamp, and does.
#[test]
fn a_part_behind_the_one_that_holds_the_lamp_casts_a_shadow() {
    for before in [1.0, 2.0, 4.0, 8.0, 16.0, 32.0] {
        // In units in the last place of the huge ball's coordinates.
        let before = before / 67_108_864.0;
        let (huge, tiny) = (1e8 + (2.0 - before), 2.0 - before / 2.0);
        let radius = before / 4.0;
        let lit = picture(huge, "");
        let tiny =
            format!("[[define.balls.sphere]]\ncenter = [0, {tiny:?}, 0]\nradius = {radius:?}\n");
        assert!(lit != picture(huge, &tiny), "{before}");
    }
}

/// A floor below a lamp at a height of 2, and a definition with a ball of radius 1e8 around this height. Balls far away
/// make it worth sharing.
fn picture(height: f64, balls: &str) -> Image {
    let far =
        (10..40).map(|x| format!("[[define.balls.sphere]]\ncenter = [{x}, 0, 0]\nradius = 0.1\n"));
    let balls = far.fold(balls.to_owned(), |all, ball| all + &ball);
    let scene = format!(
        "[camera]\neye = [0, 1, 4]\nlook_at = [0, 0, 0]\nangle = 60\n\
        [material.m]\ndiffuse = [1, 1, 1]\n\
        [[point_light]]\ncolor = [4, 4, 4]\nposition = [0, 2, 0]\n\
        [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = \"m\"\n\
        [[define.balls.sphere]]\ncenter = [0, {height:?}, 0]\nradius = 1e8\n{balls}\
        [[use]]\nname = \"balls\"\nmaterial = \"m\"\n\
        [[use]]\nname = \"balls\"\nmaterial = \"m\"\ntransform = [{{ translate = [0, 9e8, 0] }}]\n"
    );
    let text = SceneText {
        scene,
        meshes: [].into(),
    };
    let settings = Settings {
        size: Size::new(40, 30).unwrap(),
        ..Settings::default()
    };
    compare(0, || view(FORMAT, &text).unwrap(), &settings)
}
