//! Colours by the protocol's printed formulas.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Case, Equal, Fails};

use crate::{DirectionalLight, Lambert, LitWorld, Material, Phong, protocol};

/// The colour of a surface that faces eye and lights.
fn shaded(
    material: Result<impl Material, ArgumentError>,
    lights: &[f64],
) -> Result<Color, ArgumentError> {
    let down = Vector3::new(0.0, 0.0, -1.0);
    let mut world = LitWorld::new(Color::BLACK, Color::BLACK)?;
    for light in lights {
        let light = DirectionalLight::new(Color::gray(*light), down)?;
        world = world.lit_by(Box::new(light));
    }
    let ray = Ray::derived(Point3::new(0.0, 0.0, 1.0), down);
    Ok(material?.color_for(&ray, &Hit::new(1.0, (-down).as_normal()), &world))
}

/// Without the sum over lights, only one counts; the highlight has the colour of the
/// light, not of the surface; a light brighter than 1 is valid, and only the picture is
/// clamped. The bound of the dark product is half a level of 255.
#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let matt = |diffuse, lights: &[f64]| shaded(Lambert::new(Color::gray(diffuse)), lights).map(|c| c.r);
    let green = shaded(Phong::new(Color::RED, Color::WHITE, 64.0), &[1.0]).map(|c| c.g);
    vec![
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
