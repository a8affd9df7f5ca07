//! The second text's camera and ray.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{Bound, Case, Protocol};

use super::{AHEAD, triple};
use crate::{Camera, PinholeCamera, Ray, protocol};

/// 1 / sqrt(3).
const ONE_THIRD_ROOT: f64 = 0.577_350_269_189_625_8;

pub fn cases() -> Vec<Case> {
    let camera = |size: [u32; 2]| -> Result<_, ArgumentError> {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        Ok((camera, Size::new(size[0], size[1])?))
    };
    let through = |size, x, y| -> Result<[f64; 3], ArgumentError> {
        let (camera, size) = camera(size)?;
        Ok(triple(camera.generate_ray(size, x, y).direction()))
    };
    let of_pixel = |size, column, row_from_below| -> Result<[f64; 3], ArgumentError> {
        let (camera, size) = camera(size)?;
        let ray = camera.ray_for(size, column, row_from_below);
        Ok(triple(ray.direction()))
    };
    let text = |size: [u32; 2], x, y| {
        triple(protocol::pinhole_direction(
            size.map(f64::from),
            x,
            y,
            FRAC_PI_2,
        ))
    };
    let whole_sizes = protocol::pinhole_direction_of_whole_sizes([3, 601], 1.5, 300.5, FRAC_PI_2);
    let far = Vector3::new(0.0, 0.0, -2.0);
    let sky = Ray::new(Point3::ORIGIN, far).and_then(|ray| ray.bounded(f64::INFINITY));
    let seen = sky.map(|ray| ray.at(50.0).map(|point| point.to_glam().to_array()));
    let cut = protocol::point_at(Point3::ORIGIN, far, 30.0, 50.0);
    vec![
        Case::new(
            "E26",
            "pinhole, 3x3, middle of the middle pixel: through its corner",
            triple(AHEAD),
            Bound::Equal,
            of_pixel([3, 3], 1.0, 1.0),
        )
        .protocol(Protocol::Fails, text([3, 3], 1.0, 1.0)),
        Case::new(
            "E27",
            "pinhole, 3x601, middle (1.5, 300.5): sizes halved as whole numbers",
            triple(AHEAD),
            Bound::Equal,
            through([3, 601], 1.5, 300.5),
        )
        .protocol(Protocol::Fails, triple(whole_sizes)),
        Case::new(
            "E28",
            "pinhole, 10x10, corner (10, 10), which the text's loop leaves out",
            [ONE_THIRD_ROOT, -ONE_THIRD_ROOT, -ONE_THIRD_ROOT],
            Bound::Ulps(2.0),
            through([10, 10], 10.0, 10.0),
        )
        .protocol(Protocol::Holds, text([10, 10], 10.0, 10.0)),
        Case::new(
            "E29",
            "the point at t = 50 on a ray to the sky, which the text bounds by 30",
            [0.0, 0.0, -50.0],
            Bound::Equal,
            seen.ok().flatten(),
        )
        .protocol(Protocol::Fails, cut.map(|point| point.to_glam().to_array())),
        Case::new(
            "E30",
            "pinhole, 2x2, upper edge in the middle: 45 degrees up",
            [0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2],
            Bound::Ulps(2.0),
            through([2, 2], 1.0, 0.0),
        )
        .protocol(Protocol::Holds, text([2, 2], 1.0, 0.0)),
    ]
}
