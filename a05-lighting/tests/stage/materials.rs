//! Materials: colours calculated by hand, and surfaces that must not shine.

mod highlights;
mod matt;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lambert, Lighting, Material, Phong};
use approx::assert_abs_diff_eq;
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
/// 0.6² + 0.8² = 1: the cosine to the normal is 0.8, and both reflect into
/// each other.
const LEFT: Vector3 = Vector3::new(-0.6, 0.8, 0.0);
const RIGHT: Vector3 = Vector3::new(0.6, 0.8, 0.0);
/// Rounding of a few products.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// An ambient light, and lights that all arrive.
struct FixedLights(Color, Vec<Illumination>);

impl Lighting for FixedLights {
    fn ambient(&self) -> Color {
        self.0
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.1.iter().for_each(shade);
    }
}

/// An ambient light, and lights of these colours from these directions.
fn light(ambient: Color, lights: &[(Color, Vector3)]) -> FixedLights {
    let light = |&(color, direction): &(Color, Vector3)| Illumination {
        color,
        direction,
        distance: 1.0,
    };
    FixedLights(ambient, lights.iter().map(light).collect())
}

/// White light from this direction.
fn white_from(direction: Vector3) -> FixedLights {
    light(Color::BLACK, &[(Color::WHITE, direction)])
}

/// The colour of a surface that faces upwards, seen from the direction `e`.
fn seen_from(e: Vector3, material: &dyn Material, lighting: &dyn Lighting) -> Color {
    let ray = Ray::derived(Point3::ORIGIN + e, -e);
    material.color_for(&ray, &Hit::new(1.0, UP.as_normal()), lighting)
}

fn assert_close(color: Color, expected: Color) {
    for (channel, expected) in color.channels().into_iter().zip(expected.channels()) {
        assert_abs_diff_eq!(channel, expected, epsilon = ROUNDING);
    }
}

fn lambert(diffuse: Color) -> Lambert {
    Lambert::new(diffuse).unwrap()
}

fn phong(diffuse: Color, specular: Color, exponent: f64) -> Phong {
    Phong::new(diffuse, specular, exponent).unwrap()
}
