//! `stage`: the scene of this stage for its program.

use common::{Scene, Stage};

use crate::scenes::vectors;

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a02-math",
        about: "Vectors, points, normals and matrices",
        scenes: vec![Scene::painted(
            "vectors",
            "sum, cross product, projection and reflection of vectors",
            |settings, _| vectors(settings.size),
        )],
        open: None,
    }
}
