//! A matt surface: the lesson's `Lambert`.

use crate::prelude::*;

pub fn lambert(diffuse: Color, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let matt = Lambert::new(diffuse);
    matt.map_or(Color::BLACK, |matt| matt.color_for(ray, hit, lighting))
}
