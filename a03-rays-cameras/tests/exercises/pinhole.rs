//! Pinhole cameras anywhere, compared with the solution.

use a03_rays_cameras::instruments::Instruments;

use crate::prelude::*;

yours! { PinholeCamera => new_camera(|(e, angle)| PinholeCamera::new(point(e), angle)) }

/// Makes a camera of a pinhole and an angle.
type Code = NewCamera<([f64; 3], f64)>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("striped-sky", |new: &Code, settings| {
            let sky = scenes::striped_sky(settings.size, StripeRule::Direction)?.world;
            let sky = Box::new(sky).instrumented(Instruments::LESSON);
            let camera = new(([0.0; 3], FRAC_PI_2))?;
            paint(&*camera, &|ray: &Ray| sky.radiance(ray, 1), settings)
        }),
        ..cameras()
    }
}
