//! A shiny surface: the lesson's `Phong`.

use crate::prelude::*;

pub fn phong([d, s]: [Color; 2], p: f64, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
    let shiny = Phong::new(d, s, p);
    shiny.map_or(Color::BLACK, |shiny| shiny.color_for(ray, hit, lighting))
}
