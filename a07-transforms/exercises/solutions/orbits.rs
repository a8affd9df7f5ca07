//! Earth and moon: a scene graph of things that turn around others.

use crate::prelude::*;

/// Where the earth and the moon are; the sun is in the origin. The earth is 5
/// away from the sun, along the x axis turned by `year` radians about the y axis.
///
/// The moon is 1 away from the earth, in a direction that, seen by the turned
/// earth, is the x axis turned by `month` radians about the y axis. The
/// transforms move a body from the origin to its place.
pub fn orbits(year: f64, month: f64) -> Result<[Transform; 2], ArgumentError> {
    let start = Transform::IDENTITY;
    missing!("the transforms of earth and moon", Ok([start, start]), {
        let along_x = |way| Point3::new(way, 0.0, 0.0);
        let earth = start.rotate_y(year)?.translate(along_x(5.0))?;
        // The moon is a child of the earth.
        let moon = earth.rotate_y(month)?.translate(along_x(1.0))?;
        Ok([earth, moon])
    })
}

testing::examples! {
    let places = |year, month| {
        let bodies = orbits(year, month).unwrap();
        bodies.map(|body| (body.matrix() * Point3::ORIGIN).to_glam().to_array())
    };
    let right_angle = std::f64::consts::FRAC_PI_2;
    assert_eq!(places(0.0, 0.0), [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]);
    assert_close(places(0.0, right_angle).concat(), vec![5.0, 0.0, 0.0, 5.0, 0.0, -1.0]);
    assert_close(places(right_angle, 0.0).concat(), vec![0.0, 0.0, -5.0, 0.0, 0.0, -6.0]);
}
