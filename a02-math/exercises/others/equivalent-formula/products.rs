//! `dot` as a row times a column, and `cross` by the units of the axes: i j = k, j k = i, k i = j.

use crate::prelude::*;

pub fn dot(a: Vector3, b: Vector3) -> f64 {
    let [row, column] = [a, b].map(array);
    (0..3).map(|k| row[k] * column[k]).sum()
}

pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    let i = Vector3::new(1.0, 0.0, 0.0);
    let j = Vector3::new(0.0, 1.0, 0.0);
    let k = Vector3::new(0.0, 0.0, 1.0);
    k * (a.x() * b.y())
        + j * -(a.x() * b.z())
        + k * -(a.y() * b.x())
        + i * (a.y() * b.z())
        + j * (a.z() * b.x())
        + i * -(a.z() * b.y())
}
