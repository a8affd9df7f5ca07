//! `search`: the worst position of a point light for its direction.

use a02_lab::condition::three;
use a02_lab::exact::DoubleDouble;
use a02_math::arrays::{array, point};
use a03_lab::quantity::{Quantity, unit};
use common::{Color, Error};

use a05_lighting::{Light, PointLight};

/// The direction from a point to a point light.
pub const LIGHT: Quantity = Quantity {
    name: "light",
    written: "PointLight::new(Color::WHITE, Point3::new(#, #, #)).map(|light| light.direction_from(Point3::new(#, #, #)))",
    exact,
    lesson: |x| {
        let light = PointLight::new(Color::WHITE, point([x[0], x[1], x[2]])).ok()?;
        Some(array(light.direction_from(point([x[3], x[4], x[5]]))?))
    },
    // The way over its length, as in the protocol's Lambert.
    protocol: |x| {
        let way = point([x[0], x[1], x[2]]) - point([x[3], x[4], x[5]]);
        Some(array(way * (1.0 / way.magnitude())))
    },
};

fn exact(x: &[DoubleDouble]) -> [DoubleDouble; 3] {
    let (light, at) = (three(x, 0), three(x, 3));
    unit([0, 1, 2].map(|i| light[i] - at[i]))
}

/// The worst input of the protocol's formula and the lesson's, in words and as lines of Rust.
pub fn search(name: &str) -> Result<String, Error> {
    LIGHT.search(name)
}
