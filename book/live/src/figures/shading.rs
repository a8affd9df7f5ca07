//! Lambert and Phong: the light that a point of a floor sends to the eye, and to all
//! other directions.

use std::f64::consts::PI;

use a02_math::{Direction, Normal3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Illumination, Lambert, Lighting, Material, Phong};
use common::Color;

use super::{Answered, direction, flat, point};
use crate::Reply;

/// One white light.
struct Lamp(Illumination);

impl Lighting for Lamp {
    fn ambient(&self) -> Color {
        Color::BLACK
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        shade(&self.0);
    }
}

const DIFFUSE: f64 = 0.5;

/// Number: the angle of the light, in radians from the right, above a level matt floor.
pub fn lambert([light]: [f64; 1]) -> Answered {
    let answer = answer([light, 0.0, 1.0])?;
    let cosine = answer.get("cosine")[0];
    Ok(Reply::default()
        .with("angle", [libm::acos(cosine).to_degrees()])
        .with("cosine", [cosine])
        // A beam that is 1 wide.
        .with("lit", [1.0 / cosine.max(0.0)])
        .with("diffuse", [answer.get("diffuse")[0] / DIFFUSE]))
}

/// Directions of the lobe, over the half circle above the floor.
const DIRECTIONS: u32 = 180;

/// Numbers: the angles of light and eye, in radians from the right, and the exponent.
/// The floor is level; its diffuse reflectance is 0.5, its specular one 0.5.
pub fn answer([light, eye, exponent]: [f64; 3]) -> Answered {
    let normal = Normal3::new(0.0, 1.0, 0.0);
    let hit = Hit::new(1.0, normal);
    let l = direction(light);
    let lamp = Lamp(Illumination {
        color: Color::WHITE,
        direction: l,
        distance: 1.0,
    });
    let matt = Lambert::new(Color::gray(DIFFUSE))?;
    let shiny = Phong::new(Color::BLACK, Color::gray(0.5), exponent)?;
    let seen = |material: &dyn Material, eye: f64| {
        let to_eye = direction(eye);
        let ray = Ray::derived(point(0.0, 0.0) + to_eye, -to_eye);
        material.color_for(&ray, &hit, &lamp).r
    };
    let (diffuse, highlight) = (seen(&matt, eye), seen(&shiny, eye));
    let lobe = (0..=DIRECTIONS)
        .map(|i| PI * f64::from(i) / f64::from(DIRECTIONS))
        .map(|eye| seen(&matt, eye) + seen(&shiny, eye));
    Ok(Reply::default()
        .with("diffuse", [diffuse])
        .with("highlight", [highlight])
        .with("sum", [diffuse + highlight])
        .with("cosine", [normal.dot(l)])
        .with("reflected", flat(l.reflected_on(normal)))
        .with("lobe", lobe))
}
