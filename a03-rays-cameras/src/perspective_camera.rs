//! `PerspectiveCamera`: all rays start in the eye, so that what is far is small.

use a02_math::{Lanes, Point3, Vector3};
use common::{ArgumentError, Size};

use crate::camera::Opening;
use crate::{Basis, Camera, Focus, Ray};

/// A camera whose rays start in one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerspectiveCamera {
    basis: Basis,
    opening: Opening,
}

impl PerspectiveCamera {
    /// A camera at `e` looking along `g` with `t` upwards, whose picture is
    /// seen under the full vertical opening `angle`, in radians: above 0 and
    /// below π.
    pub fn new(e: Point3, g: Vector3, t: Vector3, angle: f64) -> Result<Self, ArgumentError> {
        Ok(Self {
            basis: Basis::new(e, g, t)?,
            opening: Opening::new(angle)?,
        })
    }

    /// Where the camera stands and how it is held.
    #[must_use]
    pub const fn basis(&self) -> Basis {
        self.basis
    }
}

/// From `e` in the direction
/// `r = -w (h/2) / tan(angle/2) + (x - (w-1)/2) u + (y - (h-1)/2) v`.
impl Camera for PerspectiveCamera {
    // ANCHOR: ray
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let direction = self.basis.direction(
            x - (width - 1.0) / 2.0,
            y - (height - 1.0) / 2.0,
            self.opening.distance(height),
        );
        Ray::derived(self.basis.e, direction)
    }
    // ANCHOR_END: ray

    fn rays_for(&self, size: Size, places: &[(f64, f64)], rays: &mut Vec<Ray>) {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let [half_width, half_height] =
            [width, height].map(|side| Lanes::splat((side - 1.0) / 2.0));
        let z = self.opening.distance(height);
        let mut fours = places.chunks_exact(4);
        for four in fours.by_ref() {
            let [x, y] = [
                Lanes::new([four[0].0, four[1].0, four[2].0, four[3].0]),
                Lanes::new([four[0].1, four[1].1, four[2].1, four[3].1]),
            ];
            let directions = self.basis.directions(x - half_width, y - half_height, z);
            if let Some(directions) = directions {
                let directions = directions.to_lanes().map(Vector3::from_glam);
                rays.extend(directions.map(|direction| Ray::derived(self.basis.e, direction)));
            } else {
                rays.extend(four.iter().map(|(x, y)| self.ray_for(size, *x, *y)));
            }
        }
        let rest = fours.remainder().iter();
        rays.extend(rest.map(|(x, y)| self.ray_for(size, *x, *y)));
    }

    fn focus(&self) -> Option<Focus> {
        Some(Focus::Point(self.basis.e))
    }
}
