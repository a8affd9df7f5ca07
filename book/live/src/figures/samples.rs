//! Samples in a pixel that an edge crosses: their places, the coverage that they
//! estimate, and its error as their number grows.

use a03_rays_cameras::{PixelRandom, Sampler};
use common::Settings;

use crate::{Reply, picture};

/// A straight edge through a pixel: left of it is covered. The pixel is a unit square
/// with its centre at the origin.
#[derive(Clone, Copy)]
struct Edge {
    normal: [f64; 2],
    offset: f64,
}

impl Edge {
    fn new(angle: f64, offset: f64) -> Self {
        Self {
            normal: [libm::cos(angle), libm::sin(angle)],
            offset,
        }
    }

    fn covers(&self, x: f64, y: f64) -> bool {
        (x - 0.5) * self.normal[0] + (y - 0.5) * self.normal[1] < self.offset
    }

    /// The covered area, in closed form: the integral over the square of a step that
    /// moves with x is a difference of squares of ramps.
    fn area(&self) -> f64 {
        let [a, b] = self.normal.map(f64::abs);
        let ramp = |x: f64| x.max(0.0);
        let (small, large) = (a.min(b), a.max(b));
        if small < 1e-9 {
            return (self.offset / large + 0.5).clamp(0.0, 1.0);
        }
        let square = |s: f64| {
            let x = ramp(self.offset + s);
            x * x
        };
        let (sum, difference) = (f64::midpoint(a, b), (large - small) / 2.0);
        let corners = square(sum) - square(difference) - square(-difference) + square(-sum);
        (corners / (2.0 * a * b)).clamp(0.0, 1.0)
    }

    fn estimate(&self, sampler: Sampler, pixel: u32) -> f64 {
        let places = sampler.places(pixel, 0);
        let covered = places.filter(|(x, y)| self.covers(*x, *y)).count();
        covered as f64 / f64::from(sampler.samples())
    }
}

fn sampler(samples: f64, sampling: f64, seed: f64) -> Sampler {
    Sampler::new(&Settings {
        samples: samples as u32,
        sampling: picture::sampling(sampling),
        seed: seed as u64,
        ..Settings::default()
    })
}

/// Numbers: the edge's angle in degrees and its distance from the pixel's centre, the
/// number of samples, the number of their place, and the seed.
pub fn answer([angle, offset, samples, sampling, seed]: [f64; 5]) -> Reply {
    let edge = Edge::new(angle.to_radians(), offset);
    let sampler = sampler(samples, sampling, seed);
    let (x, y): (Vec<_>, Vec<_>) = sampler.places(0, 0).unzip();
    let (area, estimate) = (edge.area(), edge.estimate(sampler, 0));
    Reply::default()
        .with("x", x)
        .with("y", y)
        .with("samples", [sampler.samples().into()])
        .with("estimate", [estimate])
        .with("area", [area])
        .with("error", [(estimate - area).abs()])
}

/// Pixels of each point of the curve.
const PIXELS: u32 = 400;

/// Number: the number of the places. The root mean square error of the coverage over
/// pixels with an edge anywhere, for 1, 4, 16 … 1024 samples.
pub fn errors([sampling]: [f64; 1]) -> Reply {
    let counts = [1.0, 4.0, 16.0, 64.0, 256.0, 1024.0];
    let error = |samples: f64| {
        let sampler = sampler(samples, sampling, 0.0);
        let squares = (0..PIXELS).map(|pixel| {
            let random = PixelRandom::new(1, pixel, 0);
            let angle = random.uniform(0) * std::f64::consts::TAU;
            let edge = Edge::new(angle, random.uniform(1) - 0.5);
            let error = edge.estimate(sampler, pixel) - edge.area();
            error * error
        });
        (squares.sum::<f64>() / f64::from(PIXELS)).sqrt()
    };
    Reply::default()
        .with("counts", counts)
        .with("errors", counts.map(error))
}
