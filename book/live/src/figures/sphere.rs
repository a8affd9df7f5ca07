//! A ray and a sphere: both roots, by our formula, by the protocol's, and with 30 digits.

use a03_rays_cameras::Ray;
use a04_intersections::Sphere;
use a04_lab::exact;
use a04_lab::formula::sphere::{SphereQuery, terms};
use a04_lab::line::Line;
use a04_lab::protocol::{self, Quadratic};
use measure::exact::DoubleDouble;

use super::{Answered, both_hits, direction, flat, place, point};
use crate::Reply;

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

    let query = SphereQuery {
        center: centre.into(),
        radius: 1.0,
        line: Line::of(&ray),
    };
    let Quadratic { a, b, discriminant } = protocol::sphere_equation(&query);
    let root = discriminant.sqrt();
    let theirs = match discriminant {
        0.0.. => vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)],
        _ => Vec::new(),
    };
    let our_terms = terms(&query.from_center(), query.radius, &query.line.direction);

    let hits = exact::sphere(&query);
    let roots = hits.roots.map(|roots| roots.map(DoubleDouble::value));
    let exact = roots.map_or(Vec::new(), Vec::from);
    let beside = hits.distance;
    let exact_discriminant = 4.0 * a * (1.0 - beside) * (1.0 + beside);

    let error = |found: &[f64]| match (found.first(), exact.first()) {
        (Some(found), Some(exact)) => (found - exact).abs(),
        _ => f64::NAN,
    };
    Ok(Reply::default()
        .with("protocol_error", [error(&theirs)])
        .with("our_error", [error(&ours)])
        .with("origin", place(ray.origin()))
        .with("direction", flat(ray.direction()))
        .with("protocol", theirs)
        .with("protocol_discriminant", [discriminant])
        .with("ours", ours)
        .with("our_discriminant", [4.0 * a * our_terms.discriminant])
        .with("exact", exact)
        .with("exact_discriminant", [exact_discriminant]))
}
