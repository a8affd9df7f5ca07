//! Earth and moon: a scene graph of things that turn around others.

use a02_math::Point3;
use a07_transforms::Transform;
use common::ArgumentError;

/// Where the earth and the moon are; the sun is in the origin. The earth is 5
/// away from the sun, along the x axis turned by `year` radians about the y axis.
///
/// The moon is 1 away from the earth, in a direction that, seen by the turned
/// earth, is the x axis turned by `month` radians about the y axis. The
/// transforms move a body from the origin to its place.
pub fn orbits(year: f64, month: f64) -> Result<[Transform; 2], ArgumentError> {
    let earth = Transform::IDENTITY.translate(Point3::new(5.0, 0.0, 0.0))?;
    testing::missing("the transforms of earth and moon", Ok([earth, earth]))
}
