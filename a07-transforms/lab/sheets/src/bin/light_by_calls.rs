//! Light that has been everywhere: what a ray brings is the glow of its surface, and what a second ray brings to it.

use std::thread;

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

type Sky = fn(Vector3) -> f64;

struct Surroundings<'a> {
    shape: &'a dyn Geometry,
    glow: f64,
    reflectance: f64,
    sky: Sky,
    roulette: bool,
}

/// A generator of random numbers that goes on from pixel to pixel (Vigna: xorshift64*, 2016).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// A point of the unit sphere: its height is as likely as any other.
    fn on_sphere(&mut self) -> Vector3 {
        let height = 2.0 * self.next() - 1.0;
        let (sin, cos) = libm::sincos(TAU * self.next());
        let radius = (1.0 - height * height).sqrt();
        Vector3::new(radius * cos, height, radius * sin)
    }
}

/// The light along a ray that may meet `depth` surfaces, and how many it has met.
fn light(around: &Surroundings<'_>, ray: &Ray, depth: u32, random: &mut Random) -> (f64, u32) {
    let Some(hit) = around.shape.hit(ray, Interval::AHEAD) else {
        return ((around.sky)(ray.direction()), 0);
    };
    let goes_on = !around.roulette || random.next() < around.reflectance;
    if depth == 1 || !goes_on {
        return (around.glow, 1);
    }
    let backwards = hit.geometric_normal.dot(ray.direction()) > 0.0;
    let n = Vector3::from(hit.geometric_normal) * if backwards { -1.0 } else { 1.0 };
    // The unit sphere that touches the surface from outside, seen from the point: by the cosine.
    let direction = (n + random.on_sphere()).normalized().unwrap_or(n);
    let (reflected, met) = light(
        around,
        &secondary_ray(ray, &hit, direction),
        depth - 1,
        random,
    );
    let weight = if around.roulette {
        1.0
    } else {
        around.reflectance
    };
    (around.glow + weight * reflected, met + 1)
}

/// The direction of the camera's ray through a pixel of a picture with this width and height.
fn through(column: u32, row: u32, [width, height]: [u32; 2]) -> [f64; 2] {
    let [x, y] = [(column, width), (row, height)]
        .map(|(n, size)| f64::from(n) - (f64::from(size) - 1.0) / 2.0);
    [x, -y].map(|way| way / (f64::from(height) / 2.0))
}

fn draw(scene: &str, samples: u32) -> Result<Image, Error> {
    let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let (shape, glow, reflectance, factor, size): (&dyn Geometry, _, _, _, _) = match scene {
        "light-furnace" => (&ball, 1.0, 0.5, 2.0, [100, 100]),
        "light-deep" => (&ball, 1.0, 0.999, 2500.0, [16, 12]),
        "light-roulette" | "light-steps" => (&ball, 1.0, 0.9, 20.0, [100, 100]),
        "light-ball" => (&ball, 0.0, 0.8, 1.0, [101, 101]),
        "light-zenith" => (&floor, 0.0, 0.9, 1.0, [100, 100]),
        _ => (&floor, 0.0, 0.5, 1.0, [100, 100]),
    };
    let sky: Sky = match scene {
        "light-zenith" => |d| d.y(),
        "light-ball" => |d| if d.y() > 0.0 { 1.0 } else { 0.0 },
        _ => |d| if 2.0 * d.x() + d.z() > 0.0 { 1.0 } else { 0.0 },
    };
    let around = Surroundings {
        shape,
        glow,
        reflectance,
        sky,
        roulette: matches!(scene, "light-roulette" | "light-steps"),
    };
    let is_depth = matches!(scene, "light-furnace" | "light-deep");
    let (paths, depth) = if is_depth {
        (1, samples)
    } else {
        (samples, u32::MAX)
    };
    let mut random = Random(seed() ^ 0x1234_5678_9ABC_DEF1);
    Image::from_fn(Size::new(size[0], size[1])?, |column, row| {
        let [x, y] = through(column, row, size);
        let (origin, d) = match scene {
            // 2 from the first pixel's middle to the last one's.
            "light-ball" => (
                Point3::new(x * 1.01, y * 1.01, 5.0),
                Vector3::new(0.0, 0.0, -1.0),
            ),
            "light-zenith" | "light-sky" => (Point3::new(0.0, 2.0, 0.0), Vector3::new(x, -1.0, -y)),
            _ => (Point3::ORIGIN, Vector3::new(x, y, -1.0)),
        };
        let ray = Ray::derived(origin, d.normalized().unwrap_or(d));
        let mut sum = 0.0;
        for _ in 0..paths {
            let (light, met) = light(&around, &ray, depth, &mut random);
            sum += if scene == "light-steps" {
                f64::from(met)
            } else {
                light
            };
        }
        Color::gray(sum / f64::from(paths) / factor)
    })
}

fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    // Ten thousand calls within calls need more than the usual memory for them.
    thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(64 << 20);
        let thread = thread.spawn_scoped(scope, || draw(scene, samples));
        thread.expect("a thread begins").join().expect("it ends")
    })
}
