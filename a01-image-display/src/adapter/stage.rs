//! `stage`: the scenes of this stage for its program.

use common::{Scene, Stage};

use crate::scenes::{diagonal, painter, show_image};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a01-image-display",
        about: "Pixels, pictures and the window that shows them",
        scenes: vec![
            Scene::painted("diagonal", "a red diagonal on black", |settings, _| {
                diagonal(settings.size)
            }),
            Scene::painted(
                "painter",
                "a red disc before a gradient, from an array of packed pixels",
                |settings, _| painter(settings.size),
            ),
            Scene::opened(
                "show-image",
                "a picture file; the bundled test card where --open names none",
                |settings, _| show_image(settings.file.as_deref()),
            ),
        ],
        open: None,
    }
}
