//! Rays through all points of lenses, compared with the solution.

use crate::prelude::*;

yours! { through_lens }

type Code = fn(&Basis, f64, &Ray, (f64, f64)) -> Ray;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(walls),
        ..Exercise::asked(
            |through: &Code, (eye, gaze, focus, [x, y], [right, up]): (_, _, _, [_; 2], [_; 2])| {
                let camera = camera(eye, gaze).ok()?;
                let ray = camera.ray_for(Size::new(5, 3).ok()?, x, y);
                let ray = through(&camera.basis(), focus, &ray, (right, up));
                Some(ray_answer(&ray))
            },
        )
    }
}

fn camera(eye: [f64; 3], gaze: [f64; 3]) -> Made<PerspectiveCamera> {
    let up = Vector3::new(0.0, 1.0, 0.0);
    PerspectiveCamera::new(point(eye), vector(gaze), up, FRAC_PI_4)
}

/// Three walls of holes, one behind the other; the middle one is in focus.
fn walls(through: &Code, settings: &Settings) -> Result<Image, Error> {
    let camera = camera([0.0; 3], [0.0, 0.0, -1.0])?;
    let (size, samples) = (settings.size, 64_u32);
    let bottom = f64::from(size.height() - 1);
    Image::from_fn(size, |x, y| {
        let ray = camera.ray_for(size, x.into(), bottom - f64::from(y));
        let random = PixelRandom::new(0, x, y);
        let mut sum = Color::BLACK;
        for n in (0..u64::from(samples)).map(|n| 2 * n) {
            let [right, up] = [n, n + 1].map(|n| 0.3 * (random.uniform(n) - 0.5));
            sum += wall(&through(&camera.basis(), 5.0, &ray, (right, up)));
        }
        sum / f64::from(samples)
    })
}

/// The colour of the nearest disc: a row of each, at three distances.
fn wall(ray: &Ray) -> Color {
    let (o, d) = (ray.origin(), ray.direction());
    for (z, middle, color) in [
        (-2.5, -0.7, Color::new(1.0, 0.3, 0.2)),
        (-5.0, 0.0, Color::new(0.3, 0.9, 0.3)),
        (-15.0, 4.0, Color::new(0.4, 0.5, 1.0)),
    ] {
        let p = ray.at((z - o.z()) / d.z());
        // As large in the picture at every distance.
        let (x, y) = (p.x() / z, (p.y() - middle) / z);
        let x = (x * 5.0 - (x * 5.0).round()) / 5.0;
        if x * x + y * y < 0.006 {
            return color;
        }
    }
    Color::gray(0.05)
}
