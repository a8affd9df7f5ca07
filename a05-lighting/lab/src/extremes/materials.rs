//! Colours of matt and shiny surfaces, each by a formula of its own, and the powers of their highlights.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::{Case, Outcome};

use crate::protocol;
use a05_lighting::{DirectionalLight, Lambert, LitWorld, Material, Phong};

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

/// The brightness of a gray matt surface under lights from straight above.
fn matt(diffuse: f64, lights: &[f64]) -> Outcome {
    let seen = seen(Lambert::new(Color::gray(diffuse)), FRONT, lights, FRONT);
    seen.map(|color| color.r).into()
}

/// A white highlight on a black surface.
fn highlight(exponent: f64, eye: Vector3, from: Vector3) -> Outcome {
    let phong = Phong::new(Color::BLACK, Color::WHITE, exponent);
    seen(phong, eye, &[1.0], from).map(|color| color.r).into()
}

/// The highlight of a light straight above, for a cosine of the angle between the mirrored
/// light and the eye.
pub fn power(cosine: f64, exponent: f64) -> Case {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let ours = highlight(exponent, Vector3::new(sine, 0.0, cosine), FRONT);
    Case::of(ours, protocol::highlight(cosine, exponent))
}

/// The highlight of a light from a little below the surface, which would mirror it to the eye:
/// r = 2 (n · l) n - l = (-0.8, 0, -0.6), and r · e = 0.28.
pub fn highlight_from_behind() -> Case {
    let below = Vector3::new(0.8, 0.0, -0.6);
    let eye = Vector3::new(-0.8, 0.0, 0.6);
    Case::of(highlight(2.0, eye, below), protocol::highlight(0.28, 2.0))
}

/// Without the sum over lights, only one counts.
pub fn two_lights() -> Case {
    let theirs = protocol::phong(1.0, 0.0, 0.25, 1.0, 0.0);
    Case::of(matt(1.0, &[0.25, 0.5]), theirs)
}

/// The green of a white highlight on a red surface: it has the colour of the light, not of the surface.
pub fn highlight_on_red() -> Case {
    let phong = Phong::new(Color::RED, Color::WHITE, 64.0);
    let ours = seen(phong, FRONT, &[1.0], FRONT).map(|color| color.g);
    let theirs = protocol::highlight(1.0, 64.0);
    Case::of(ours, protocol::phong(0.0, 0.0, 1.0, 1.0, theirs))
}

/// A light brighter than 1 is valid, and only the picture is clamped.
pub fn under_a_light(diffuse: f64, light: f64, theirs: fn(f64, f64) -> f64) -> Case {
    Case::of(matt(diffuse, &[light]), theirs(diffuse, light))
}
