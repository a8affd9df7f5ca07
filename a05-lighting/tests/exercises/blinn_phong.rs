//! Lights and eyes between which the half vector has a known cosine.

use a02_math::{Normal3, Point3, Vector3};
use a05_lighting::{Material, PointLight};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::scene::{Lights, balls, seen, show};

pub fn check<M: Material + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Color, f64) -> Result<M, ArgumentError>,
) {
    let normal = Normal3::new(0.0, 1.0, 0.0);
    let (diffuse, specular) = (Color::new(0.5, 0.0, 0.0), Color::new(0.0, 1.0, 0.0));
    let up = Vector3::new(0.0, 1.0, 0.0);
    // Twice the angle whose cosine is 4/5.
    let aslant = Vector3::new(0.96, 0.28, 0.0);
    let (low, beyond) = (Vector3::new(0.8, 0.6, 0.0), Vector3::new(-0.8, 0.6, 0.0));
    let below = Vector3::new(0.6, -0.8, 0.0);
    let mut case = |what: &str, eye, directions: &[Vector3], exponent, exact: [f64; 2]| {
        let Ok(material) = new(diffuse, specular, exponent) else {
            return;
        };
        let lights = Lights {
            color: Color::gray(0.5),
            directions,
        };
        let got = seen(&material, normal, eye, &lights);
        let what = format!("{what}, exponent {exponent}");
        check.expect(what, [exact[0], exact[1], 0.0], Bound::Absolute(1e-14), got);
    };
    case(
        "light and eye along the normal",
        up,
        &[up],
        8.0,
        [0.25, 0.5],
    );
    case("light aslant, eye above", up, &[aslant], 1.0, [0.07, 0.4]);
    case("light aslant, eye above", up, &[aslant], 2.0, [0.07, 0.32]);
    case("eye aslant, light above", aslant, &[up], 2.0, [0.25, 0.32]);
    case("light where the eye is", low, &[low], 2.0, [0.15, 0.18]);
    case(
        "light mirrored into the eye",
        low,
        &[beyond],
        64.0,
        [0.15, 0.5],
    );
    case("two lights", up, &[up, aslant], 2.0, [0.32, 0.82]);
    case("light from behind", low, &[below], 1.0, [0.0, 0.0]);
    case("light from behind", low, &[below], 0.0, [0.0, 0.0]);

    let lamp = PointLight::new(Color::WHITE, Point3::new(-3.0, 4.0, 4.0));
    let world = lamp.and_then(|lamp| {
        let balls = balls(|color| new(color * 0.8, Color::gray(0.7), 64.0))?;
        Ok(balls.lit_by(Box::new(lamp)))
    });
    show(check, world);
}
