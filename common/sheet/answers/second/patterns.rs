//! Patterns without the workbook's sampler: a value of a pattern describes it, rays are at random places of the
//! pixel without strata, and distances on board and ball are measured without a floor function or an angle.

use std::f64::consts::FRAC_PI_2;

use crate::functions::*;
use crate::workbench::*;

/// What a surface shows at two numbers that measure it.
enum Pattern {
    Stripes {
        across: bool,
    },
    /// White where exactly one of two patterns is.
    Either(Box<Pattern>, Box<Pattern>),
    Picture(Image),
}

impl Pattern {
    fn board() -> Self {
        let [across, along] = [true, false].map(|across| Box::new(Self::Stripes { across }));
        Self::Either(across, along)
    }

    fn color(&self, u: f64, v: f64) -> Color {
        match self {
            Self::Stripes { across } => {
                let place = if *across { u } else { v };
                // The place within a pair of stripes.
                let within = place - 2.0 * (place / 2.0).floor();
                white_if(within >= 1.0)
            }
            Self::Either(one, other) => {
                let both = [one, other].map(|pattern| pattern.color(u, v).r > 0.5);
                white_if(both[0] != both[1])
            }
            Self::Picture(picture) => {
                let size = picture.size();
                let index = |place: f64, count: u32| {
                    let number = (place * f64::from(count)) as i64;
                    number.rem_euclid(i64::from(count)) as u32
                };
                let (x, y) = (index(u, size.width()), index(v, size.height()));
                picture.get(x, y).unwrap_or_default()
            }
        }
    }
}

/// What a ray may meet.
enum Body {
    Floor,
    Ball {
        to_measure: fn(f64, f64) -> (f64, f64),
    },
}

struct Scene {
    camera: Box<dyn Camera>,
    size: [u32; 2],
    body: Body,
    pattern: Pattern,
}

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let from_above = |x| -> Result<Scene, Error> {
        Ok(Scene {
            camera: perspective(Point3::new(x, 8.0, 0.0), AHEAD, FRAC_PI_2)?,
            size: [320, 240],
            body: Body::Floor,
            pattern: Pattern::board(),
        })
    };
    let round = |z: f64, to_measure, pattern| -> Result<Scene, Error> {
        Ok(Scene {
            camera: parallel(Point3::new(0.0, 0.0, z), AHEAD * z, 2.4)?,
            size: [241, 241],
            body: Body::Ball { to_measure },
            pattern,
        })
    };
    let fields = |longitude, latitude| (longitude / 36.0, latitude / 36.0);
    let parts =
        |longitude: f64, latitude: f64| ((longitude + 180.0) / 360.0, (90.0 - latitude) / 180.0);
    let of_sheet = |x, y| Color::new(f64::from(x + 1) / 8.0, f64::from(y + 1) / 4.0, 0.0);
    match scene {
        "patterns-floor" => picture(&from_above(0.0)?, samples, false),
        "patterns-far" => picture(&from_above(-3e9)?, samples, false),
        "patterns-count" => picture(&from_above(0.0)?, samples, true),
        "patterns-ball" => picture(&round(5.0, fields, Pattern::board())?, samples, false),
        "patterns-picture" => {
            let image = Image::from_fn(Size::new(8, 4)?, of_sheet)?;
            picture(
                &round(-5.0, parts, Pattern::Picture(image))?,
                samples,
                false,
            )
        }
        _ => panic!("there is no scene {scene}"),
    }
}

fn picture(scene: &Scene, samples: u32, counts: bool) -> Result<Image, Error> {
    let size = size(scene.size)?;
    Image::from_fn(size, |column, row| {
        let random = PixelRandom::new(crate::seed(), column, row);
        // The whole distance along the floor is k² / 960 pixels for a field, k pixels below the horizon.
        let below = f64::from(row) - 119.5;
        let one_is_enough = below > 0.0 && 960.0 / (below * below) > 10.0;
        let rays = if counts && one_is_enough { 1 } else { samples };
        if counts {
            return Color::gray(f64::from(rays) / 64.0);
        }
        let mut sum = Color::BLACK;
        for sample in 0..u64::from(rays) {
            let place = (random.uniform(2 * sample), random.uniform(2 * sample + 1));
            let (x, y) = camera_coordinates(size, column, row, place);
            sum += scene.color(&scene.camera.ray_for(size, x, y));
        }
        sum * (1.0 / f64::from(rays))
    })
}

impl Scene {
    fn color(&self, ray: &Ray) -> Color {
        let (o, d) = (ray.origin(), ray.direction());
        match self.body {
            Body::Floor if d.y() < 0.0 => {
                let p = ray.at(o.y() / -d.y());
                self.pattern.color(p.x(), p.z())
            }
            Body::Ball { to_measure } => {
                let squared = 1.0 - o.x() * o.x() - o.y() * o.y();
                if squared < 0.0 {
                    return Color::new(0.3, 0.5, 0.9);
                }
                let z = squared.sqrt().copysign(o.z());
                let radius = libm::hypot(o.x(), z);
                // Twice the angle whose tangent is the half chord: it has no jump at the front.
                let longitude = 2.0 * libm::atan2(o.x(), radius + z);
                let latitude = libm::atan2(o.y(), radius);
                let (u, v) = to_measure(longitude.to_degrees(), latitude.to_degrees());
                self.pattern.color(u, v)
            }
            Body::Floor => Color::new(0.3, 0.5, 0.9),
        }
    }
}
