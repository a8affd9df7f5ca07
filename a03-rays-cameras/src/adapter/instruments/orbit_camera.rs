//! `OrbitCamera`: a camera, rotated around a point and moved towards it, as a person does in the
//! window.

use a02_math::{Direction, Point3, Vector3};
use common::{Edits, Size};

use crate::registry::kind;
use crate::{Basis, Camera, Ray, View};

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// The steepest gaze to which a person rotates a camera, as an angle from the horizontal: a little less than
/// π / 2.
const STEEPEST: f64 = 1.5;

/// How far a reader has rotated a camera around a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Angle around the vertical axis, in radians.
    pub yaw: f64,
    /// Angle upwards, in radians; limited so that the gaze stays below the vertical.
    pub pitch: f64,
    /// Factor of the distance to the centre.
    pub zoom: f64,
}

impl Orbit {
    /// The camera as the scene has it.
    pub const NONE: Self = Self {
        yaw: 0.0,
        pitch: 0.0,
        zoom: 1.0,
    };
}

/// A camera that is rotated around a centre.
pub struct OrbitCamera {
    camera: Box<dyn Camera>,
    centre: Point3,
    zoom: f64,
    /// The three axes of the scene, rotated.
    axes: [Vector3; 3],
}

impl OrbitCamera {
    /// Rotates a camera. One whose gaze is steeper than a person can rotate it stays where it is.
    pub fn new(camera: Box<dyn Camera>, size: Size, centre: Point3, orbit: Orbit) -> Self {
        let [x, y] = [size.width(), size.height()].map(|side| f64::from(side - 1) / 2.0);
        let gaze = camera.ray_for(size, x, y).direction();
        let elevation = libm::asin(gaze.y().clamp(-1.0, 1.0));
        let steepest = STEEPEST.max(elevation.abs());
        let pitch = (elevation + orbit.pitch).clamp(-steepest, steepest) - elevation;
        let right = gaze.cross(UP).normalized();
        let right = right.unwrap_or(Vector3::new(1.0, 0.0, 0.0));
        let axis = |v| rotated(rotated(v, right, pitch), UP, orbit.yaw);
        let axes = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)];
        Self {
            camera,
            centre,
            zoom: orbit.zoom,
            axes: axes.map(|(x, y, z)| axis(Vector3::new(x, y, z))),
        }
    }

    /// The same camera as one of the type that is rotated, if that type has a row: then scene files
    /// have words for it.
    #[must_use]
    pub fn simplified(self) -> Box<dyn Camera> {
        let Some(kind) = kind(&*self.camera) else {
            return Box::new(self);
        };
        let Basis { e, u, v, w } = kind.basis();
        let [u, v, w] = [u, v, w].map(|axis| self.rotated(axis));
        let e = self.moved(e);
        kind.moved_to(Basis { e, u, v, w }, self.zoom)
    }

    fn rotated(&self, v: Vector3) -> Vector3 {
        let [x, y, z] = self.axes;
        x * v.x() + y * v.y() + z * v.z()
    }

    fn moved(&self, p: Point3) -> Point3 {
        self.centre + self.rotated((p - self.centre) * self.zoom)
    }
}

impl Camera for OrbitCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let ray = self.camera.ray_for(size, x, y);
        Ray::derived(self.moved(ray.origin()), self.rotated(ray.direction()))
    }
}

impl View {
    /// The view for a picture of this size, with the camera where a person has moved it.
    #[must_use]
    pub fn edited(mut self, size: Size, edits: &Edits) -> Self {
        let [yaw, pitch] = edits.orbit;
        let zoom = libm::pow(0.9, f64::from(edits.steps));
        let (middle, orbit) = (self.middle(size), Orbit { yaw, pitch, zoom });
        self.camera = OrbitCamera::new(self.camera, size, middle, orbit).simplified();
        self
    }

    /// The middle of the scene: the point of the gaze that is nearest to the origin, if that
    /// lies ahead; else the point that the gaze hits; else one 3 ahead.
    fn middle(&self, size: Size) -> Point3 {
        let [x, y] = [size.width(), size.height()].map(|side| f64::from(side - 1) / 2.0);
        let gaze = self.camera.ray_for(size, x, y);
        let ahead = (Point3::ORIGIN - gaze.origin()).dot(gaze.direction());
        if ahead > 0.1 {
            return gaze.at(ahead);
        }
        gaze.at(self.world.nearest(&gaze).map_or(3.0, |(_, t)| t))
    }
}

/// The vector `v`, rotated by an angle about an axis of length 1: the formula of
/// Rodrigues, `v cos + (k × v) sin + k (k · v) (1 - cos)`.
fn rotated(v: Vector3, k: Vector3, angle: f64) -> Vector3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
}
