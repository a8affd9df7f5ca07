//! Whether a plane separates a sphere from all rays of a pixel.
//!
//! The bounds of a sphere are a box, which reaches into pixels that the sphere does not. If the
//! sphere lies on one side of a plane, and if the rays through the corners of a pixel start on the
//! other side and do not come closer, then all rays between them stay there, too. (Separating
//! planes: Ericson, Real-Time Collision Detection, 2005, section 5.2.1.)

use glam::DVec3;

use crate::Ray;
use crate::shape::Sphere;
use crate::vector::normalized;

/// By these parts of the radius and of the distance, spheres are taken to be larger than they are:
/// by more than a hit is rounded.
const WIDER: f64 = 1e-6;
const FARTHER: f64 = 1e-9;

/// Upper bound of the product of two unit vectors that are perpendicular but for rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Whether a plane separates the sphere from the rays between those through the corners of a
/// pixel. False if none of two likely planes does.
pub(super) fn is_separated(sphere: &Sphere, corners: &[Ray; 4]) -> bool {
    planes(sphere, corners).is_some_and(|planes| {
        planes.into_iter().any(|(normal, radius)| {
            corners.iter().all(|ray| {
                let distance = (sphere.center - ray.origin).dot(normal);
                distance >= radius && ray.direction.dot(normal) <= ROUNDING
            })
        })
    })
}

/// The normals of two planes, which point to the sphere, and the distance that they need to have
/// from its centre; none if the middle of the pixel shows the sphere.
///
/// Where all rays start in the eye, the plane through the eye that touches the sphere on the side
/// of the pixel is the best; where rays are parallel, a plane along them.
fn planes(sphere: &Sphere, corners: &[Ray; 4]) -> Option<[(DVec3, f64); 2]> {
    let [mut origin, mut direction] = [DVec3::ZERO; 2];
    for ray in corners {
        origin += ray.origin / 4.0;
        direction += ray.direction;
    }
    let direction = normalized(direction)?;
    let to_center = sphere.center - origin;
    let distance = to_center.length();
    let radius = sphere.radius * (1.0 + WIDER) + distance * FARTHER;
    let along = normalized(to_center)?;
    let away = normalized(to_center - direction * to_center.dot(direction))?;
    let across = normalized(away - along * away.dot(along))?;
    // A little more than needed, because the plane touches the larger sphere.
    let sine = radius * (1.0 + WIDER) / distance;
    let touching = along * sine + across * (1.0 - sine * sine).sqrt();
    (sine < 1.0).then_some([(touching, radius), (away, radius)])
}
