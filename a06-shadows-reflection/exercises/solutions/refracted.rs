//! Refraction: the direction in which a ray goes on in water or glass.

use crate::prelude::*;

/// The direction of length 1 behind a surface with the normal `n`, or none if
/// all light is mirrored. Both `d` and `n` have the length 1; `n` points out,
/// and `d` goes in or out. Outside the refractive index is 1, inside it is
/// `index`. `a.dot(b)` is a dot product.
pub fn refracted(d: Vector3, n: Normal3, index: f64) -> Option<Vector3> {
    missing!("the direction behind the surface", Some(d), {
        let leaves = d.dot(n) > 0.0;
        // The normal on the side that the light comes from.
        let (n, ratio) = if leaves {
            (-n, index)
        } else {
            (n, 1.0 / index)
        };
        let cos = -d.dot(n);
        let cos_squared = 1.0 - ratio * ratio * (1.0 - cos * cos);
        if cos_squared < 0.0 {
            return None;
        }
        Some(d * ratio + n * (ratio * cos - cos_squared.sqrt()))
    })
}

testing::examples! {
    let (up, water) = (Normal3::new(0.0, 1.0, 0.0), 4.0 / 3.0);
    let bent = |x, y| {
        let d = refracted(Vector3::new(x, y, 0.0), up, water)?;
        Some([d.x(), d.y()])
    };
    assert_close!(bent(0.0, -1.0), Some([0.0, -1.0]));
    assert_close!(bent(0.8, -0.6), Some([0.6, -0.8]));
    assert_close!(bent(0.6, 0.8), Some([0.8, 0.6]));
    assert!(bent(0.8, 0.6).is_none(), "none where all light is mirrored");
}
