//! The footprint of a pixel: how large it is where its objects are.

use a02_math::Point3;
use common::{SceneNumber, Size, Unit};

use crate::{Camera, View, camera_coordinates};

/// The largest angle by which things are rotated for a pixel, in radians.
const MAX_ANGLE: f64 = 1.0 / 64.0;

/// The places beside a pixel at which an object is looked for, in pixels.
const BESIDE: [f64; 3] = [0.0, -0.5, 0.5];

/// Places across the picture at which distances are looked for.
const ACROSS: u32 = 8;

/// By how much colours and factors are moved, of their size, but at least of 1.
const OF_SIZE: f64 = 1.0 / 256.0;
/// A number is moved by at least this fraction of its size, so that rounding does not hide it.
const LEAST: f64 = 1e-9;

/// How large a pixel is where its objects are.
pub struct Footprint {
    /// The camera coordinates of its middle.
    place: (f64, f64),
    /// The distance of its objects, and the point there.
    distance: f64,
    point: Point3,
    /// Its width, in the unit of the scene.
    width: f64,
    /// The angle between the rays of neighbouring pixels, in radians; of parallel rays, the angle
    /// under which its width is seen from the object.
    angle: f64,
    /// The same angle seen from the origin of the world, if it is larger there, for what rotates
    /// objects and lights.
    angle_of_world: f64,
}

impl Footprint {
    /// By how much a number is moved, so that things move by about the width of the pixel.
    #[must_use]
    pub fn step(&self, number: &SceneNumber) -> f64 {
        let size = number.value.abs();
        let angle = if number.table == "[camera]" {
            self.angle
        } else {
            self.angle_of_world
        };
        let step = match number.unit {
            Unit::Length => self.width,
            Unit::Degree => angle.to_degrees(),
            Unit::Direction(length) => angle * length,
            Unit::Scale => angle * size,
            Unit::Factor | Unit::Channel | Unit::Whole => OF_SIZE * size.max(1.0),
        };
        let least = LEAST * size.max(f64::MIN_POSITIVE);
        if step.is_finite() {
            step.max(least)
        } else {
            least
        }
    }

    /// The step of a number of the camera, in units of a little one that leads to another view: a camera
    /// that looks at a point near its eye turns far more than the footprint tells.
    #[must_use]
    pub fn camera_steps(&self, size: Size, moved: &View) -> f64 {
        let ray = moved.camera.ray_for(size, self.place.0, self.place.1);
        let point = ray.at(self.distance).to_glam();
        self.width / (point - self.point.to_glam()).length()
    }
}

impl View {
    /// The footprint of a pixel at the distance of the nearest object in it; without one, of the
    /// pixel in the middle, at the median of the distances of objects.
    #[must_use]
    pub fn footprint(&self, size: Size, pixel: Option<[u32; 2]>) -> Footprint {
        let mut distances = Vec::new();
        let place;
        if let Some([column, row]) = pixel {
            place = camera_coordinates(size, column, row, (0.5, 0.5));
            for dx in BESIDE {
                for dy in BESIDE {
                    distances.extend(self.distance(size, place.0 + dx, place.1 + dy));
                }
            }
            distances.sort_by(f64::total_cmp);
            distances.truncate(1);
        } else {
            let [width, height] = [size.width(), size.height()].map(f64::from);
            place = ((width - 1.0) / 2.0, (height - 1.0) / 2.0);
            for i in 0..ACROSS * ACROSS {
                let [x, y] = [i % ACROSS, i / ACROSS].map(|i| f64::from(2 * i + 1));
                let [x, y] = [x * width, y * height].map(|x| x / f64::from(2 * ACROSS) - 0.5);
                distances.extend(self.distance(size, x, y));
            }
            distances.sort_by(f64::total_cmp);
        }
        let (x, y) = place;
        let rays = [x, x + 1.0].map(|x| self.camera.ray_for(size, x, y));
        let eye = rays[0].origin().to_glam();
        // Where there is no object, at the distance of the world's origin.
        let distance = distances.get(distances.len() / 2).copied();
        let distance = distance.unwrap_or(eye.length()).max(f64::MIN_POSITIVE);
        let points = rays.map(|ray| ray.at(distance));
        let [here, beside] = points.map(Point3::to_glam);
        let width = (beside - here).length();
        let angle = width / distance;
        Footprint {
            place,
            distance,
            point: points[0],
            width,
            angle,
            angle_of_world: (width / here.length()).max(angle).min(MAX_ANGLE),
        }
    }

    /// The distance of the object that is seen at camera coordinates.
    fn distance(&self, size: Size, x: f64, y: f64) -> Option<f64> {
        let ray = self.camera.ray_for(size, x, y);
        let (_, t) = self.world.nearest(&ray)?;
        t.is_finite().then_some(t)
    }
}
