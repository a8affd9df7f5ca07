//! The condition of a hit's `t`: by how many units in its last place it changes, if each number of
//! ray and shape changes by one unit in its own.

use a02_math::arrays::{array, vector};

use crate::line::Line;
use crate::number::{Triple, dot};

/// The condition at a surface of the normal `n`. If the surface is moved by δs and the ray by δo
/// and δd, the hit moves by `δt = n · (δs - δo - t δd) / (n · d)`. The numbers that move the
/// surface along each axis add up to `surface`.
fn of_surface(n: Triple, surface: Triple, line: &Line, t: f64) -> f64 {
    let Line {
        origin: o,
        direction: d,
    } = line;
    let mut moved = 0.0;
    for axis in 0..3 {
        let by_numbers = surface[axis] + o[axis].abs() + (t * d[axis]).abs();
        moved += n[axis].abs() * by_numbers;
    }
    (moved / (dot(&n, d) * t)).abs()
}

/// The condition at a hit of a sphere, whose radius moves it along the normal.
pub fn of_sphere(center: &Triple, radius: f64, line: &Line, t: f64) -> f64 {
    let (mut n, mut surface) = ([0.0; 3], [0.0; 3]);
    for axis in 0..3 {
        let from_center = line.origin[axis] - center[axis] + t * line.direction[axis];
        n[axis] = from_center / radius;
        surface[axis] = center[axis].abs() + radius * n[axis].abs();
    }
    of_surface(n, surface, line, t)
}

/// The condition at a hit of a triangle, whose corners move it by their weights. Those of b and c
/// are given.
pub fn of_triangle(corners: &[Triple; 3], beta: f64, gamma: f64, line: &Line, t: f64) -> f64 {
    let [a, b, c] = corners.map(vector);
    let n = array((b - a).cross(c - a));
    let mut surface = [0.0; 3];
    for (corner, weight) in corners.iter().zip([1.0 - beta - gamma, beta, gamma]) {
        for axis in 0..3 {
            surface[axis] += (weight * corner[axis]).abs();
        }
    }
    of_surface(n, surface, line, t)
}
