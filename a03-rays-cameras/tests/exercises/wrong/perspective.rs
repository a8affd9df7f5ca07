//! Wrong solutions.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, Ray};
use common::Size;
use testing::exercise::{Check, Wrong};

use crate::perspective;

/// A camera with the right rays for its axes u, v and w.
struct Perspective(Point3, [Vector3; 3], f64);

impl Camera for Perspective {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let Self(e, [u, v, w], angle) = self;
        let (x, y) = (x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0);
        let z = height / 2.0 / libm::tan(angle / 2.0);
        let d = *u * x + *v * y - *w * z;
        Ray::derived(*e, d.normalized().unwrap_or_default())
    }
}

/// A camera of axes made from gaze and up vector, both of length 1.
fn check(check: &mut Check, axes: fn(Vector3, Vector3) -> [Vector3; 3]) {
    perspective::check(check, |e, g, t, angle| {
        Ok(Perspective(e, axes(g.unit("g")?, t.unit("t")?), angle))
    });
}

fn unit(v: Vector3) -> Vector3 {
    v.normalized().unwrap_or_default()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "w along the gaze",
        says: "through the middle",
        check: |c| {
            check(c, |g, t| {
                let u = unit(t.cross(g));
                [u, g.cross(u), g]
            });
        },
    },
    Wrong {
        mistake: "left and right swapped",
        says: "at the right edge",
        check: |c| {
            check(c, |g, t| {
                let u = unit(g.cross(t));
                [-u, u.cross(g), -g]
            });
        },
    },
    Wrong {
        mistake: "the up vector itself as axis, which is not perpendicular to the gaze",
        says: "at the upper edge",
        check: |c| check(c, |g, t| [unit(g.cross(t)), t, -g]),
    },
    Wrong {
        mistake: "u is not of length 1",
        says: "at the right edge",
        check: |c| {
            check(c, |g, t| {
                let u = g.cross(t);
                [u, unit(u.cross(g)), -g]
            });
        },
    },
];
