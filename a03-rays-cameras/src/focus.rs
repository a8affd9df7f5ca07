//! `Focus`: what many rays have in common.

use a02_math::{Point3, Vector3};

/// Where the rays of a camera come from, or those to a light go to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Focus {
    /// All of them pass through one point.
    Point(Point3),
    /// All of them are parallel to one direction of length 1.
    Direction(Vector3),
}
