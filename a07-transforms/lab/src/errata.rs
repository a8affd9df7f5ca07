//! The pictures of the book's errata: the protocol's formula on the left, the
//! right one on the right.

mod cameras;
mod light;
mod shapes;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, Ray, View};
use common::{ArgumentError, Color, Error, Progress, Scene, Settings, Stage};

use crate::side_by_side::side_by_side;

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
            light::mirrors(),
            shapes::order(),
            shapes::normals(),
            shapes::last_wins(),
        ],
        open: None,
    }
}

/// The view of a panel.
type Panel = fn(&Settings) -> Result<View, Error>;

/// Two panels of 360x270: the wrong view, and the right one.
fn beside(name: &'static str, about: &'static str, wrong: Panel, right: Panel) -> Scene {
    let panels = [wrong, right].map(|view| {
        move |settings: &Settings, progress: &dyn Progress| {
            view(settings)?.render(settings, progress)
        }
    });
    side_by_side(name, about, panels, (360, 270))
}

type Made<T> = Result<T, ArgumentError>;

/// A camera that looks to a point.
fn camera(eye: Point3, to: Point3, angle: f64) -> Made<PerspectiveCamera> {
    PerspectiveCamera::new(eye, to - eye, Vector3::new(0.0, 1.0, 0.0), angle)
}

/// A camera, and the colour of each of its rays.
fn traced(camera: impl Camera, color: impl Fn(&Ray) -> Color + Send + Sync + 'static) -> View {
    View::new(camera, color).boxed()
}

/// A matt surface in a light from one direction, and a little from everywhere.
fn shade(color: Color, cosine: f64) -> Color {
    color * (0.2 + 0.8 * cosine.max(0.0))
}
