//! Pinhole cameras anywhere, compared with the lesson's.

use std::f64::consts::FRAC_PI_2;

use crate::camera::compare;
use crate::prelude::*;

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Point3, f64) -> Result<C, ArgumentError>) {
    compare(
        check,
        "pinhole at {}, opening angle {}",
        ([0.0; 3], FRAC_PI_2),
        |r| (r.triple(9.0), r.between(0.2, 2.8)),
        |(e, angle)| PinholeCamera::new(point(e), angle),
        |(e, angle)| new(point(e), angle),
    );
    scene(check, |settings, _, sky| {
        let camera = new(Point3::ORIGIN, FRAC_PI_2)?;
        render(&camera, |ray| sky.color_for(ray), settings, &())
    });
}

/// A direction from width and height, the place from the lower left corner, and the angle.
type Way = fn([f64; 2], [f64; 2], f64) -> Vector3;

struct Own(Point3, f64, Way);

impl Camera for Own {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let size = [size.width(), size.height()].map(f64::from);
        let way = (self.2)(size, [x + 0.5, y + 0.5], self.1);
        Ray::derived(self.0, way.normalized().unwrap_or_default())
    }
}

fn own(c: &mut Check, way: Way) {
    check(c, |e, angle| Ok(Own(e, angle, way)));
}

pub const VARIANTS: &[Variant] = &[
    right("at the distance 1", |c| {
        own(c, |[w, h], [x, y], angle| {
            let scale = 2.0 * libm::tan(angle / 2.0) / h;
            Vector3::new((x - w / 2.0) * scale, (y - h / 2.0) * scale, -1.0)
        });
    }),
    wrong("half of the angle is above the middle, half below", |c| {
        own(c, |[w, h], [x, y], angle| {
            Vector3::new(x - w / 2.0, y - h / 2.0, -h / 2.0 / libm::tan(angle))
        });
    }),
];
