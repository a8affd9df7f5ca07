//! Colours by the protocol's printed formulas, and powers of cosines for exponents from 0
//! to overflow.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Bound, Equal, Id, Refused, Ulps};
use measure::extremes::{Case, Fails, Holds, Outcome, Protocol};

use crate::lab::protocol;
use crate::{DirectionalLight, Lambert, LitWorld, Material, Phong};

const FRONT: Vector3 = Vector3::new(0.0, 0.0, 1.0);

/// The colour of a surface that faces (0, 0, 1), seen from the direction `eye`, in gray
/// lights from one direction.
fn seen(
    material: Result<impl Material, ArgumentError>,
    eye: Vector3,
    lights: &[f64],
    from: Vector3,
) -> Result<Color, ArgumentError> {
    let mut world = LitWorld::new(Color::BLACK, Color::BLACK)?;
    for light in lights {
        let light = DirectionalLight::new(Color::gray(*light), -from)?;
        world = world.lit_by(Box::new(light));
    }
    let ray = Ray::derived(Point3::ORIGIN, -eye);
    Ok(material?.color_for(&ray, &Hit::new(1.0, FRONT.as_normal()), &world))
}

/// The red of a white highlight on a black surface.
fn highlight(exponent: f64, eye: Vector3, from: Vector3) -> Result<f64, ArgumentError> {
    let material = Phong::new(Color::BLACK, Color::WHITE, exponent);
    seen(material, eye, &[1.0], from).map(|color| color.r)
}

/// A highlight under a light straight above, for this cosine of the angle between the
/// mirrored light and the eye.
fn power(
    id: Id,
    cosine: f64,
    exponent: f64,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let ours = highlight(exponent, Vector3::new(sine, 0.0, cosine), FRONT);
    let what = format!("highlight, cosine {cosine}, exponent {exponent:e}");
    Case::new(id, what, exact, bound, ours).protocol(says, protocol::highlight(cosine, exponent))
}

/// Without the sum over lights, only one counts; the highlight has the colour of the
/// light, not of the surface; a light brighter than 1 is valid, and only the picture is
/// clamped. The bound of the dark product is half a level of 255.
#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let nan = Vector3::new(f64::NAN, 0.0, 1.0);
    let above = 1.0_f64.next_up();
    // Light from a little below the surface, which would mirror it to the eye:
    // r = 2 (n · l) n - l = (-0.8, 0, -0.6), and r · e = 0.28.
    let (below, eye) = (Vector3::new(0.8, 0.0, -0.6), Vector3::new(-0.8, 0.0, 0.6));
    let matt = |diffuse, lights: &[f64]|
        seen(Lambert::new(Color::gray(diffuse)), FRONT, lights, FRONT).map(|c| c.r);
    let green = seen(Phong::new(Color::RED, Color::WHITE, 64.0), FRONT, &[1.0], FRONT).map(|c| c.g);
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
            0.0, Equal, highlight(2.0, eye, below)).protocol(Fails, protocol::highlight(0.28, 2.0)),
        Case::new("L01", "white under lights of 1/4 and 1/2", 0.75, Equal, matt(1.0, &[0.25, 0.5]))
            .protocol(Fails, protocol::phong(1.0, 0.0, 0.25, 1.0, 0.0)),
        Case::new("L02", "white highlight on red: its green", 1.0, Equal, green)
            .protocol(Fails, protocol::phong(0.0, 0.0, 1.0, 1.0, protocol::highlight(1.0, 64.0))),
        Case::new("L03", "a surface of 1/4 under a light of 3", 0.75, Equal, matt(0.25, &[3.0]))
            .protocol(Fails, protocol::clamped_product(0.25, 3.0)),
        Case::new("L04", "a surface of 1/10 under a light of 1/10", 0.01, Absolute(1.0 / 510.0), matt(0.1, &[0.1]))
            .protocol(Fails, protocol::integer_product(0.1, 0.1)),
    ]
}
