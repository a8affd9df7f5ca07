//! A ray and a sphere: both roots, by our formula, by the protocol's, and with 30 digits.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::Sphere;
use a04_intersections::lab::exact;
use a04_intersections::protocol;

use super::{Answered, both_hits, direction, flat, place};
use crate::Answer;

/// Numbers: a point of the ray near the sphere, the ray's angle, and the distance of its
/// origin from that point as a power of ten, in radii. The sphere has radius 1 and its
/// centre at the origin.
pub fn answer([x, y, angle, power]: [f64; 4]) -> Answered {
    let d = direction(angle);
    let o = super::point(x, y) + d * -libm::pow(10.0, power);
    let ray = Ray::new(o, d)?;
    let ours = both_hits(&Sphere::new(Point3::ORIGIN, 1.0)?, &ray);

    let (c, o, d) = ([0.0; 3], array(&ray).0, array(&ray).1);
    let [a, b, discriminant] = protocol::sphere_terms(&c, 1.0, &o, &d);
    let root = discriminant.sqrt();
    let theirs = match discriminant {
        0.0.. => vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)],
        _ => Vec::new(),
    };
    let meeting = exact::sphere(&c, 1.0, &o, &d);
    let roots = meeting
        .roots
        .map(|roots| roots.map(exact::DoubleDouble::value));
    let exact = roots.map_or(Vec::new(), Vec::from);
    // In units of the protocol's discriminant, (2 a)^2 of half the chord squared.
    let beside = meeting.distance;
    let exact_discriminant = 4.0 * a * (1.0 - beside) * (1.0 + beside);

    let error = |found: &[f64]| match (found.first(), exact.first()) {
        (Some(found), Some(exact)) => (found - exact).abs(),
        _ => f64::NAN,
    };
    Ok(Answer::default()
        .with("protocol_error", [error(&theirs)])
        .with("our_error", [error(&ours)])
        .with("origin", place(ray.origin()))
        .with("direction", flat(ray.direction()))
        .with("protocol", theirs)
        .with("protocol_discriminant", [discriminant])
        .with("ours", ours)
        .with("exact", exact)
        .with("exact_discriminant", [exact_discriminant]))
}

fn array(ray: &Ray) -> ([f64; 3], [f64; 3]) {
    let (o, d) = (ray.origin(), ray.direction());
    (o.to_glam().to_array(), d.to_glam().to_array())
}
