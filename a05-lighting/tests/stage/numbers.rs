//! Random numbers, and shapes made of them.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use common::Color;

/// Random numbers in a row.
pub struct Numbers {
    random: PixelRandom,
    next: u64,
}

impl Numbers {
    pub fn new(seed: u64) -> Self {
        Self {
            random: PixelRandom::new(seed, 0, 0),
            next: 0,
        }
    }

    /// From 0 to 1.
    pub fn number(&mut self) -> f64 {
        self.next += 1;
        self.random.uniform(self.next)
    }

    /// One of `n`.
    pub fn one_of(&mut self, n: u32) -> u32 {
        (self.number() * f64::from(n)) as u32
    }

    pub fn vector(&mut self) -> Vector3 {
        let [x, y, z] = [0; 3].map(|_| 6.0 * self.number() - 3.0);
        Vector3::new(x, y, z)
    }

    pub fn point(&mut self) -> Point3 {
        Point3::ORIGIN + self.vector()
    }

    /// Black in one of four.
    pub fn color(&mut self) -> Color {
        if self.one_of(4) == 0 {
            return Color::BLACK;
        }
        Color::new(self.number(), self.number(), self.number())
    }

    pub fn geometry(&mut self) -> Box<dyn Geometry> {
        let (a, b, c) = (self.point(), self.point(), self.point());
        match self.one_of(4) {
            0 => Box::new(Plane::new(a, self.vector().as_normal()).unwrap()),
            1 => Box::new(Sphere::new(a, 0.2 + self.number()).unwrap()),
            2 => Box::new(AxisAlignedBox::new(a, b).unwrap()),
            _ => Box::new(Triangle::new(a, b, c).unwrap()),
        }
    }
}
