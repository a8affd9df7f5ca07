//! The footprint of a pixel: how large it is where its objects are.

use common::Size;
use common::sensitivity::Footprint;

use crate::{Camera, View, camera_coordinates};

/// The largest angle by which things are rotated for a pixel, in radians.
const MAX_ANGLE: f64 = 1.0 / 64.0;

/// The places beside a pixel at which an object is looked for, in pixels.
const BESIDE: [f64; 3] = [0.0, -0.5, 0.5];

/// Places across the picture at which distances are looked for.
const ACROSS: u32 = 8;

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
        let [here, beside] = rays.map(|ray| ray.at(distance).to_glam());
        let width = (beside - here).length();
        let angle = width / distance;
        Footprint {
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
