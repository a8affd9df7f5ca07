//! A matt surface: the lesson's `Lambert`.

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a05_lighting::{Lambert, Lighting, Material};
use common::Color;

pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let matt = Lambert::new(diffuse);
    matt.map_or(Color::BLACK, |matt| matt.color_for(ray, hit, lighting))
}
