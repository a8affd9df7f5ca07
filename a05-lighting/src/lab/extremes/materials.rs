//! Colours by the protocol's printed formulas.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::{ArgumentError, Color};
use measure::extremes::Protocol::Fails;
use measure::extremes::{Bound, Case};

use crate::{DirectionalLight, Lambert, LitWorld, Material, Phong, protocol};

pub fn cases() -> Vec<Case> {
    vec![
        two_lights("L01"),
        white_highlight_on_red("L02"),
        bright_light("L03"),
        dark_product("L04"),
    ]
}

type Shaded = Result<Color, ArgumentError>;

/// A surface that faces eye and lights.
fn shaded(material: &dyn Material, lights: &[f64]) -> Shaded {
    let down = Vector3::new(0.0, 0.0, -1.0);
    let mut world = LitWorld::new(Color::BLACK, Color::BLACK)?;
    for light in lights {
        let light = DirectionalLight::new(Color::gray(*light), down)?;
        world = world.lit_by(Box::new(light));
    }
    let ray = Ray::derived(Point3::new(0.0, 0.0, 1.0), down);
    Ok(material.color_for(&ray, &Hit::new(1.0, (-down).as_normal()), &world))
}

fn lambert(diffuse: f64, lights: &[f64]) -> Result<f64, ArgumentError> {
    let material = Lambert::new(Color::gray(diffuse))?;
    Ok(shaded(&material, lights)?.r)
}

/// Without the sum, only one light counts.
fn two_lights(id: &'static str) -> Case {
    let ours = lambert(1.0, &[0.25, 0.5]);
    Case::new(
        id,
        "white under lights of 1/4 and 1/2",
        0.75,
        Bound::Equal,
        ours,
    )
    .protocol(Fails, protocol::phong(1.0, 0.0, 0.25, 1.0, 0.0))
}

/// The highlight has the colour of the light, not the colour of the surface.
fn white_highlight_on_red(id: &'static str) -> Case {
    let green = || {
        let material = Phong::new(Color::RED, Color::WHITE, 64.0)?;
        Ok::<_, ArgumentError>(shaded(&material, &[1.0])?.g)
    };
    let theirs = protocol::phong(0.0, 0.0, 1.0, 1.0, protocol::highlight(1.0, 64.0));
    Case::new(
        id,
        "white highlight on red: its green",
        1.0,
        Bound::Equal,
        green(),
    )
    .protocol(Fails, theirs)
}

/// A light brighter than 1 is valid; only the picture is clamped.
fn bright_light(id: &'static str) -> Case {
    let ours = lambert(0.25, &[3.0]);
    Case::new(
        id,
        "a surface of 1/4 under a light of 3",
        0.75,
        Bound::Equal,
        ours,
    )
    .protocol(Fails, protocol::clamped_product(0.25, 3.0))
}

/// The bound is half a level of 255.
fn dark_product(id: &'static str) -> Case {
    let ours = lambert(0.1, &[0.1]);
    let bound = Bound::Absolute(1.0 / 510.0);
    Case::new(
        id,
        "a surface of 1/10 under a light of 1/10",
        0.01,
        bound,
        ours,
    )
    .protocol(Fails, protocol::integer_product(0.1, 0.1))
}
