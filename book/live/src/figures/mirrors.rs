//! The path of a ray between mirrors, bounce by bounce.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Interval, Plane, Sphere, World};
use a06_shadows_reflection::secondary_ray;
use common::Color;

use super::{Answered, direction, place, point};
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
    let mut ray = Ray::new(point(x, y), direction(angle))?;
    let mut path = place(ray.origin()).to_vec();
    let mut shares = Vec::new();
    let mut mirrored = 1.0;
    for _ in 0..depth as u32 {
        let Some((hit, ())) = world.hit(&ray, Interval::AHEAD) else {
            path.extend(place(ray.at(10.0)));
            break;
        };
        path.extend(place(ray.at(hit.t)));
        mirrored *= share;
        shares.push(mirrored);
        let reflected = (-ray.direction()).reflected_on(hit.normal);
        ray = secondary_ray(&ray, &hit, reflected);
    }
    Ok(Answer::default()
        .with("path", path)
        .with("hits", [shares.len() as f64])
        .with("left", [mirrored])
        .with("shares", shares))
}
