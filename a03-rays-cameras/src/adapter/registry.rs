//! `registry`: one row for each camera of this stage: how it is read from a scene file, and its
//! numbers for the engine. A camera without a row is asked ray by ray.

mod export;
mod for_engine;
mod format;
mod numbered_file;

use std::any::Any;

use a02_math::{Point3, Vector3};
use scene_file::{Error, Item, SceneFile};

pub(crate) use for_engine::camera as camera_for_engine;
pub(crate) use for_engine::{light_at, render};
pub use format::{Format, settings};
pub use numbered_file::NumberedFile;

use crate::{Basis, Camera, OrthographicCamera, PerspectiveCamera};

/// Where a camera stands and how it is held.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// The eye.
    pub e: Point3,
    /// The direction of the gaze.
    pub g: Vector3,
    /// A direction upwards in the picture.
    pub t: Vector3,
}

/// What scene files and the engine need to know of a type of cameras.
pub trait CameraKind: Camera {
    /// Reads a camera of this pose from the table `[camera]`.
    fn read(item: &Item, pose: Pose) -> Result<Self, Error>
    where
        Self: Sized;

    /// Its numbers for the engine.
    fn for_engine(&self) -> engine::Camera<'static>;

    /// Where it stands and how it is held.
    fn basis(&self) -> Basis;

    /// The same camera in another place, from where lengths in the scene look `zoom` times as short.
    fn moved_to(&self, basis: Basis, zoom: f64) -> Box<dyn Camera>;
}

/// Reads a camera of any type.
type Read = fn(&Item, Pose) -> Result<Box<dyn Camera>, Error>;

/// A type of cameras.
struct CameraRow {
    /// The key of the table `[camera]` that chooses this type.
    key: &'static str,
    read: Read,
    get: fn(&dyn Camera) -> Option<&dyn CameraKind>,
}

impl CameraRow {
    const fn of<C: CameraKind>(key: &'static str) -> Self {
        Self {
            key,
            read: |item, pose| Ok(Box::new(C::read(item, pose)?)),
            get: |camera| {
                let camera: &dyn Any = camera;
                camera.downcast_ref::<C>().map(|camera| camera as _)
            },
        }
    }
}

/// The first is the default.
const CAMERAS: &[CameraRow] = &[
    CameraRow::of::<PerspectiveCamera>("angle"),
    CameraRow::of::<OrthographicCamera>("scale"),
];

impl CameraKind for PerspectiveCamera {
    fn read(item: &Item, Pose { e, g, t }: Pose) -> Result<Self, Error> {
        item.check(Self::new(e, g, t, item.angle("angle")?))
    }

    fn for_engine(&self) -> engine::Camera<'static> {
        engine::Camera::Perspective {
            basis: self.basis.into(),
            half_tangent: self.field_of_view.half_tangent,
        }
    }

    fn basis(&self) -> Basis {
        self.basis
    }

    fn moved_to(&self, basis: Basis, _: f64) -> Box<dyn Camera> {
        Box::new(Self { basis, ..*self })
    }
}

impl CameraKind for OrthographicCamera {
    fn read(item: &Item, Pose { e, g, t }: Pose) -> Result<Self, Error> {
        item.check(Self::new(e, g, t, item.number("scale")?))
    }

    fn for_engine(&self) -> engine::Camera<'static> {
        engine::Camera::Orthographic {
            basis: self.basis.into(),
            scale: self.s,
        }
    }

    fn basis(&self) -> Basis {
        self.basis
    }

    fn moved_to(&self, basis: Basis, zoom: f64) -> Box<dyn Camera> {
        let s = self.s * zoom;
        Box::new(Self { basis, s })
    }
}

/// The row of a camera, which may be in boxes.
pub(crate) fn kind(camera: &dyn Camera) -> Option<&dyn CameraKind> {
    let any: &dyn Any = camera;
    match any.downcast_ref::<Box<dyn Camera>>() {
        Some(inner) => kind(&**inner),
        None => CAMERAS.iter().find_map(|row| (row.get)(camera)),
    }
}

/// The camera of a file.
pub fn read_camera(file: &SceneFile) -> Result<Box<dyn Camera>, Error> {
    let item = &file.camera;
    let e = item.vector("eye", Point3::new)?;
    let g = read_gaze(item, e)?;
    let t = item.find_vector("up", Vector3::new);
    let t = t.unwrap_or(Vector3::new(0.0, 1.0, 0.0));
    let mut chosen = CAMERAS.iter().filter(|row| item.find(row.key).is_some());
    let row = chosen.next().unwrap_or(&CAMERAS[0]);
    match chosen.next() {
        Some(other) => {
            let text = format!("a camera has an {} or a {}, not both", row.key, other.key);
            Err(item.error(other.key, text))
        }
        None => (row.read)(item, Pose { e, g, t }),
    }
}

/// The direction of the gaze, which may be given by the point that is looked at.
fn read_gaze(item: &Item, e: Point3) -> Result<Vector3, Error> {
    let Some(point) = item.find_vector("look_at", Point3::new) else {
        return item.vector("gaze", Vector3::new);
    };
    if point == e {
        let text = "camera: look_at is the eye itself, but must be another point";
        return Err(item.error("look_at", text));
    }
    Ok(point - e)
}
