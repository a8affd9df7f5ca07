//! Rays into glass and out of it, also just before and beyond total reflection, compared with
//! the solution.

use crate::prelude::*;

yours! { refracted }

/// The direction beyond a surface: by the direction before, the normal, and the index.
type Code = fn(Vector3, Normal3, f64) -> Option<Vector3>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(under_water),
        ..Exercise::asked(|refracted: &Code, (d, n, index)| {
            refracted(unit(d), unit(n).as_normal(), index).map(array)
        })
    }
}

/// Objects below the surface of a water, seen from above.
fn under_water(refracted: &Code, settings: &Settings) -> Result<Image, Error> {
    let (surface, up) = (2.5, Normal3::new(0.0, 1.0, 0.0));
    rendered(&scenes::sphere()?, settings, |world, ray, depth| {
        let Some(below) = refracted(ray.direction(), up, 4.0 / 3.0) else {
            return Color::BLACK;
        };
        let t = (surface - ray.origin().y()) / ray.direction().y();
        RecursiveTracer::new(world).trace(&Ray::derived(ray.at(t), below), depth)
    })
}
