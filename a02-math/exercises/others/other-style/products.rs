//! `dot` and `cross` by loops over the coordinates.

use crate::prelude::*;

pub fn dot(a: Vector3, b: Vector3) -> f64 {
    let mut sum = 0.0;
    for (a, b) in array(a).into_iter().zip(array(b)) {
        sum += a * b;
    }
    sum
}

pub fn cross(a: Vector3, b: Vector3) -> Vector3 {
    let (a, b) = (array(a), array(b));
    let mut product = [0.0; 3];
    for (axis, coordinate) in product.iter_mut().enumerate() {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        *coordinate = a[next] * b[last] - a[last] * b[next];
    }
    vector(product)
}
