//! A lamp with an area: strips of it for the share in sight, and rays by the cosine, which meet it or not, for
//! its light.

use crate::functions::*;
use crate::workbench::*;

/// A rectangle: a flat box, whose front looks along `facing`.
struct Lamp {
    shape: AxisAlignedBox,
    corners: [Point3; 2],
    facing: Vector3,
}

fn lamp(corners: [[f64; 3]; 2], facing: Vector3) -> Result<Lamp, Error> {
    let corners = corners.map(|[x, y, z]| Point3::new(x, y, z));
    let shape = AxisAlignedBox::new(corners[0], corners[1])?;
    Ok(Lamp {
        shape,
        corners,
        facing,
    })
}

/// The `n` points of a Hammersley set, moved by two numbers of the pixel.
fn points(n: u32, [a, b]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> {
    (0..n).map(move |i| {
        let mirrored = f64::from(i.reverse_bits()) / 4_294_967_296.0;
        (
            (f64::from(i) / f64::from(n) + a) % 1.0,
            (mirrored + b) % 1.0,
        )
    })
}

/// Whether an object is on the way from the hit to a point of the lamp.
fn is_hidden(objects: &World<()>, ray: &Ray, hit: &Hit, point: Point3) -> bool {
    let start = secondary_ray(ray, hit, point - ray.at(hit.t));
    objects.is_hit(&start, Interval::before(1.0))
}

/// The share of the lamp that a hit sees. `blocker` is a box around all that may hide the lamp.
fn share(
    objects: &World<()>,
    lamp: &Lamp,
    blocker: Option<[Point3; 2]>,
    (ray, hit): (&Ray, &Hit),
    set: impl Iterator<Item = (f64, f64)>,
) -> [f64; 2] {
    let [low, high] = lamp.corners;
    let p = ray.at(hit.t);
    let is_beside = |low: f64, high: f64, [from, to]: [f64; 2]| high < from || to < low;
    let is_free = blocker.is_some_and(|[from, to]| {
        [
            (p.x(), low.x(), high.x(), [from.x(), to.x()]),
            (p.z(), low.z(), high.z(), [from.z(), to.z()]),
        ]
        .iter()
        .any(|(p, low, high, walls)| is_beside(p.min(*low), p.max(*high), *walls))
    });
    let [mut seen, mut rays, mut all] = [0.0; 3];
    for (u, v) in set {
        all += 1.0;
        let size = high - low;
        // A lamp that lies has the width u and the depth v.
        let point = low + Vector3::new(size.x() * u, 0.0, size.z() * v);
        if is_free {
            seen += 1.0;
            continue;
        }
        rays += 1.0;
        if !is_hidden(objects, ray, hit, point) {
            seen += 1.0;
        }
    }
    [seen / all, rays / all]
}

/// The light of the lamp on a white floor: the share of the rays by the cosine that meet its front.
fn light(lamp: &Lamp, ray: &Ray, hit: &Hit, set: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut met, mut all) = (0.0, 0.0);
    for (u, v) in set {
        // A point of a disc, lifted to the half ball above it: its height is distributed as the cosine is.
        let (distance, angle) = (u.sqrt(), TAU * v);
        let up = (1.0 - u).sqrt();
        let d = Vector3::new(distance * libm::cos(angle), up, distance * libm::sin(angle));
        let start = secondary_ray(ray, hit, d);
        let meets = lamp.shape.hit(&start, Interval::AHEAD).is_some();
        met += f64::from(u8::from(meets && lamp.facing.dot(d) < 0.0));
        all += 1.0;
    }
    met / all
}

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let down = -UP;
    let lamp = match scene {
        "lamp-wall" => lamp([[-3.75, 5.0, -1.0], [-2.25, 5.0, 1.0]], down),
        "lamp-light" => lamp([[1.0, 1.0, -1.0], [3.0, 1.0, 1.0]], down),
        "lamp-stands" => lamp(
            [[0.0, 0.0, -1.0], [0.0, 1.0, 1.0]],
            Vector3::new(1.0, 0.0, 0.0),
        ),
        _ => lamp([[-0.5, 4.0, -0.5], [0.5, 4.0, 0.5]], down),
    }?;
    let corners = [Point3::new(-0.2, 0.0, -20.0), Point3::new(0.0, 2.0, 20.0)];
    let wall = AxisAlignedBox::new(corners[0], corners[1])?;
    let ball = Sphere::new(Point3::new(2.0, 0.75, 0.0), 0.25)?;
    let floor = Plane::new(Point3::ORIGIN, UP.as_normal())?;
    let objects = World::new(Color::BLACK)?.with(floor, ());
    let objects = match scene {
        "lamp-wall" => objects.with(wall, ()),
        "lamp-light" | "lamp-stands" => objects,
        _ => objects.with(ball, ()),
    };
    let around_ball = [Point3::new(1.75, 0.5, -0.25), Point3::new(2.25, 1.0, 0.25)];
    let blocker = matches!(scene, "lamp-less" | "lamp-rays").then_some(around_ball);
    let size = Size::new(300, 200)?;
    let mut image = Image::black(size)?;
    for row in 0..200 {
        for column in 0..300 {
            // In the distance 1 below the camera the picture is 2 high.
            let aside = (f64::from(column) - 149.5) / 100.0;
            let d = Vector3::new(aside, -1.0, (f64::from(row) - 99.5) / 100.0);
            let ray = Ray::new(Point3::new(2.0, 2.0, 0.0), d)?;
            let Some((hit, ())) = objects.hit(&ray, Interval::AHEAD) else {
                continue;
            };
            let random = PixelRandom::new(crate::seed(), column, row);
            let set = points(samples, [random.uniform(0), random.uniform(1)]);
            let value = match scene {
                "lamp-light" | "lamp-stands" => light(&lamp, &ray, &hit, set),
                "lamp-rays" => share(&objects, &lamp, blocker, (&ray, &hit), set)[1],
                _ => share(&objects, &lamp, blocker, (&ray, &hit), set)[0],
            };
            image.set(column, row, Color::gray(value));
        }
    }
    Ok(image)
}
