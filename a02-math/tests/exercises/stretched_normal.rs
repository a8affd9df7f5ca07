//! Normals and stretches of all kinds.

use crate::prelude::*;

yours! { stretched_normal }

pub fn exercise() -> Exercise<fn(Normal3, [f64; 3]) -> Option<Normal3>> {
    Exercise::asked(|stretched_normal, (n, factors)| {
        stretched_normal(vector(n).as_normal(), factors).map(array)
    })
}
