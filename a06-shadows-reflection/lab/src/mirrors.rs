//! `Mirrors`: two mirrors that face each other.

use a02_math::{Point3, Vector3};
use a04_intersections::Plane;
use common::{ArgumentError, Color, Error};

use a06_shadows_reflection::{Reflective, ShadowedWorld};

pub const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// Two mirrors at equal distances below and above the origin, each of which emits 1.
#[derive(Clone, Copy, Debug)]
pub struct Mirrors {
    /// The distance between them.
    pub gap: f64,
    /// The fraction of light that each of them reflects.
    pub reflectance: f64,
    /// The gray of the background.
    pub background: f64,
}

/// Mirrors 1 apart that reflect half of the light, before a black background.
impl Default for Mirrors {
    fn default() -> Self {
        Self {
            gap: 1.0,
            reflectance: 0.5,
            background: 0.0,
        }
    }
}

impl Mirrors {
    /// The world of both mirrors.
    pub fn world(&self) -> Result<ShadowedWorld, Error> {
        let mut world = ShadowedWorld::empty(Color::gray(self.background), Color::WHITE)?;
        for side in [-0.5, 0.5] {
            let reflectance = Color::gray(self.reflectance);
            let mirror = Reflective::new(Color::WHITE, Color::BLACK, 1.0, reflectance)?;
            world = world.with(level(side * self.gap)?, Box::new(mirror));
        }
        Ok(world)
    }
}

/// The level plane at a height.
pub fn level(y: f64) -> Result<Plane, ArgumentError> {
    Plane::new(Point3::new(0.0, y, 0.0), UP.as_normal())
}
