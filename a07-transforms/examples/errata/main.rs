//! The pictures of the book's errata: the protocol's formula on the left, the
//! right one on the right. Takes the arguments of the stages' programs.

mod cameras;
mod formula;
mod light;
mod mirrors;
mod nodes;
mod shapes;

use a03_rays_cameras::{Camera, Ray, View};
use common::{Color, Error, Progress, Scene, Settings};
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

/// A camera, and the colour of each of its rays.
fn traced(camera: impl Camera, color: impl Fn(&Ray) -> Color + Send + Sync + 'static) -> View {
    View::new(camera, color).boxed()
}

/// The view of a panel.
type Panel = Box<dyn Fn(&Settings) -> Result<View, Error> + Send + Sync>;

/// Two panels of 360x270: the wrong view, and the right one.
fn beside<F, G>(name: &'static str, about: &'static str, wrong: F, right: G) -> Scene
where
    F: Fn(&Settings) -> Result<View, Error> + Send + Sync + 'static,
    G: Fn(&Settings) -> Result<View, Error> + Send + Sync + 'static,
{
    let panels: [Panel; 2] = [Box::new(wrong), Box::new(right)];
    let panels = panels.map(|view| {
        move |settings: &Settings, progress: &dyn Progress| {
            view(settings)?.render(settings, progress)
        }
    });
    Scene::side_by_side(name, about, panels, (360, 270))
}

/// A matt surface in a light from one direction, and a little from everywhere.
fn shade(color: Color, cosine: f64) -> Color {
    color * (0.2 + 0.8 * cosine.max(0.0))
}
