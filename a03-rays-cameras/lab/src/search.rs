//! `search`: the worst gaze and up vector for the axes of a camera.

use a02_lab::condition::{cross, three};
use a02_lab::exact::DoubleDouble;
use a02_math::arrays::{array, vector};
use a02_math::{Point3, Vector3};
use common::Error;

use crate::protocol;
use crate::quantity::{Quantity, unit};
use a03_rays_cameras::Basis;

/// The axis u, which lies across gaze and up vector.
pub const CAMERA: Quantity = Quantity {
    name: "camera",
    written: "Basis::new(Point3::ORIGIN, Vector3::new(#, #, #), Vector3::new(#, #, #)).map(|basis| basis.u)",
    exact,
    lesson: |x| {
        let [gaze, up] = vectors(x);
        let basis = Basis::new(Point3::ORIGIN, gaze, up).ok()?;
        Some(array(basis.u))
    },
    protocol: |x| {
        let [gaze, up] = vectors(x);
        let [u, _, _] = protocol::axes(gaze, up);
        Some(array(u))
    },
};

fn vectors(x: &[f64]) -> [Vector3; 2] {
    [vector([x[0], x[1], x[2]]), vector([x[3], x[4], x[5]])]
}

fn exact(x: &[DoubleDouble]) -> [DoubleDouble; 3] {
    unit(cross(unit(three(x, 0)), unit(three(x, 3))))
}

/// The worst input of the protocol's formula and the lesson's, in words and as lines of Rust.
pub fn search(name: &str) -> Result<String, Error> {
    CAMERA.search(name)
}
