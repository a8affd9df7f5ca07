//! The axes of a description's camera, and vectors of length 1.

use engine::Basis;
use glam::DVec3;

use crate::description::Camera;

/// The axes of a camera with gaze direction `g` and up vector `t`:
/// `w = -g / |g|`, `u = (t × w) / |t × w|`, `v = w × u`.
pub fn basis(camera: &Camera) -> Basis {
    let [eye, gaze, up] = [camera.eye, camera.gaze, camera.up].map(DVec3::from);
    let w = -unit(gaze);
    let u = unit(unit(up).cross(w));
    Basis {
        e: eye,
        u,
        v: w.cross(u),
        w,
    }
}

/// The vector of length 1 in the same direction.
pub fn unit(v: DVec3) -> DVec3 {
    v / v.length_squared().sqrt()
}
