//! Light that has been everywhere: a path from surface to surface, and a weight that it carries along.

use crate::functions::*;

/// A surface that glows, and reflects the same to all sides.
struct Matter {
    glow: f64,
    reflectance: f64,
}

struct Scene {
    objects: World<Matter>,
    sky: fn(Vector3) -> f64,
    camera: Box<dyn Camera>,
    size: Size,
    paths: u32,
    ends: Ends,
    /// Values are divided by this.
    factor: f64,
    /// The picture shows the surfaces that a path has met.
    counts: bool,
}

/// How a path ends that does not leave the scene.
enum Ends {
    Depth(u32),
    /// At each surface, which reflects it only with the probability of its reflectance.
    Roulette,
}

/// The random numbers of a pixel, one after the other.
struct Dice {
    random: PixelRandom,
    next: u64,
}

impl Dice {
    fn roll(&mut self) -> f64 {
        self.next += 1;
        self.random.uniform(self.next - 1)
    }
}

/// A random direction on the side of `n`: as often as the cosine of its angle says.
fn by_the_cosine(n: Normal3, dice: &mut Dice) -> Vector3 {
    let n = Vector3::from(n);
    // Any axis that is not parallel to n makes two perpendicular ones.
    let axis = if n.x().abs() < 0.6 {
        Vector3::new(1.0, 0.0, 0.0)
    } else {
        Vector3::new(0.0, 1.0, 0.0)
    };
    let a = n.cross(axis).normalized().unwrap_or(axis);
    let b = n.cross(a);
    let (u, angle) = (dice.roll(), TAU * dice.roll());
    let (r, height) = (u.sqrt(), (1.0 - u).sqrt());
    a * (r * libm::cos(angle)) + b * (r * libm::sin(angle)) + n * height
}

impl Scene {
    /// The light that comes back along the ray, and the number of surfaces that it has met.
    fn path(&self, mut ray: Ray, dice: &mut Dice) -> [f64; 2] {
        let (mut light, mut weight, mut met) = (0.0, 1.0, 0);
        while let Some((hit, matter)) = self.objects.hit(&ray, Interval::AHEAD) {
            light += weight * matter.glow;
            met += 1;
            match self.ends {
                Ends::Depth(depth) if met == depth => return [light, f64::from(met)],
                Ends::Depth(_) => weight *= matter.reflectance,
                Ends::Roulette if dice.roll() < matter.reflectance => {}
                Ends::Roulette => return [light, f64::from(met)],
            }
            let direction = by_the_cosine(hit.geometric_normal, dice);
            ray = secondary_ray(&ray, &hit, direction);
        }
        [light + weight * (self.sky)(ray.direction()), f64::from(met)]
    }

    fn draw(&self) -> Result<Image, Error> {
        let size = self.size;
        Image::from_fn(size, |column, row| {
            let random = PixelRandom::new(crate::seed(), column, row);
            let mut dice = Dice { random, next: 0 };
            let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
            let ray = self.camera.ray_for(size, x, y);
            let mut sum = 0.0;
            for _ in 0..self.paths {
                let [light, met] = self.path(ray, &mut dice);
                sum += if self.counts { met } else { light };
            }
            Color::gray(sum / f64::from(self.paths) / self.factor)
        })
    }
}

pub fn render(name: &str, samples: u32) -> Result<Image, Error> {
    let up = Vector3::new(0.0, 1.0, 0.0);
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    let sphere = Sphere::new(Point3::ORIGIN, 1.0)?;
    let floor = Plane::new(Point3::ORIGIN, up.as_normal())?;
    let nothing = || World::new(Color::BLACK);
    let furnace = |reflectance, ends, factor, columns, rows| -> Result<Scene, Error> {
        Ok(Scene {
            objects: nothing()?.with(
                sphere,
                Matter {
                    glow: 1.0,
                    reflectance,
                },
            ),
            sky: |_| 0.0,
            camera: Box::new(PerspectiveCamera::new(
                Point3::ORIGIN,
                ahead,
                up,
                FRAC_PI_2,
            )?),
            size: Size::new(columns, rows)?,
            paths: if matches!(ends, Ends::Roulette) {
                samples
            } else {
                1
            },
            ends,
            factor,
            counts: name == "light-steps",
        })
    };
    let outside =
        |geometry: Box<dyn Geometry>, reflectance, sky, camera, pixels| -> Result<Scene, Error> {
            Ok(Scene {
                objects: nothing()?.with(
                    geometry,
                    Matter {
                        glow: 0.0,
                        reflectance,
                    },
                ),
                sky,
                camera,
                size: Size::new(pixels, pixels)?,
                paths: samples,
                ends: Ends::Depth(10),
                factor: 1.0,
                counts: false,
            })
        };
    let down = || PerspectiveCamera::new(Point3::new(0.0, 2.0, 0.0), -up, ahead, FRAC_PI_2);
    match name {
        "light-furnace" => furnace(0.5, Ends::Depth(samples), 2.0, 100, 100),
        "light-deep" => furnace(0.999, Ends::Depth(samples), 2500.0, 16, 12),
        "light-roulette" | "light-steps" => furnace(0.9, Ends::Roulette, 20.0, 100, 100),
        "light-ball" => {
            let camera = OrthographicCamera::new(Point3::new(0.0, 0.0, 5.0), ahead, up, 2.0)?;
            let sky = |d: Vector3| f64::from(u8::from(d.y() > 0.0));
            outside(Box::new(sphere), 0.8, sky, Box::new(camera), 101)
        }
        "light-zenith" => outside(Box::new(floor), 0.9, |d| d.y(), Box::new(down()?), 100),
        _ => {
            let sky = |d: Vector3| f64::from(u8::from(2.0 * d.x() + d.z() > 0.0));
            outside(Box::new(floor), 0.5, sky, Box::new(down()?), 100)
        }
    }?
    .draw()
}
