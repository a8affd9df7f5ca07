//! The second text's camera and ray.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use a02_math::{Point3, Vector3};
use common::Size;
use measure::extremes::{Case, Equal, Fails, Holds, Outcome, Ulps, tried};

use super::AHEAD;
use crate::{Camera, PinholeCamera, Ray, protocol};

/// Direction through a place of the picture, counted from its upper left corner.
fn ours([w, h]: [u32; 2], x: f64, y: f64) -> Outcome {
    let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2);
    let size = Size::new(w, h);
    tried(|| Ok(camera?.generate_ray(size?, x, y).direction()))
}

fn theirs(size: [u32; 2], x: f64, y: f64) -> Vector3 {
    protocol::pinhole_direction(size.map(f64::from), x, y, FRAC_PI_2)
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    /// 1 / sqrt(3).
    const THIRD: f64 = 0.577_350_269_189_625_8;
    let far = Vector3::new(0.0, 0.0, -2.0);
    let of_pixel = tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        Ok(camera.ray_for(Size::new(3, 3)?, 1.0, 1.0).direction())
    });
    let sky = Ray::new(Point3::ORIGIN, far).and_then(|ray| ray.bounded(f64::INFINITY));
    vec![
        Case::new("E26", "pinhole, 3x3, middle of the middle pixel: through its corner",
            AHEAD, Equal, of_pixel).protocol(Fails, theirs([3, 3], 1.0, 1.0)),
        Case::new("E27", "pinhole, 3x601, middle (1.5, 300.5): sizes halved as whole numbers",
            AHEAD, Equal, ours([3, 601], 1.5, 300.5))
            .protocol(Fails, protocol::pinhole_direction_of_whole_sizes([3, 601], 1.5, 300.5, FRAC_PI_2)),
        Case::new("E28", "pinhole, 10x10, corner (10, 10), which the text's loop leaves out",
            [THIRD, -THIRD, -THIRD], Ulps(2.0), ours([10, 10], 10.0, 10.0))
            .protocol(Holds, theirs([10, 10], 10.0, 10.0)),
        Case::new("E29", "the point at t = 50 on a ray to the sky, which the text bounds by 30",
            [0.0, 0.0, -50.0], Equal, sky.map(|ray| ray.at(50.0)).ok().flatten())
            .protocol(Fails, protocol::point_at(Point3::ORIGIN, far, 30.0, 50.0)),
        Case::new("E30", "pinhole, 2x2, upper edge in the middle: 45 degrees up",
            [0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2], Ulps(2.0), ours([2, 2], 1.0, 0.0))
            .protocol(Holds, theirs([2, 2], 1.0, 0.0)),
    ]
}
