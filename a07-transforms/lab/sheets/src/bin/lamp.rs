//! A lamp with an area: a rectangle, with one sample in each square of a grid.

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

/// A lamp that glows with 1 on one side and is itself not seen.
struct Lamp {
    corner: Point3,
    sides: [Vector3; 2],
}

struct Scene {
    /// White, but for our own picture.
    objects: World<Color>,
    lamp: Lamp,
    /// The ball that may stand in the light: its middle and its radius.
    ball: Option<(Point3, f64)>,
    shows: Shows,
    camera: Box<dyn Camera>,
    size: Size,
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
    fn color(&self, ray: &Ray, samples: u32, random: PixelRandom) -> Color {
        let Some((hit, color)) = self.objects.hit(ray, Interval::AHEAD) else {
            return Color::BLACK;
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
        *color * (sum / f64::from(cells * cells))
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

/// A lamp that lies, or hangs below a ceiling.
fn lying([x, y, z]: [f64; 3], width: f64, depth: f64) -> Lamp {
    Lamp {
        corner: Point3::new(x, y, z),
        sides: [Vector3::new(width, 0.0, 0.0), Vector3::new(0.0, 0.0, depth)],
    }
}

fn scene(name: &str) -> Result<Scene, Error> {
    let floor = Plane::new(Point3::ORIGIN, UP.as_normal())?;
    let objects = World::new(Color::BLACK)?.with(floor, Color::WHITE);
    let (c, r) = (Point3::new(2.0, 0.75, 0.5), 0.25);
    let (objects, lamp) = match name {
        "lamp-wall" => {
            let [lbf, run] = [Point3::new(-0.2, 0.0, -20.0), Point3::new(0.0, 2.0, 20.0)];
            let wall = AxisAlignedBox::new(lbf, run)?;
            let above = Point3::new(0.0, 6.0, 0.0);
            let ceiling = Plane::new(above, Normal3::new(0.0, -1.0, 0.0))?;
            let objects = objects.with(wall, Color::WHITE);
            let lamp = lying([-3.75, 5.0, -1.0], 1.5, 2.0);
            (objects.with(ceiling, Color::WHITE), lamp)
        }
        "lamp-light" => (objects, lying([1.0, 1.0, -1.0], 2.0, 2.0)),
        "lamp-stands" => {
            let sides = [Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 2.0)];
            let corner = Point3::new(0.0, 0.0, -1.0);
            (objects, Lamp { corner, sides })
        }
        _ => {
            let ball = Sphere::new(c, r)?;
            let lamp = lying([-0.5, 4.0, -0.5], 1.0, 1.0);
            (objects.with(ball, Color::WHITE), lamp)
        }
    };
    let eye = Point3::new(2.0, 2.0, 0.0);
    let camera = PerspectiveCamera::new(eye, -UP, AHEAD, FRAC_PI_2)?;
    Ok(Scene {
        objects,
        lamp,
        ball: matches!(name, "lamp-less" | "lamp-rays").then_some((c, r)),
        shows: match name {
            "lamp-light" | "lamp-stands" => Shows::Light,
            "lamp-rays" => Shows::Rays,
            _ => Shows::Share,
        },
        camera: Box::new(camera),
        size: Size::new(300, 200)?,
    })
}

/// The picture behind the dares: balls that rise above a floor.
fn staircase() -> Result<Scene, Error> {
    // A white floor reflects this times the radiance of the lamp, which is 16.
    let floor = Plane::new(Point3::ORIGIN, UP.as_normal())?;
    let wall = Plane::new(Point3::new(0.0, 0.0, -3.0), Normal3::new(0.0, 0.0, 1.0))?;
    let stone = Color::new(0.8, 0.74, 0.66) * 16.0;
    let mut objects = World::new(Color::BLACK)?
        .with(floor, stone)
        .with(wall, stone);
    for i in 0..7 {
        let step = f64::from(i);
        let c = Point3::new(step - 3.0, 0.45 + 0.06 * step * step, 0.3 - 0.2 * step);
        let hue = TAU * step / 9.0;
        let color = [0.0, 2.1, 4.2].map(|third| 0.5 + 0.35 * libm::cos(hue - third));
        let color = Color::new(color[0], color[1], color[2]) * 16.0;
        objects = objects.with(Sphere::new(c, 0.45)?, color);
    }
    let eye = Point3::new(0.0, 3.3, 7.5);
    Ok(Scene {
        objects,
        lamp: lying([-2.0, 6.0, 1.0], 2.0, 2.0),
        ball: None,
        shows: Shows::Light,
        camera: perspective(eye, Vector3::new(0.0, -2.4, -7.5), FRAC_PI_4)?,
        size: Size::new(640, 400)?,
    })
}

fn render(name: &str, samples: u32) -> Result<Image, Error> {
    let scene = match name {
        "lamp-still" => staircase(),
        _ => scene(name),
    }?;
    let places: &[_] = match name {
        "lamp-still" => &[(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)],
        _ => &[(0.5, 0.5)],
    };
    let image = Image::from_fn(scene.size, |column, row| {
        let random = PixelRandom::new(seed(), column, row);
        let mut sum = Color::BLACK;
        for place in places {
            let (x, y) = camera_coordinates(scene.size, column, row, *place);
            let ray = scene.camera.ray_for(scene.size, x, y);
            sum += scene.color(&ray, samples, random);
        }
        sum * (1.0 / places.len() as f64)
    })?;
    Ok(match name {
        "lamp-still" => for_screens(image, Transfer::Gamma),
        _ => image,
    })
}
