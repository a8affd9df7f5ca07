//! Normals with known cosines, and the mean light of sky and ground.

use a02_math::{Normal3, Vector3};
use a05_lighting::Material;
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::scene::{Lights, balls, seen, show};

pub fn check<M: Material + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Color, Color) -> Result<M, ArgumentError>,
) {
    let sky = Color::new(0.2, 0.6, 1.0);
    let ground = Color::new(0.4, 0.2, 0.0);
    let Ok(material) = new(Color::new(1.0, 0.5, 0.25), sky, ground) else {
        return;
    };
    for (normal, exact) in [
        ([0.0, 1.0, 0.0], [0.2, 0.3, 0.25]),
        ([0.0, -1.0, 0.0], [0.4, 0.1, 0.0]),
        // A wall sees as much of the sky as of the ground.
        ([1.0, 0.0, 0.0], [0.3, 0.2, 0.125]),
        ([0.0, 0.0, -1.0], [0.3, 0.2, 0.125]),
        // Shares of the sky of 4/5 and 1/5.
        ([0.8, 0.6, 0.0], [0.24, 0.26, 0.2]),
        ([0.0, -0.6, 0.8], [0.36, 0.14, 0.05]),
    ] {
        let normal = Normal3::from_glam(normal.into());
        let eye = Vector3::from(normal);
        let lamp = Lights {
            color: Color::WHITE,
            directions: &[eye],
        };
        let what = format!("the colour where the normal is {}", normal.to_glam());
        let got = seen(&material, normal, eye, &lamp);
        check.expect(what, exact, Bound::Absolute(1e-15), got);
    }

    let (sky, ground) = (Color::new(0.8, 0.95, 1.2), Color::new(0.3, 0.22, 0.1));
    show(check, balls(|color| new(color, sky, ground)));
}
