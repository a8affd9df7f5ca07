//! Fisheyes anywhere, compared with the solution.

use crate::prelude::*;

yours! {
    Fisheye => new_camera(|(e, gaze, angle)| {
        Ok(Fisheye::new(crate::fisheye::basis(e, gaze)?, angle))
    })
}

/// Makes a camera of eye, gaze and angle.
type Code = NewCamera<([f64; 3], [f64; 3], f64)>;

pub fn basis(e: [f64; 3], gaze: [f64; 3]) -> Made<Basis> {
    Basis::new(point(e), vector(gaze), Vector3::new(0.0, 1.0, 0.0))
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|new: &Code, settings| {
            let camera = new(([1.0, 2.0, 3.0], [0.0, 0.3, -1.0], PI))?;
            render(&*camera, globe, settings, &())
        }),
        ..cameras()
    }
}

/// A globe of meridians and parallels, seen from inside.
fn globe(ray: &Ray) -> Color {
    let d = ray.direction();
    let up = libm::atan2(d.y(), libm::hypot(d.x(), d.z()));
    let around = libm::atan2(d.x(), -d.z());
    let fields = (up / FRAC_PI_6).floor() + (around / FRAC_PI_6).floor();
    let light = 0.4 + 0.6 * fields.rem_euclid(2.0);
    let [green, blue] = [Color::new(0.3, 0.8, 0.3), Color::new(0.4, 0.6, 1.0)];
    (if d.y() < 0.0 { green } else { blue }) * light
}
