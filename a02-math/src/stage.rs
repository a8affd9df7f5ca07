//! `stage`: joins the scene, experiments and extreme cases of this stage for its
//! program.

use common::Scene;
use measure::Stage;

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
        experiments: crate::lab::experiments::experiments,
        extremes: crate::lab::extremes::cases,
        search: None,
        open: None,
    }
}
