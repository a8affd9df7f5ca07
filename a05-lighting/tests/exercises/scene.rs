//! Pictures of students' code, and vectors and colours from numbers.

use crate::prelude::*;

/// The direction of length 1; all zeros where there is none.
pub fn unit(xyz: [f64; 3]) -> Vector3 {
    vector(xyz).normalized().unwrap_or_default()
}

pub fn array(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}

pub fn color([r, g, b]: [f64; 3]) -> Color {
    Color::new(r, g, b)
}

/// The channels of a random colour.
pub fn channels(random: &mut Random) -> [f64; 3] {
    [(); 3].map(|()| random.between(0.0, 1.5))
}

/// The picture of a scene in the colours of this function, which takes the world, a ray and
/// the depth.
pub fn rendered<W: Sync>(
    view: Made<View<W>>,
    color: impl Fn(&W, &Ray, u32) -> Color + Sync,
) -> impl FnOnce(&Settings) -> Result<Image, Error> {
    move |settings| {
        let View { camera, world } = view?;
        let color: &(dyn Fn(&Ray) -> Color + Sync) = &|ray| color(&world, ray, settings.depth);
        paint(&camera, color, settings)
    }
}
