//! Directions of a hemisphere, chosen evenly or by the cosine, and the noise of the light that a white
//! floor reflects from a sky along them.

use std::f64::consts::TAU;

use a03_rays_cameras::PixelRandom;

use crate::Reply;

/// How often a direction is chosen.
#[derive(Clone, Copy)]
enum Density {
    /// 1/2π: each direction as often as every other one.
    Even,
    /// cos θ/π: as often as the floor weighs it.
    Cosine,
}

/// Which directions bring light, of radiance 1.
#[derive(Clone, Copy)]
enum Sky {
    Everywhere,
    Half,
}

impl Sky {
    fn new(number: f64) -> Self {
        if number == 0.0 {
            Self::Everywhere
        } else {
            Self::Half
        }
    }

    fn brings_light(self, x: f64) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Half => x > 0.0,
        }
    }

    /// The light that the floor reflects.
    const fn mean(self) -> f64 {
        match self {
            Self::Everywhere => 1.0,
            Self::Half => 0.5,
        }
    }
}

impl Density {
    /// A random direction, seen from above, and cos θ.
    fn direction(self, random: PixelRandom, n: u64) -> ([f64; 2], f64) {
        let around = TAU * random.uniform(2 * n);
        let share = random.uniform(2 * n + 1);
        // The area of a hemisphere grows evenly with the height, that of a disc with the square of the radius.
        let cosine = match self {
            Self::Even => share,
            Self::Cosine => (1.0 - share).sqrt(),
        };
        let sine = (1.0 - cosine * cosine).sqrt();
        let place = [sine * libm::cos(around), sine * libm::sin(around)];
        (place, cosine)
    }

    /// The weight cos θ/π of a direction over its density.
    fn weight(self, cosine: f64) -> f64 {
        match self {
            Self::Even => 2.0 * cosine,
            Self::Cosine => 1.0,
        }
    }

    /// The variance of a direction's light: ∫ (2 cos θ)² over cos θ from 0 to 1 is 4/3, of which half a sky keeps
    /// half, minus the square of the mean.
    fn variance(self, sky: Sky) -> f64 {
        match (self, sky) {
            (Self::Even, Sky::Everywhere) => 1.0 / 3.0,
            (Self::Even, Sky::Half) => 5.0 / 12.0,
            (Self::Cosine, Sky::Everywhere) => 0.0,
            (Self::Cosine, Sky::Half) => 0.25,
        }
    }

    /// The root mean square error of the mean of this many directions, over all pixels.
    fn noise(self, sky: Sky, samples: u32, seed: u64) -> f64 {
        let squares = (0..PIXELS).map(|pixel| {
            let random = PixelRandom::new(seed, pixel, 0);
            let light = (0..u64::from(samples)).map(|n| {
                let (place, cosine) = self.direction(random, n);
                let brings_light = sky.brings_light(place[0]);
                if brings_light {
                    self.weight(cosine)
                } else {
                    0.0
                }
            });
            let error = light.sum::<f64>() / f64::from(samples) - sky.mean();
            error * error
        });
        (squares.sum::<f64>() / f64::from(PIXELS)).sqrt()
    }
}

/// Pixels of each measured noise, whose own error is then about 1/√(2 · 1000) of it.
const PIXELS: u32 = 1000;

/// Numbers: how many directions, the number of the sky, and the seed. The directions of the first pixel, seen
/// from above, and the noise of all pixels, measured and in closed form.
pub fn answer([samples, sky, seed]: [f64; 3]) -> Reply {
    let (count, sky, seed) = (samples as u32, Sky::new(sky), seed as u64);
    let random = PixelRandom::new(seed, 0, 0);
    let places = |density: Density| {
        let directions = (0..u64::from(count)).map(move |n| density.direction(random, n).0);
        directions.flatten()
    };
    let exact = |density: Density| [(density.variance(sky) / samples).sqrt()];
    Reply::default()
        .with("even", places(Density::Even))
        .with("cosine", places(Density::Cosine))
        .with("even_noise", [Density::Even.noise(sky, count, seed)])
        .with("even_exact", exact(Density::Even))
        .with("cosine_noise", [Density::Cosine.noise(sky, count, seed)])
        .with("cosine_exact", exact(Density::Cosine))
}
