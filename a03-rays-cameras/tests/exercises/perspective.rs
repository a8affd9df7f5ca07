//! Perspective cameras anywhere, compared with the lesson's.

use std::f64::consts::FRAC_PI_2;

use crate::camera::compare;
use crate::prelude::*;

pub fn check<C: Camera>(
    check: &mut Check,
    new: impl Fn(Point3, Vector3, Vector3, f64) -> Result<C, ArgumentError>,
) {
    let (gaze, up) = ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    compare(
        check,
        "eye {}, gaze {}, up {}, opening angle {}",
        ([0.0; 3], gaze, up, FRAC_PI_2),
        |r| {
            (
                r.triple(9.0),
                r.triple(3.0),
                r.triple(3.0),
                r.between(0.2, 2.8),
            )
        },
        |(e, g, t, angle)| PerspectiveCamera::new(point(e), vector(g), vector(t), angle),
        |(e, g, t, angle)| new(point(e), vector(g), vector(t), angle),
    );
    scene(check, |settings, _, sky| {
        let camera = new(Point3::ORIGIN, vector(gaze), vector(up), FRAC_PI_2)?;
        render(&camera, |ray| sky.color_for(ray), settings, &())
    });
}

/// A camera with these axes u, v and w.
struct Own(Point3, [Vector3; 3], f64);

impl Camera for Own {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        // The height of the picture is 2.
        let [x, y] = [x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0].map(|p| 2.0 * p / height);
        let [u, v, w] = self.1;
        let d = u * x + v * y - w * (1.0 / libm::tan(self.2 / 2.0));
        Ray::derived(self.0, d.normalized().unwrap_or_default())
    }
}

/// The axes that follow from w and the up vector.
fn variant(c: &mut Check, axes: fn(Vector3, Vector3) -> [Vector3; 3]) {
    check(c, |e, g, t, angle| {
        Ok(Own(e, axes(-g.unit("g")?, t.unit("t")?), angle))
    });
}

fn unit(v: Vector3) -> Vector3 {
    v.normalized().unwrap_or_default()
}

pub const VARIANTS: &[Variant] = &[
    right("the part of the up vector across the gaze", |c| {
        variant(c, |w, t| {
            let v = unit(t - w * t.dot(w));
            [v.cross(w), v, w]
        });
    }),
    wrong(
        "u is of length 1 only if the up vector is perpendicular to the gaze",
        |c| {
            variant(c, |w, t| [t.cross(w), w.cross(t.cross(w)), w]);
        },
    ),
    wrong(
        "the up vector need not be perpendicular to the gaze, but v is",
        |c| {
            variant(c, |w, t| [unit(t.cross(w)), t, w]);
        },
    ),
];
