//! The path of a ray between mirrors, bounce by bounce.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Plane, Sphere, World};
use common::Color;

use super::{Answered, direction, path, place, point};
use crate::Answer;

/// Numbers: origin and angle of the ray, the number of surfaces that it may hit, and the
/// share that each mirrors. A wall on the left and one on the right mirror, and a ball
/// of radius 0.6 between them; upwards and downwards the way is open.
pub fn answer([x, y, angle, depth, share]: [f64; 5]) -> Answered {
    let wall = |x: f64| Plane::new(point(x, 0.0), Normal3::new(1.0, 0.0, 0.0));
    let world = World::new(Color::BLACK)?
        .with(wall(-2.0)?, ())
        .with(wall(2.0)?, ())
        .with(Sphere::new(Point3::ORIGIN, 0.6)?, ());
    let ray = Ray::new(point(x, y), direction(angle))?;
    let (path, hits) = path(&world, ray, depth as u32, |()| true);
    let product = |left: &mut f64, _| {
        *left *= share;
        Some(*left)
    };
    let shares: Vec<_> = (0..hits).scan(1.0, product).collect();
    Ok(Answer::default()
        .with("path", path.into_iter().flat_map(place))
        .with("hits", [hits as f64])
        .with("left", [shares.last().copied().unwrap_or(1.0)])
        .with("shares", shares))
}
