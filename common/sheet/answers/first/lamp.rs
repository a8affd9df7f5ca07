//! A lamp with an area: a rectangle, with one sample in each square of a grid.

use crate::functions::*;

/// A lamp that glows with 1 on one side and is itself not seen.
struct Lamp {
    corner: Point3,
    sides: [Vector3; 2],
}

struct Scene {
    objects: World<()>,
    lamp: Lamp,
    /// The ball that may stand in the light: its middle and its radius.
    ball: Option<(Point3, f64)>,
    shows: Shows,
}

/// Values of a pixel.
enum Shows {
    /// The share of the lamp that is in sight.
    Share,
    /// The light that a white floor reflects.
    Light,
    /// The shadow rays for each sample.
    Rays,
}

impl Lamp {
    fn point(&self, u: f64, v: f64) -> Point3 {
        self.corner + self.sides[0] * u + self.sides[1] * v
    }

    /// A random point in each of `cells` times `cells` squares.
    fn points(&self, cells: u32, random: PixelRandom) -> impl Iterator<Item = Point3> {
        (0..cells * cells).map(move |i| {
            let first = 2 * u64::from(i);
            let [u, v] = [(i % cells, first), (i / cells, first + 1)]
                .map(|(cell, n)| (f64::from(cell) + random.uniform(n)) / f64::from(cells));
            self.point(u, v)
        })
    }

    /// The fraction of its light that reaches a white floor with this normal and returns from it, if it is
    /// in the direction `to_lamp`.
    fn reflected(&self, n: Normal3, to_lamp: Vector3) -> f64 {
        let across = self.sides[0].cross(self.sides[1]);
        let squared = to_lamp.dot(to_lamp);
        let arriving = n.dot(to_lamp);
        let leaving = -across.dot(to_lamp);
        leaving.max(0.0) * arriving.max(0.0) / (PI * squared * squared)
    }
}

impl Scene {
    fn value(&self, ray: &Ray, samples: u32, random: PixelRandom) -> f64 {
        let Some((hit, ())) = self.objects.hit(ray, Interval::AHEAD) else {
            return 0.0;
        };
        let p = ray.at(hit.t);
        let cells = samples.isqrt();
        let is_free = self.is_free(p);
        let mut sum = 0.0;
        for q in self.lamp.points(cells, random) {
            let to_lamp = q - p;
            let value = match self.shows {
                Shows::Share => 1.0,
                Shows::Light => self.lamp.reflected(hit.normal, to_lamp),
                Shows::Rays => f64::from(u8::from(!is_free)),
            };
            let rays = matches!(self.shows, Shows::Rays);
            if rays || is_free || self.is_in_sight(ray, &hit, to_lamp) {
                sum += value;
            }
        }
        sum / f64::from(cells * cells)
    }

    /// Whether nothing can be between `p` and the lamp: the ball is farther from the way to the middle of
    /// the lamp than both radii.
    fn is_free(&self, p: Point3) -> bool {
        self.ball.is_some_and(|(c, r)| {
            let middle = self.lamp.point(0.5, 0.5);
            let way = Ray::derived(p, middle - p);
            let nearest = way.at(way.t_of(c).clamp(0.0, 1.0));
            (c - nearest).magnitude() > r + (self.lamp.corner - middle).magnitude()
        })
    }

    fn is_in_sight(&self, ray: &Ray, hit: &Hit, to_lamp: Vector3) -> bool {
        let distance = to_lamp.magnitude();
        let shadow_ray = secondary_ray(ray, hit, to_lamp * (1.0 / distance));
        !self.objects.is_hit(&shadow_ray, Interval::before(distance))
    }
}

fn scene(name: &str) -> Result<Scene, Error> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let objects = World::new(Color::BLACK)?.with(floor, ());
    let lying = |x, y, z, width, depth| Lamp {
        corner: Point3::new(x, y, z),
        sides: [Vector3::new(width, 0.0, 0.0), Vector3::new(0.0, 0.0, depth)],
    };
    let (c, r) = (Point3::new(2.0, 0.75, 0.0), 0.25);
    let (objects, lamp) = match name {
        "lamp-wall" => {
            let [lbf, run] = [Point3::new(-0.2, 0.0, -20.0), Point3::new(0.0, 2.0, 20.0)];
            let wall = AxisAlignedBox::new(lbf, run)?;
            (objects.with(wall, ()), lying(-3.75, 5.0, -1.0, 1.5, 2.0))
        }
        "lamp-light" => (objects, lying(1.0, 1.0, -1.0, 2.0, 2.0)),
        "lamp-stands" => {
            let sides = [Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 2.0)];
            let corner = Point3::new(0.0, 0.0, -1.0);
            (objects, Lamp { corner, sides })
        }
        _ => {
            let ball = Sphere::new(c, r)?;
            (objects.with(ball, ()), lying(-0.5, 4.0, -0.5, 1.0, 1.0))
        }
    };
    Ok(Scene {
        objects,
        lamp,
        ball: matches!(name, "lamp-less" | "lamp-rays").then_some((c, r)),
        shows: match name {
            "lamp-light" | "lamp-stands" => Shows::Light,
            "lamp-rays" => Shows::Rays,
            _ => Shows::Share,
        },
    })
}

pub fn render(name: &str, samples: u32) -> Result<Image, Error> {
    let scene = scene(name)?;
    let [down, up] = [Vector3::new(0.0, -1.0, 0.0), Vector3::new(0.0, 0.0, -1.0)];
    let camera = PerspectiveCamera::new(Point3::new(2.0, 2.0, 0.0), down, up, FRAC_PI_2)?;
    let size = Size::new(300, 200)?;
    Image::from_fn(size, |column, row| {
        let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
        let random = PixelRandom::new(crate::seed(), column, row);
        Color::gray(scene.value(&camera.ray_for(size, x, y), samples, random))
    })
}
