//! Perspective cameras anywhere, compared with the solution.

use crate::prelude::*;

yours! {
    PerspectiveCamera => new_camera(|([e, g, t], angle): ([_; 3], _)| {
        PerspectiveCamera::new(point(e), vector(g), vector(t), angle)
    })
}

/// Makes a camera of eye, gaze and up vector, and an angle.
type Code = NewCamera<([[f64; 3]; 3], f64)>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(floor),
        ..cameras()
    }
}

/// A floor of squares below the sky, by a camera that looks down aslant.
fn floor(new: &Code, settings: &Settings) -> Result<Image, Error> {
    let [e, g, t] = [[3.0, 3.0, 6.0], [-2.5, -2.5, -6.0], [-0.2, 1.0, 0.0]];
    let camera = new(([e, g, t], 0.9))?;
    let color = |ray: &Ray| {
        let d = ray.direction();
        if d.y() >= 0.0 {
            return Color::new(0.35, 0.55, 0.9);
        }
        let point = ray.at(-ray.origin().y() / d.y());
        if point.x().abs() > 4.0 || point.z().abs() > 4.0 {
            return Color::new(0.15, 0.3, 0.15);
        }
        if (point.x().floor() + point.z().floor()) % 2.0 == 0.0 {
            Color::new(0.9, 0.75, 0.45)
        } else {
            Color::new(0.6, 0.25, 0.1)
        }
    };
    paint(&*camera, &color, settings)
}
