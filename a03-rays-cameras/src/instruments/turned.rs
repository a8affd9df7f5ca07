//! `Turned`: a camera, turned around a point and moved towards it.

use a02_math::{Direction, Point3, Vector3};
use common::steps::{self, HIT, Step, TEST};
use common::{Error, Settings, Size};

use crate::{Camera, Ray, TracedWorld, View};

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// The steepest gaze, as an angle from the horizontal: a little less than π / 2.
const STEEPEST: f64 = 1.5;

/// How far a reader has turned a camera; nothing by default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Angle around the vertical axis, in radians.
    pub yaw: f64,
    /// Angle upwards, in radians; limited so that the gaze stays below the vertical.
    pub pitch: f64,
    /// Factor of the distance to the centre.
    pub zoom: f64,
}

impl Turn {
    /// The camera as the scene has it.
    pub const NONE: Self = Self {
        yaw: 0.0,
        pitch: 0.0,
        zoom: 1.0,
    };
}

/// A camera that is turned around a centre.
pub struct Turned {
    camera: Box<dyn Camera>,
    centre: Point3,
    zoom: f64,
    /// The three axes of the scene, rotated.
    axes: [Vector3; 3],
}

impl Turned {
    /// Turns a camera whose gaze is not vertical.
    pub fn new(camera: Box<dyn Camera>, size: Size, centre: Point3, mut turn: Turn) -> Self {
        let [x, y] = [size.width(), size.height()].map(|side| f64::from(side - 1) / 2.0);
        let gaze = camera.ray_for(size, x, y).direction();
        let elevation = libm::asin(gaze.y().clamp(-1.0, 1.0));
        turn.pitch = (elevation + turn.pitch).clamp(-STEEPEST, STEEPEST) - elevation;
        let right = gaze.cross(UP).normalized();
        let right = right.unwrap_or(Vector3::new(1.0, 0.0, 0.0));
        let turned = |v| rotated(rotated(v, right, turn.pitch), UP, turn.yaw);
        let axes = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)];
        Self {
            camera,
            centre,
            zoom: turn.zoom,
            axes: axes.map(|(x, y, z)| turned(Vector3::new(x, y, z))),
        }
    }

    fn turned(&self, v: Vector3) -> Vector3 {
        let [x, y, z] = self.axes;
        x * v.x() + y * v.y() + z * v.z()
    }
}

impl Camera for Turned {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let ray = self.camera.ray_for(size, x, y);
        let from_centre = (ray.origin() - self.centre) * self.zoom;
        let origin = self.centre + self.turned(from_centre);
        Ray::derived(origin, self.turned(ray.direction()))
    }
}

impl View {
    /// The view, made by a function of the size, with the moves of its lights and its camera in
    /// these settings.
    pub fn moved(
        mut self,
        settings: &Settings,
        make: impl Fn(Size) -> Result<Self, Error>,
    ) -> Result<Self, Error> {
        let (size, moves) = (settings.size, &settings.moves);
        for (place, way) in self.world.light_places().into_iter().zip(&moves.lights) {
            *place = *place + Vector3::from_glam((*way).into());
        }
        if moves.turn != [0.0; 2] {
            let middle = middle(&make(size)?.watched(settings, false), size);
            let [yaw, pitch] = moves.turn;
            let turn = Turn {
                yaw,
                pitch,
                ..Turn::NONE
            };
            self.camera = Box::new(Turned::new(self.camera, size, middle, turn));
        }
        Ok(self)
    }
}

/// The middle of the scene of a watched view: the point of the gaze that is nearest to the
/// origin, if that lies ahead; else the point that the gaze hits; else one 3 ahead.
pub fn middle(view: &View, size: Size) -> Point3 {
    let [x, y] = [size.width(), size.height()].map(|side| f64::from(side - 1) / 2.0);
    let gaze = view.camera.ray_for(size, x, y);
    let ahead = (Point3::ORIGIN - gaze.origin()).dot(gaze.direction());
    if ahead > 0.1 {
        return gaze.at(ahead);
    }
    gaze.at(nearest(&*view.world, &gaze).map_or(3.0, |(_, t)| t))
}

/// The name of the nearest object along a ray in a watched world, and its distance.
pub fn nearest(world: &dyn TracedWorld, ray: &Ray) -> Option<(String, f64)> {
    let (_, steps) = steps::recorded(|| world.radiance(ray, 1));
    let is_hit = |step: &Step| step.level == 0 && step.kind == TEST && step.outcome == HIT;
    let hit = steps.into_iter().find(is_hit)?;
    let [t] = hit.value("t")?;
    Some((hit.name, t))
}

/// The vector `v`, rotated by an angle about an axis of length 1: the formula of
/// Rodrigues, `v cos + (k × v) sin + k (k · v) (1 - cos)`.
fn rotated(v: Vector3, k: Vector3, angle: f64) -> Vector3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    use crate::PerspectiveCamera;

    use super::*;

    /// A camera at (0, 0, 4) that looks at the origin, turned: a quarter turn looks from the
    /// side, half the zoom from half as far, and the gaze stays below the vertical.
    #[test]
    fn a_camera_turns_around_the_centre() {
        let gaze = |yaw, pitch, zoom| {
            let (e, g) = (Point3::new(0.0, 0.0, 4.0), Vector3::new(0.0, 0.0, -1.0));
            let camera = PerspectiveCamera::new(e, g, UP, FRAC_PI_4).unwrap();
            let (size, turn) = (Size::new(3, 3).unwrap(), Turn { yaw, pitch, zoom });
            Turned::new(Box::new(camera), size, Point3::ORIGIN, turn).ray_for(size, 1.0, 1.0)
        };
        let ray = gaze(FRAC_PI_2, 0.0, 0.5);
        let far = |v: Vector3, x| (v - Vector3::new(x, 0.0, 0.0)).magnitude();
        assert!(far(ray.origin() - Point3::ORIGIN, 2.0) < 1e-15);
        assert!(far(ray.direction(), -1.0) < 1e-15);
        for pitch in [2.0, -2.0] {
            let y = gaze(0.0, pitch, 1.0).direction().y();
            assert!((y - libm::sin(STEEPEST.copysign(pitch))).abs() < 1e-15);
        }
    }
}
