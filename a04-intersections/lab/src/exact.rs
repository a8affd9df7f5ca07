//! Intersections of rays and shapes with about 30 digits, for the given doubles:
//! the reference for formulas in double precision.
//!
//! The formulas are those of [`formula`](crate::formula), in numbers with twice the digits. The
//! tests compare them with values of mpmath at 200 digits.

use measure::exact::DoubleDouble;

use crate::formula::sphere::{self, SphereQuery};
use crate::formula::triangle::{self, PlaneHit};
use crate::line::Line;
use crate::number::Triple;

/// The intersection of a ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereHits {
    /// Distance of the ray from the centre.
    pub distance: f64,
    /// Both roots, in order, if the ray hits the sphere.
    pub roots: Option<[DoubleDouble; 2]>,
}

/// The intersection of the line and the sphere of a query.
pub fn sphere(query: &SphereQuery) -> SphereHits {
    let query = query.to::<DoubleDouble>();
    let terms = sphere::terms(&query.from_center(), query.radius, &query.line.direction);
    let is_hit = terms.discriminant.value() >= 0.0;
    SphereHits {
        distance: terms.beside.sqrt().value(),
        roots: is_hit.then(|| terms.plain_roots()),
    }
}

/// Where a line meets the plane of a triangle.
pub fn triangle(corners: &[Triple; 3], line: &Line) -> PlaneHit<DoubleDouble> {
    let corners = corners.map(|corner| corner.map(DoubleDouble::from));
    triangle::moeller_trumbore(&corners, &line.to())
}
