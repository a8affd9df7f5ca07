//! The three slabs of a box: where a ray enters and leaves each, and the box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval};

use super::{Answered, both_hits, flat};
use crate::Reply;

/// Half the length of a slab: far beyond the figure.
const FAR: f64 = 1e6;

/// Numbers: x and y of the ray's origin and of a point that it passes, then z of both.
/// The box reaches from -1 to 1 in x and z, and from -0.7 to 0.7 in y.
pub fn answer([ox, oy, x, y, oz, z]: [f64; 6]) -> Answered {
    let o = Point3::new(ox, oy, oz);
    let ray = Ray::new(o, Point3::new(x, y, z) - o)?;
    let slab =
        |x: f64, y: f64, z: f64| AxisAlignedBox::new(Point3::new(-x, -y, -z), Point3::new(x, y, z));
    let whole = slab(1.0, 0.7, 1.0)?;
    let hit = whole.hit(&ray, Interval::AHEAD);
    let normal = hit.map(|hit| hit.normal.to_glam().to_array());
    Ok(Reply::default()
        .with("direction", flat(ray.direction()))
        .with("x_slab", both_hits(&slab(1.0, FAR, FAR)?, &ray))
        .with("y_slab", both_hits(&slab(FAR, 0.7, FAR)?, &ray))
        .with("z_slab", both_hits(&slab(FAR, FAR, 1.0)?, &ray))
        .with("both", both_hits(&whole, &ray))
        .with("hit", hit.map(|hit| hit.t))
        .with("normal", normal.into_iter().flatten()))
}
