//! Wrong solutions.

use a03_rays_cameras::Ray;
use testing::exercise::{Check, Wrong};

use crate::stripe;

/// A sky whose stripe follows from height, height of the upper edge, and number of
/// stripes.
fn check(check: &mut Check, stripe: fn(f64, f64, f64) -> u32) {
    stripe::check(
        check,
        |camera, size, stripes| {
            let edge = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
            Ok((edge.direction().y(), f64::from(stripes)))
        },
        |(top, stripes), ray: &Ray| stripe(ray.direction().y(), *top, *stripes),
    );
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the upper edge of the picture is left out",
        says: "of a stripe",
        check: |c| {
            check(c, |y, _, n| {
                ((f64::midpoint(y, 1.0) * n) as u32).min(n as u32 - 1)
            });
        },
    },
    Wrong {
        mistake: "counted from above",
        says: "in the middle of a stripe",
        check: |c| {
            check(c, |y, top, n| {
                (((1.0 - y / top) / 2.0 * n) as u32).min(n as u32 - 1)
            });
        },
    },
    Wrong {
        mistake: "one stripe too many above the picture",
        says: "above the picture",
        check: |c| check(c, |y, top, n| (f64::midpoint(y / top, 1.0) * n) as u32),
    },
    Wrong {
        mistake: "rounded to the nearest instead of down",
        says: "in the middle of a stripe",
        check: |c| {
            check(c, |y, top, n| {
                ((f64::midpoint(y / top, 1.0) * n).round() as u32).min(n as u32 - 1)
            });
        },
    },
    Wrong {
        mistake: "stripes begin at the horizon",
        says: "in the middle of a stripe",
        check: |c| check(c, |y, top, n| ((y / top * n) as u32).min(n as u32 - 1)),
    },
];
