//! Lights and eyes between which the half vector is known.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a05_lighting::{Material, PointLight};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::scene::{Lights, balls, color, seen, show, unit};

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
    let along = Vector3::new(1.0, 0.0, 0.0);
    case("light along the surface", up, &[along], 1.0, [0.0, 0.0]);
    case("light from behind", low, &[below], 0.0, [0.0, 0.0]);

    // The eye is where the light is mirrored to about a half vector that is known.
    let mut random = Random::new(4);
    for n in 0..60 {
        let [normal, half, light] = [(); 3].map(|()| unit(&mut random));
        let light = if light.dot(half) < 0.0 { -light } else { light };
        let eye = half * (2.0 * half.dot(light)) - light;
        let [diffuse, specular, lamp] = [(); 3].map(|()| color(&mut random));
        let exponent = f64::from([1, 2, 5, 30][n % 4]);
        let Ok(material) = new(diffuse, specular, exponent) else {
            return;
        };
        let lights = Lights {
            color: lamp,
            directions: &[light],
        };
        let (cosine, highlight) = (
            normal.dot(light),
            libm::pow(normal.dot(half).max(0.0), exponent),
        );
        let is_lit = f64::from(u8::from(cosine > 0.0));
        let exact = (diffuse * cosine + specular * highlight) * lamp * is_lit;
        let what = format!(
            "normal {:.3}, light from {:.3}, eye at {:.3}, exponent {exponent}, diffuse {:?}, specular {:?}, light {:?}",
            normal.to_glam(),
            light.to_glam(),
            eye.to_glam(),
            diffuse.channels(),
            specular.channels(),
            lamp.channels()
        );
        let got = seen(&material, normal.as_normal(), eye, &lights);
        check.expect(what, exact.channels(), Bound::Absolute(1e-13), got);
    }

    let lamp = PointLight::new(Color::WHITE, Point3::new(-3.0, 4.0, 4.0));
    let world = lamp.and_then(|lamp| {
        let balls = balls(|color| new(color * 0.8, Color::gray(0.7), 64.0))?;
        Ok(balls.lit_by(Box::new(lamp)))
    });
    show(check, world);
}
