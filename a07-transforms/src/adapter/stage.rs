//! `stage`: the scenes of this stage for its program.

use a03_rays_cameras::{View, traced_scene};
use a06_shadows_reflection::{ShadowedWorld, traced_with};
use common::Stage;

use crate::registry;
use crate::scenes::{box_transformations, disc, sphere_transformation};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let new = traced_scene;
    let ellipsoid = "a sphere, stretched to an ellipsoid";
    let turned = "a box, stretched and turned three times";
    let scenes = vec![
        new("sphere-transformation", ellipsoid, |_| {
            sphere_transformation().map(traced)
        }),
        new("box-transformations", turned, |_| {
            box_transformations().map(traced)
        }),
        new("disc", "a disc on a mirroring plane", |_| {
            disc().map(traced)
        })
        .reflecting(),
    ];
    Stage {
        name: "a07-transforms",
        about: "Transformed geometry, the scene graph and the disc",
        scenes,
        open: Some(|path| registry::FORMAT.open(path)),
    }
}

/// A view for the renderers, whose world may have nodes and discs.
#[must_use]
pub fn traced(view: View<ShadowedWorld>) -> View {
    traced_with(view, registry::ALL_SHAPES)
}
