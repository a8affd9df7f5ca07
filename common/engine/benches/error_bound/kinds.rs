//! `Kind`: a kind of picture, as a function from places to light, with variants by number.

use common::Color;
use engine::Ray;

use crate::random::PixelRandom;

/// The light at a place: `x` from 0 to 1 over the width of the picture, `y` upwards from 0
/// to its height, 0.75.
pub type Light = Box<dyn Fn(f64, f64) -> Color + Sync>;

/// A kind of picture.
pub struct Kind {
    pub name: &'static str,
    /// Makes the variant that the numbers select.
    pub make: fn(Numbers) -> Light,
}

/// The width of a pixel where 160 lie side by side.
pub const PIXEL: f64 = 1.0 / 160.0;

/// Random numbers, one after the other.
pub struct Numbers(PixelRandom, u64);

impl Numbers {
    /// The numbers of a variant of a kind.
    pub fn new(kind: &str, variant: u32) -> Self {
        let kind = kind
            .bytes()
            .fold(0_u64, |sum, byte| sum.wrapping_mul(31) + u64::from(byte));
        Self(PixelRandom::new(kind, variant, 0), 0)
    }

    /// A number between two others.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        self.1 += 1;
        least + (most - least) * self.0.uniform(self.1)
    }

    /// A place in the picture.
    pub fn place(&mut self) -> (f64, f64) {
        (self.between(0.0, 1.0), self.between(0.0, 0.75))
    }

    /// Sine and cosine of any angle.
    pub fn turn(&mut self) -> (f64, f64) {
        let angle = self.between(0.0, std::f64::consts::TAU);
        (libm::sin(angle), libm::cos(angle))
    }

    /// A colour.
    pub fn color(&mut self) -> Color {
        let [r, g, b] = [(); 3].map(|()| self.between(0.05, 1.0));
        Color::new(r, g, b)
    }

    /// A number of things, from `least` to `most`.
    pub fn list<T>(&mut self, least: f64, most: f64, make: impl Fn(&mut Self) -> T) -> Vec<T> {
        let count = self.between(least, most + 1.0) as u32;
        (0..count).map(|_| make(self)).collect()
    }
}

/// The brightness of a shiny ball around 0 with the radius 1; none beside it.
pub fn ball(x: f64, y: f64) -> Option<f64> {
    let squared = x * x + y * y;
    (squared < 1.0).then(|| {
        let lit = (0.5 * x + 0.6 * y + 0.62 * (1.0 - squared).sqrt()).max(0.0);
        0.1 + 0.8 * lit + libm::pow(lit, 60.0)
    })
}

/// The ray through a place from an eye at (0, 1.2, 4) that looks slightly downwards.
pub fn ray(x: f64, y: f64) -> Ray {
    let direction = glam::DVec3::new(x - 0.5, y - 0.5, -1.1);
    Ray {
        origin: glam::DVec3::new(0.0, 1.2, 4.0),
        direction: direction.normalize(),
    }
}
