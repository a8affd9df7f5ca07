//! Powers of cosines, for exponents from 0 to overflow.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Bound, Equal, Id, Refused, Ulps};
use measure::extremes::{Case, Fails, Holds, Outcome, Protocol};

use crate::{DirectionalLight, LitWorld, Material, Phong, protocol};

/// Radiance of a white highlight under a light straight above, for this cosine of
/// the angle between the mirrored light and the eye.
fn power(
    id: Id,
    cosine: f64,
    exponent: f64,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let up = Vector3::new(0.0, 0.0, 1.0);
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let ours = highlight(up, Vector3::new(sine, 0.0, cosine), exponent);
    let what = format!("highlight, cosine {cosine}, exponent {exponent:e}");
    Case::new(id, what, exact, bound, ours).protocol(says, protocol::highlight(cosine, exponent))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let nan = Vector3::new(f64::NAN, 0.0, 1.0);
    let above = 1.0_f64.next_up();
    // Light from a little below the surface, which would mirror it to the eye:
    // r = 2 (n · l) n - l = (-0.8, 0, -0.6), and r · e = 0.28.
    let (below, eye) = (Vector3::new(0.8, 0.0, -0.6), Vector3::new(-0.8, 0.0, 0.6));
    vec![
        power("F14", -0.3, 0.0, 0.0, Equal, Fails),
        power("F15", 0.5, 0.0, 1.0, Equal, Holds),
        power("F16", 1.0 - 1e-7, 1e6, 0.904_837_413_559_398_8, Ulps(4.0), Holds),
        power("F17", above, 1e17, 1.0, Equal, Fails),
        power("F18", above, f64::INFINITY, Refused, Equal, Fails),
        power("F19", 0.0, -1.0, Refused, Equal, Fails),
        Case::new("F20", "a ray of direction NaN, whose highlight has exponent 0",
            Refused, Equal, Ray::new(Point3::ORIGIN, nan).map(|_| true))
            .protocol(Fails, protocol::highlight(f64::NAN, 0.0)),
        // The exact values are powers of 1 - d for the given d; rounding the
        // cosine costs up to eps P / 4 of them.
        power("F21", 1.0 - 1e-7, 1e6, 0.904_837_413_511_772_2, Absolute(1e-10), Holds),
        power("F22", 1.0 - 1e-12, 1e12, 0.367_879_441_171_258_4, Absolute(5e-5), Holds),
        power("F34", 0.0, 0.0, 0.0, Equal, Fails),
        power("F35", 0.5, f64::NAN, Refused, Equal, Fails),
        Case::new("F36", "highlight of a light from behind the surface, exponent 2",
            0.0, Equal, highlight(below, eye, 2.0)).protocol(Fails, protocol::highlight(0.28, 2.0)),
    ]
}

/// The red of a surface (0, 0, 1) without a colour of its own.
fn highlight(light: Vector3, eye: Vector3, exponent: f64) -> Result<f64, ArgumentError> {
    let material = Phong::new(Color::BLACK, Color::WHITE, exponent)?;
    let sun = DirectionalLight::new(Color::WHITE, -light)?;
    let world = LitWorld::new(Color::BLACK, Color::BLACK)?.lit_by(Box::new(sun));
    let ray = Ray::derived(Point3::ORIGIN, -eye);
    let hit = Hit::new(1.0, Vector3::new(0.0, 0.0, 1.0).as_normal());
    Ok(material.color_for(&ray, &hit, &world).r)
}
