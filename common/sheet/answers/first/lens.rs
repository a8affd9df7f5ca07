//! A lens: rays from random points of a disc, which meet in the plane in focus.

use crate::functions::*;

#[derive(Clone, Copy)]
struct Lens {
    radius: f64,
    focus: f64,
}

impl Lens {
    /// The ray from a point of the lens instead of the `ray` from its middle. The point is chosen by two
    /// random numbers.
    fn refract(&self, basis: &Basis, ray: &Ray, [u, v]: [f64; 2]) -> Ray {
        // Of this length it leads to the depth 1.
        let ahead = ray.direction() * (-1.0 / basis.w.dot(ray.direction()));
        let (distance, angle) = (self.radius * u.sqrt(), TAU * v);
        let aside =
            basis.u * (distance * libm::cos(angle)) + basis.v * (distance * libm::sin(angle));
        // Also right for a focus at infinity, where 1/f is 0.
        let direction = ahead - aside * (1.0 / self.focus);
        Ray::derived(basis.e + aside, direction * (1.0 / direction.magnitude()))
    }

    fn rays(&self, samples: u32) -> u32 {
        if self.radius == 0.0 { 1 } else { samples }
    }
}

/// White boxes without thickness, left of x = 0: behind the plane in focus, in it, and before it.
fn edges() -> Result<World<Color>, Error> {
    let mut world = World::new(Color::BLACK)?;
    for (depth, left, low, high) in [
        (5.0, -20.0, 2.0, 10.0),
        (2.0, -2.5, -0.2, 0.2),
        (1.25, -4.0, -4.0, -0.5),
    ] {
        let [lbf, run] = [
            Point3::new(left, low, -depth),
            Point3::new(0.0, high, -depth),
        ];
        world = world.with(AxisAlignedBox::new(lbf, run)?, Color::WHITE);
    }
    Ok(world)
}

fn light() -> Result<World<Color>, Error> {
    let lamp = Disc::new(
        Point3::new(0.0, 0.0, -5.0),
        Normal3::new(0.0, 0.0, 1.0),
        0.12,
    )?;
    Ok(World::new(Color::BLACK)?.with(lamp, Color::gray(10.0)))
}

pub fn render(scene: &str, samples: u32) -> Result<Image, Error> {
    let world = if scene == "lens-light" {
        light()?
    } else {
        edges()?
    };
    let lens = Lens {
        radius: if matches!(scene, "lens-pinhole" | "lens-rays") {
            0.0
        } else {
            0.5
        },
        focus: if scene == "lens-infinity" {
            f64::INFINITY
        } else {
            2.0
        },
    };
    let [e, g, t] = [[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
    let [g, t] = [g, t].map(|[x, y, z]| Vector3::new(x, y, z));
    let e = Point3::new(e[0], e[1], e[2]);
    let basis = Basis::new(e, g, t)?;
    let camera = PerspectiveCamera::new(e, g, t, FRAC_PI_2)?;
    let size = Size::new(300, 200)?;
    Image::from_fn(size, |column, row| {
        let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
        let ray = camera.ray_for(size, x, y);
        if scene == "lens-camera" {
            return world.color_for(&ray);
        }
        let random = PixelRandom::new(crate::seed(), column, row);
        let count = lens.rays(samples);
        if scene == "lens-rays" {
            return Color::gray(f64::from(count) / f64::from(samples));
        }
        let mut sum = Color::BLACK;
        for i in 0..u64::from(count) {
            let place = [2 * i, 2 * i + 1].map(|n| random.uniform(n));
            sum += world.color_for(&lens.refract(&basis, &ray, place));
        }
        sum * (1.0 / f64::from(count))
    })
}
