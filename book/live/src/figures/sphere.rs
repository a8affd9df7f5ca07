//! A ray and a sphere: both roots, by our formula, by the protocol's, and with 30 digits.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::Sphere;
use a04_lab::exact;
use a04_lab::experiments::sphere_distance::stable_terms;
use a04_lab::protocol;

use super::{Answered, both_hits, direction, flat, place, point};
use crate::Answer;

/// Numbers: a point of the ray near the sphere, the ray's angle, the distance of its
/// origin from that point as a power of ten, in radii, and the centre of the sphere,
/// whose radius is 1.
///
/// All discriminants are in the units of the protocol's, `b² - 4 a c`.
pub fn answer([x, y, angle, power, cx, cy]: [f64; 6]) -> Answered {
    let d = direction(angle);
    let ray = Ray::new(point(x, y) + d * -libm::pow(10.0, power), d)?;
    let centre = point(cx, cy);
    let ours = both_hits(&Sphere::new(centre, 1.0)?, &ray);

    let [c, o] = [centre, ray.origin()].map(|p: Point3| p.to_glam().to_array());
    let d = ray.direction().to_glam().to_array();
    let [a, b, discriminant] = protocol::sphere_terms(&c, 1.0, &o, &d);
    let root = discriminant.sqrt();
    let theirs = match discriminant {
        0.0.. => vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)],
        _ => Vec::new(),
    };
    let f = (ray.origin() - centre).to_glam().to_array();
    let [.., our_discriminant] = stable_terms(&f, 1.0, &d);

    let meeting = exact::sphere(&c, 1.0, &o, &d);
    let roots = meeting
        .roots
        .map(|roots| roots.map(exact::DoubleDouble::value));
    let exact = roots.map_or(Vec::new(), Vec::from);
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
        .with("our_discriminant", [4.0 * a * our_discriminant])
        .with("exact", exact)
        .with("exact_discriminant", [exact_discriminant]))
}
