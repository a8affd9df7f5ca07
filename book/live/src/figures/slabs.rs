//! The slabs of a box: where a ray enters and leaves each, and the box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval};

use super::{Answered, both_hits, flat, point};
use crate::Answer;

/// Half the length of a slab: far beyond the figure.
const FAR: f64 = 1e6;

/// Numbers: origin of the ray and a point that it passes. The box reaches from -1 to 1
/// in x and from -0.7 to 0.7 in y; the third slab is parallel to the figure.
pub fn answer([ox, oy, x, y]: [f64; 4]) -> Answered {
    let o = point(ox, oy);
    let ray = Ray::new(o, point(x, y) - o)?;
    let slab =
        |x: f64, y: f64| AxisAlignedBox::new(Point3::new(-x, -y, -1.0), Point3::new(x, y, 1.0));
    let hit = slab(1.0, 0.7)?.hit(&ray, Interval::AHEAD);
    Ok(Answer::default()
        .with("direction", flat(ray.direction()))
        .with("x_slab", both_hits(&slab(1.0, FAR)?, &ray))
        .with("y_slab", both_hits(&slab(FAR, 0.7)?, &ray))
        .with("both", both_hits(&slab(1.0, 0.7)?, &ray))
        .with("hit", hit.map(|hit| vec![hit.t]).unwrap_or_default())
        .with(
            "normal",
            hit.map(|hit| flat(hit.normal).to_vec()).unwrap_or_default(),
        ))
}
