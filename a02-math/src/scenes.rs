//! The pictures of this stage.

use common::Stage;

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a02-math",
        about: "",
        scenes: vec![],
    }
}
