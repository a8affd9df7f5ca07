//! The pictures of the book's errata: the protocol's formula on the left, the
//! right one on the right. Takes the arguments of the stages' programs.

mod cameras;
mod formula;
mod light;
mod mirrors;
mod nodes;
mod shapes;

use common::{Color, Error, Image, Progress, Scene, Settings, Size};
use measure::{Effort, Stage};

#[cfg(not(target_family = "wasm"))]
fn main() -> std::process::ExitCode {
    program::run(&stage(), a01_image_display::viewer())
}

/// The pictures as a stage, so that its program can show and its test lock them.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "errata",
        about: "The protocol's mistakes: the wrong picture beside the right one",
        scenes: vec![
            cameras::tangent(),
            cameras::half_pixel(),
            cameras::stripes(),
            shapes::box_faces(),
            shapes::far_sphere(),
            light::highlight(),
            light::too_far(),
            light::hidden(),
            light::spot(),
            light::acne(),
            mirrors::offset(),
            nodes::order(),
            nodes::normals(),
            nodes::last_wins(),
        ],
        experiments: Vec::new,
        extremes: |_: Effort| Vec::new(),
    }
}

/// Renders the picture of a panel.
type Panel = fn(&Settings, &dyn Progress) -> Result<Image, Error>;

/// Two panels of 360x270: the wrong one, and the right one.
fn beside(name: &'static str, about: &'static str, wrong: Panel, right: Panel) -> Scene {
    let panels = [("wrong", wrong), ("right", right)];
    let panels = panels.map(|(name, panel)| Scene::traced(name, about, panel));
    let pictures = Scene::side_by_side(name, about, panels.into());
    let Ok(size) = Size::new(2 * 360 + Scene::GAP, 270) else {
        return pictures;
    };
    pictures.with_defaults(Settings {
        size,
        ..Settings::default()
    })
}

/// A matt surface in a light from one direction, and a little from everywhere.
fn shade(color: Color, cosine: f64) -> Color {
    color * (0.2 + 0.8 * cosine.max(0.0))
}
