//! Light that has been everywhere: a path from surface to surface, and a weight that it carries along.

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

/// A surface that glows, and reflects the same to all sides.
#[derive(Clone, Copy)]
struct Matter {
    glow: Color,
    reflectance: Color,
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
    /// The picture shows how many surfaces a path has met.
    counts: bool,
}

/// How a path ends that does not leave the scene.
#[derive(Clone, Copy)]
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

impl Matter {
    const fn gray(glow: f64, reflectance: f64) -> Self {
        Self {
            glow: Color::gray(glow),
            reflectance: Color::gray(reflectance),
        }
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
    fn path(&self, mut ray: Ray, dice: &mut Dice) -> (Color, u32) {
        let (mut light, mut weight, mut met) = (Color::BLACK, Color::WHITE, 0);
        while let Some((hit, matter)) = self.objects.hit(&ray, Interval::AHEAD) {
            light += weight * matter.glow;
            met += 1;
            let goes_on = matter.reflectance.largest_channel();
            match self.ends {
                Ends::Depth(depth) if met == depth => return (light, met),
                Ends::Depth(_) => weight = weight * matter.reflectance,
                Ends::Roulette if dice.roll() < goes_on => {
                    weight = weight * matter.reflectance * (1.0 / goes_on);
                }
                Ends::Roulette => return (light, met),
            }
            let direction = by_the_cosine(hit.geometric_normal, dice);
            ray = secondary_ray(&ray, &hit, direction);
        }
        (light + weight * (self.sky)(ray.direction()), met)
    }

    fn draw(&self) -> Result<Image, Error> {
        let size = self.size;
        Image::from_fn(size, |column, row| {
            let random = PixelRandom::new(seed(), column, row);
            let mut dice = Dice { random, next: 0 };
            let mut sum = Color::BLACK;
            for _ in 0..self.paths {
                let place = (dice.roll(), dice.roll());
                let (x, y) = camera_coordinates(size, column, row, place);
                let (light, met) = self.path(self.camera.ray_for(size, x, y), &mut dice);
                sum += if self.counts {
                    Color::gray(f64::from(met))
                } else {
                    light
                };
            }
            sum * (1.0 / f64::from(self.paths) / self.factor)
        })
    }
}

/// From the middle of a ball that glows with 1.
fn furnace(reflectance: f64, pixels: [u32; 2]) -> Result<Scene, Error> {
    let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(Scene {
        objects: World::new(Color::BLACK)?.with(ball, Matter::gray(1.0, reflectance)),
        sky: |_| 0.0,
        camera: perspective(Point3::ORIGIN, AHEAD, FRAC_PI_2)?,
        size: size(pixels)?,
        paths: 1,
        ends: Ends::Roulette,
        factor: 1.0,
        counts: false,
    })
}

/// A floor under a sky, from above.
fn floor(reflectance: f64, sky: fn(Vector3) -> f64, paths: u32) -> Result<Scene, Error> {
    let floor = Plane::new(Point3::ORIGIN, UP.as_normal())?;
    let camera = PerspectiveCamera::new(Point3::new(0.0, 2.0, 0.0), -UP, AHEAD, FRAC_PI_2)?;
    Ok(Scene {
        objects: World::new(Color::BLACK)?.with(floor, Matter::gray(0.0, reflectance)),
        sky,
        camera: Box::new(camera),
        size: Size::new(100, 100)?,
        paths,
        ends: Ends::Depth(2),
        factor: 1.0,
        counts: false,
    })
}

/// A ball before a sky whose upper half is 1.
fn ball(paths: u32) -> Result<Scene, Error> {
    let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(Scene {
        objects: World::new(Color::BLACK)?.with(ball, Matter::gray(0.0, 0.8)),
        camera: parallel(Point3::new(0.0, 0.0, 5.0), AHEAD, 2.0)?,
        size: Size::new(101, 101)?,
        ..floor(0.0, |d| white_if(d.y() > 0.0).r, paths)?
    })
}

/// The picture behind the dares: a room with a lamp behind a screen, so that all of its light has been somewhere.
fn room(paths: u32) -> Result<Scene, Error> {
    let matter = |r, g, b| Matter {
        glow: Color::BLACK,
        reflectance: Color::new(r, g, b),
    };
    let (white, lamp) = (matter(0.8, 0.78, 0.74), Matter::gray(4.5, 0.0));
    let plane = |x: f64, y: f64, z: f64, n: [f64; 3]| {
        Plane::new(Point3::new(x, y, z), Normal3::new(n[0], n[1], n[2]))
    };
    let cuboid = |a: [f64; 3], b: [f64; 3]| {
        AxisAlignedBox::new(Point3::new(a[0], a[1], a[2]), Point3::new(b[0], b[1], b[2]))
    };
    let sphere = |x, y, z, r| Sphere::new(Point3::new(x, y, z), r);
    let objects = World::new(Color::BLACK)?
        .with(plane(0.0, 0.0, 0.0, [0.0, 1.0, 0.0])?, white)
        .with(plane(0.0, 3.0, 0.0, [0.0, -1.0, 0.0])?, white)
        .with(plane(0.0, 0.0, -2.5, [0.0, 0.0, 1.0])?, white)
        .with(plane(0.0, 0.0, 7.0, [0.0, 0.0, -1.0])?, white)
        .with(
            plane(-2.2, 0.0, 0.0, [1.0, 0.0, 0.0])?,
            matter(0.75, 0.2, 0.12),
        )
        .with(
            plane(2.2, 0.0, 0.0, [-1.0, 0.0, 0.0])?,
            matter(0.12, 0.4, 0.6),
        )
        .with(cuboid([-0.9, 2.98, -1.6], [0.9, 3.0, 0.2])?, lamp)
        .with(
            cuboid([-1.6, 0.0, -1.9], [-0.8, 1.7, -1.1])?,
            matter(0.4, 0.6, 0.35),
        )
        .with(sphere(0.8, 0.7, -0.9, 0.7)?, matter(0.85, 0.85, 0.85))
        .with(sphere(-0.5, 0.4, 0.2, 0.4)?, matter(0.85, 0.6, 0.15));
    Ok(Scene {
        objects,
        camera: perspective(Point3::new(0.0, 1.5, 5.8), AHEAD, 0.62)?,
        size: Size::new(480, 400)?,
        paths,
        ..furnace(0.0, [1, 1])?
    })
}

fn render(name: &str, samples: u32) -> Result<Image, Error> {
    let of_depth = |reflectance, factor, size| -> Result<Scene, Error> {
        Ok(Scene {
            ends: Ends::Depth(samples),
            factor,
            ..furnace(reflectance, size)?
        })
    };
    match name {
        "light-furnace" => of_depth(0.5, 2.0, [100, 100])?,
        "light-deep" => of_depth(0.999, 2500.0, [16, 12])?,
        "light-roulette" | "light-steps" => Scene {
            paths: samples,
            factor: 20.0,
            counts: name == "light-steps",
            ..furnace(0.9, [100, 100])?
        },
        "light-zenith" => floor(0.9, Vector3::y, samples)?,
        "light-ball" => ball(samples)?,
        "light-still" => return Ok(for_screens(room(samples)?.draw()?, Transfer::Gamma)),
        _ => floor(0.5, |d| white_if(2.0 * d.x() + d.z() > 0.0).r, samples)?,
    }
    .draw()
}
