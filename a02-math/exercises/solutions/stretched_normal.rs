//! The normal of a surface that is stretched.

use crate::prelude::*;

/// The normal of length 1 of a surface whose normal was `n` before all its
/// points were stretched by these factors along x, y and z. None if a factor
/// is 0, and for the zero normal.
///
/// A normal has `n.x()`, `n.y()` and `n.z()`; `n.normalized()` is `None` if it has no direction.
pub fn stretched_normal(n: Normal3, factors: [f64; 3]) -> Option<Normal3> {
    missing!("the normal after the stretch", Some(n), {
        let [x, y, z] = factors;
        // Twice as wide is half as steep. Nothing that is divided by 0 is finite, and
        // so there is no direction then.
        Normal3::new(n.x() / x, n.y() / y, n.z() / z).normalized()
    })
}

testing::examples! {
    let stretched = |factors| {
        let n = stretched_normal(Normal3::new(0.6, 0.8, 0.0), factors);
        n.map(array)
    };
    assert_close!(stretched([5.0; 3]), Some([0.6, 0.8, 0.0]));
    assert_close!(stretched([0.75, 4.0 / 3.0, 9.0]), Some([0.8, 0.6, 0.0]));
    assert_close!(stretched([-1.0, 1.0, 1.0]), Some([-0.6, 0.8, 0.0]));
    assert!(stretched([1.0, 0.0, 1.0]).is_none(), "none where all is flat");
}
