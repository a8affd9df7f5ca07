//! Glass by recursion: at each surface a call for the mirrored ray and one for the refracted ray.

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

/// Rays that carry less of the pixel than this are not followed.
const MIN_WEIGHT: f64 = 1e-6;

/// The sky of the book's picture, just above the board.
const HORIZON: Color = Color::new(0.75, 0.78, 0.8);

fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    match scene {
        "glass-plate-0" => plate(0.0, 1.0, samples),
        "glass-plate-45" => plate(45.0, 1.0, samples),
        "glass-plate-80" => plate(80.0, 1.0, samples),
        "glass-grazing" => plate(89.9, 5000.0, samples),
        "glass-window" => window(samples),
        "glass-ball" => ball(false, samples),
        "glass-bubble" => ball(true, samples),
        "glass-count" => count(samples),
        "glass-still" => still(samples),
        _ => panic!("there is no scene {scene}"),
    }
}

/// What a surface does with light.
enum Matter {
    /// It shines by itself.
    Glows(fn(Point3) -> Color),
    /// Refractive indices: on the side to which the normal points, and on the other one.
    Glass { outside: f64, inside: f64 },
}

struct World {
    objects: Vec<(Box<dyn Geometry>, Matter)>,
    sky: fn(Vector3) -> Color,
    /// The number of rays that a path may have.
    depth: u32,
}

/// The light along a ray, and the number of rays that were followed for it.
struct Seen {
    light: Color,
    rays: u32,
}

impl World {
    fn light(&self, ray: &Ray) -> Color {
        self.trace(ray, self.depth, 1.0).light
    }

    fn trace(&self, ray: &Ray, depth: u32, weight: f64) -> Seen {
        if depth == 0 || weight < MIN_WEIGHT {
            return Seen {
                light: Color::BLACK,
                rays: 0,
            };
        }
        let Some((hit, matter)) = self.nearest(ray) else {
            let light = (self.sky)(ray.direction());
            return Seen { light, rays: 1 };
        };
        let (outside, inside) = match *matter {
            Matter::Glows(color) => {
                let light = color(ray.at(hit.t));
                return Seen { light, rays: 1 };
            }
            Matter::Glass { outside, inside } => (outside, inside),
        };
        let d = ray.direction();
        let leaves = d.dot(hit.normal) > 0.0;
        let normal = if leaves { -hit.normal } else { hit.normal };
        let (from, to) = if leaves {
            (inside, outside)
        } else {
            (outside, inside)
        };
        let cos = -d.dot(normal);
        let mirrored = d + Vector3::from(normal) * (2.0 * cos);
        let next = secondary_ray(ray, &hit, mirrored);
        let Some(refracted) = refracted(d, normal, from / to) else {
            let seen = self.trace(&next, depth - 1, weight);
            return Seen {
                light: seen.light,
                rays: seen.rays + 1,
            };
        };
        let r = reflectance(from, to, cos, -refracted.dot(normal));
        let front = self.trace(&next, depth - 1, weight * r);
        let next = secondary_ray(ray, &hit, refracted);
        let behind = self.trace(&next, depth - 1, weight * (1.0 - r));
        Seen {
            light: front.light * r + behind.light * (1.0 - r),
            rays: front.rays + behind.rays + 1,
        }
    }

    /// The nearest hit, with the normal that points out of the object.
    fn nearest(&self, ray: &Ray) -> Option<(Hit, &Matter)> {
        let mut within = Interval::AHEAD;
        let mut nearest = None;
        for (shape, matter) in &self.objects {
            if let Some(hit) = shape.hit(ray, within) {
                within = Interval::before(hit.t);
                nearest = Some((hit, matter));
            }
        }
        nearest
    }

    const fn new(sky: fn(Vector3) -> Color, depth: u32) -> Self {
        Self {
            objects: Vec::new(),
            sky,
            depth,
        }
    }

    fn with(mut self, shape: impl Geometry, matter: Matter) -> Self {
        self.objects.push((Box::new(shape), matter));
        self
    }
}

/// The direction beyond the surface; none if all light is mirrored.
fn refracted(d: Vector3, normal: Normal3, ratio: f64) -> Option<Vector3> {
    let cos = -d.dot(normal);
    let along = (d + Vector3::from(normal) * cos) * ratio;
    let squared = 1.0 - along.dot(along);
    (squared > 0.0).then(|| along - Vector3::from(normal) * squared.sqrt())
}

/// The mean of Fresnel's two polarisations.
fn reflectance(from: f64, to: f64, cos: f64, beyond: f64) -> f64 {
    let part = |a: f64, b: f64| ((a - b) / (a + b)) * ((a - b) / (a + b));
    let across = part(from * cos, to * beyond);
    let along = part(from * beyond, to * cos);
    f64::midpoint(across, along)
}

const GLASS: Matter = Matter::Glass {
    outside: 1.0,
    inside: 1.5,
};

/// Air in glass.
const AIR: Matter = Matter::Glass {
    outside: 1.5,
    inside: 1.0,
};

/// A plate before a wall of two halves, seen at this angle.
fn plate_world(depth: u32) -> Result<World, Error> {
    let wall = |p: Point3| Color::new(f64::from(u8::from(p.x() < 0.0)), 0.0, 0.4);
    let corner = Point3::new(-1e5, -1e5, -1.0);
    let plate = AxisAlignedBox::new(corner, Point3::new(1e5, 1e5, 0.0))?;
    let behind = Plane::new(Point3::new(0.0, 0.0, -3.0), Normal3::new(0.0, 0.0, 1.0))?;
    let world = World::new(|_| Color::new(0.0, 1.0, 0.4), depth);
    let world = world.with(plate, GLASS);
    Ok(world.with(behind, Matter::Glows(wall)))
}

fn plate_camera(degrees: f64) -> Result<Box<dyn Camera>, Error> {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    let eye = Point3::new(-6.0 * sin / cos, 0.0, 3.0);
    parallel(eye, Vector3::new(sin, 0.0, -cos), 3.0)
}

fn plate(degrees: f64, red: f64, depth: u32) -> Result<Image, Error> {
    let world = plate_world(depth)?;
    let brightness = Color::new(red, 1.0, 1.0);
    picture(&*plate_camera(degrees)?, [301, 301], |ray| {
        world.light(ray) * brightness
    })
}

/// The surface of glass from below.
fn window(depth: u32) -> Result<Image, Error> {
    let out = Normal3::new(0.0, 0.0, 1.0);
    let surface = Plane::new(Point3::ORIGIN, out)?;
    let wall = Plane::new(Point3::new(0.0, 0.0, -3.0), out)?;
    let world = World::new(|_| Color::GREEN, depth)
        .with(surface, GLASS)
        .with(wall, Matter::Glows(|_| Color::RED));
    let eye = Point3::new(0.0, 0.0, -1.0);
    let camera = perspective(eye, -AHEAD, FRAC_PI_2)?;
    picture(&*camera, [301, 301], |ray| world.light(ray))
}

/// A ball of glass, in which there may be a ball of air.
fn ball(hollow: bool, depth: u32) -> Result<Image, Error> {
    let mut world = World::new(|d| white_if(d.y() > -0.5), depth)
        .with(Sphere::new(Point3::ORIGIN, 1.0)?, GLASS);
    if hollow {
        world = world.with(Sphere::new(Point3::ORIGIN, 0.5)?, AIR);
    }
    let eye = Point3::new(0.0, 0.0, 5.0);
    picture(&*parallel(eye, AHEAD, 2.5)?, [251, 251], |ray| {
        world.light(ray)
    })
}

/// How many rays are followed for each pixel of the plate.
fn count(depth: u32) -> Result<Image, Error> {
    let world = plate_world(depth)?;
    let rays = |ray: &Ray| Color::gray(f64::from(world.trace(ray, depth, 1.0).rays) / 64.0);
    picture(&*plate_camera(0.0)?, [301, 301], rays)
}

/// The picture of the book: a ball, a bubble and a plate on a board, before a red ball and the sun.
fn still(samples: u32) -> Result<Image, Error> {
    let floor = Matter::Glows(|p| {
        let is_light = (p.x().floor() + p.z().floor()).rem_euclid(2.0) == 1.0;
        let field = if is_light {
            Color::new(0.8, 0.75, 0.65)
        } else {
            Color::new(0.05, 0.07, 0.12)
        };
        let far = (libm::hypot(p.x(), p.z() - 7.0) / 40.0).min(1.0);
        field * (1.0 - far) + HORIZON * far
    });
    let red = Matter::Glows(|p| Color::new(0.15 + 0.5 * p.y(), 0.05 * p.y(), 0.03 * p.y()));
    let bubble = Point3::new(1.1, 0.6, 1.9);
    let [low, high] = [Point3::new(0.2, 0.0, -0.4), Point3::new(1.8, 1.3, 0.3)];
    let sky = |d: Vector3| {
        let height = d.y().max(0.0).sqrt();
        let sky = HORIZON * (1.0 - height) + Color::new(0.08, 0.2, 0.5) * height;
        let to_sun = d.dot(Vector3::new(-0.48, 0.6, 0.64));
        sky + white_if(to_sun > 0.995) * 8.0
    };
    let world = World::new(sky, 12)
        .with(Plane::new(Point3::ORIGIN, UP.as_normal())?, floor)
        .with(Sphere::new(Point3::new(2.0, 0.9, -1.8), 0.9)?, red)
        .with(Sphere::new(Point3::new(-1.2, 1.1, 0.4), 1.1)?, GLASS)
        .with(Sphere::new(bubble, 0.6)?, GLASS)
        .with(Sphere::new(bubble, 0.54)?, AIR)
        .with(AxisAlignedBox::new(low, high)?, GLASS);
    let eye = Point3::new(-0.6, 1.9, 7.0);
    let gaze = Point3::new(0.1, 0.85, 0.0) - eye;
    let camera = perspective(eye, gaze, 34_f64.to_radians())?;
    let light = |ray: &Ray| world.light(ray).map(|l| l.min(1.0));
    let image = sampled_picture(&*camera, [640, 400], samples, light)?;
    Ok(for_screens(image, Transfer::Srgb))
}
