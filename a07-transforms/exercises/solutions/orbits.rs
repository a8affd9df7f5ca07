//! Earth and moon: a scene graph of things that turn around others.

use crate::prelude::*;

/// The transforms that move earth and moon from the origin, where the sun is, to their
/// places: the earth by 5 along the x axis, turned by `year` radians about the y axis; the
/// moon from there by 1 along the x axis of the turned earth, turned by `month` radians.
///
/// `transform.rotate_y(angle)?` and `transform.translate(Point3::new(x, y, z))?` chain a step to a transform.
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
        bodies.map(|body| array(body.matrix() * Point3::ORIGIN))
    };
    assert_close!(places(0.0, 0.0), [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0]]);
    assert_close!(places(0.0, FRAC_PI_2).concat(), vec![5.0, 0.0, 0.0, 5.0, 0.0, -1.0]);
    assert_close!(places(FRAC_PI_2, 0.0).concat(), vec![0.0, 0.0, -5.0, 0.0, 0.0, -6.0]);
}
