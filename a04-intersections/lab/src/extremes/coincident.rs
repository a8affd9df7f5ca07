//! Coincident surfaces: two shapes in one plane, between which rounding decides.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::Error;
use measure::extremes::greatest;

use crate::support::{Numbers, first};
use a04_intersections::{AxisAlignedBox, Plane};

const EYE: Point3 = Point3::new(1.3, 2.7, 5.1);

/// The greatest difference of the `t` of a floor and of a box whose top lies in it, in `t`.
pub fn greatest_difference(rays: usize) -> Result<f64, Error> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let below = AxisAlignedBox::new(Point3::new(-2.0, -1.0, -2.0), Point3::new(2.0, 0.0, 2.0))?;
    let mut differences = Vec::new();
    for n in 0..rays {
        let mut numbers = Numbers::new(54, n);
        let mut place = || numbers.between(-1.9, 1.9);
        let ray = Ray::new(EYE, Point3::new(place(), 0.0, place()) - EYE)?;
        if let (Some(a), Some(b)) = (first(&floor, &ray), first(&below, &ray)) {
            differences.push((a - b).abs() / a);
        }
    }
    Ok(greatest(differences))
}
