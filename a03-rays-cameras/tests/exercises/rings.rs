//! Directions around poles, compared with the solution.

use crate::prelude::*;

yours! { ring }

type Code = fn(Vector3, Vector3, f64) -> u32;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(sky_of_rings),
        ..Exercise::asked(|ring: &Code, (direction, pole, width)| {
            ring(vector(direction), vector(pole), width)
        })
    }
}

fn sky_of_rings(ring: &Code, settings: &Settings) -> Result<Image, Error> {
    let pole = Vector3::new(0.3, 0.4, -1.0);
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(Point3::ORIGIN, gaze, up, FRAC_PI_3)?;
    let radiance = |ray: &Ray| match ring(ray.direction(), pole, 0.1) % 2 {
        0 => Color::from_bytes([25, 25, 112]),
        _ => Color::from_bytes([50, 205, 50]),
    };
    render(&camera, radiance, settings, &())
}
