//! A lens: rays from random points of a disc, which meet in the plane in focus.

use answers::*;

fn main() -> Result<(), Error> {
    run(render)
}

#[derive(Clone, Copy)]
struct Lens {
    radius: f64,
    focus: f64,
}

/// What a camera sees, and through which lens.
struct Scene {
    light_along: Box<dyn Fn(&Ray) -> Color>,
    lens: Lens,
    eye: Point3,
    gaze: Vector3,
    /// The vertical field of view.
    angle: f64,
    size: Size,
}

impl Lens {
    /// The ray from a point of the lens instead of the `ray` from its middle. Two random numbers choose the
    /// point.
    fn refract(&self, basis: &Basis, ray: &Ray, [u, v]: [f64; 2]) -> Ray {
        // Of this length it leads to the depth 1.
        let ahead = ray.direction() * (-1.0 / basis.w.dot(ray.direction()));
        let (distance, angle) = (self.radius * u.sqrt(), TAU * v);
        let right = basis.u * (distance * libm::cos(angle));
        let aside = right + basis.v * (distance * libm::sin(angle));
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
    for (z, left, low, high) in [
        (-5.0, -20.0, 2.0, 10.0),
        (-2.0, -2.5, -0.2, 0.2),
        (-1.25, -4.0, -4.0, -0.5),
    ] {
        let [lbf, run] = [Point3::new(left, low, z), Point3::new(0.0, high, z)];
        world = world.with(AxisAlignedBox::new(lbf, run)?, Color::WHITE);
    }
    Ok(world)
}

fn light() -> Result<World<Color>, Error> {
    let (c, n) = (Point3::new(0.0, 0.0, -5.0), Normal3::new(0.0, 0.0, 1.0));
    Ok(World::new(Color::BLACK)?.with(Disc::new(c, n, 0.12)?, Color::gray(10.0)))
}

fn scene(name: &str) -> Result<Scene, Error> {
    let world = match name {
        "lens-light" => light()?,
        _ => edges()?,
    };
    Ok(Scene {
        light_along: Box::new(move |ray| world.color_for(ray)),
        lens: Lens {
            radius: match name {
                "lens-pinhole" | "lens-rays" => 0.0,
                _ => 0.5,
            },
            focus: match name {
                "lens-infinity" => f64::INFINITY,
                _ => 2.0,
            },
        },
        eye: Point3::ORIGIN,
        gaze: AHEAD,
        angle: FRAC_PI_2,
        size: Size::new(300, 200)?,
    })
}

/// The picture behind the dares: a row of balls at night.
fn night() -> Result<Scene, Error> {
    let random = PixelRandom::new(7, 0, 0);
    let wet = Reflective::new(Color::gray(0.03), Color::BLACK, 1.0, Color::gray(0.4))?;
    let mut world = ShadowedWorld::empty(Color::new(0.004, 0.006, 0.014), Color::gray(0.12))?
        .with(Plane::new(Point3::ORIGIN, UP.as_normal())?, Box::new(wet));
    for i in 0..7 {
        let step = f64::from(i);
        let color = Color::new(0.8 - 0.13 * step, 0.06 + 0.03 * step, 0.02 + 0.1 * step);
        let shiny = Reflective::new(color, Color::WHITE, 200.0, Color::gray(0.12))?;
        let c = Point3::new(0.9 * step - 2.0, 0.5, 2.2 - 1.6 * step);
        world = world.with(Sphere::new(c, 0.5)?, Box::new(shiny));
    }
    for i in 0..90 {
        let [x, y, z, hue] = [0, 1, 2, 3].map(|k| random.uniform(4 * i + k));
        let c = Point3::new(44.0 * x - 22.0, 0.4 + 8.0 * y * y, -16.0 - 14.0 * z);
        let glow = [0.0, 1.0, 2.2].map(|third| 0.55 + 0.45 * libm::cos(3.0 * hue - third));
        let glow = Color::new(glow[0], glow[1], glow[2]) * 8.0;
        world = world.with(Sphere::new(c, 0.12)?, Box::new(SingleColor::new(glow)?));
    }
    let lamp = PointLight::new(Color::gray(0.9), Point3::new(-4.0, 7.0, 6.0))?;
    let world = world.lit_by(LightSource::new(lamp, true));
    Ok(Scene {
        light_along: Box::new(move |ray| RecursiveTracer::new(&world).trace(ray, 3)),
        lens: Lens {
            radius: 0.13,
            focus: 6.2,
        },
        eye: Point3::new(0.0, 1.3, 7.0),
        gaze: Vector3::new(0.0, -0.04, -1.0),
        angle: 0.6,
        size: Size::new(640, 400)?,
    })
}

fn render(name: &str, samples: u32) -> Result<Image, Error> {
    let Scene {
        light_along,
        lens,
        eye,
        gaze,
        angle,
        size,
    } = match name {
        "lens-still" => night(),
        _ => scene(name),
    }?;
    let basis = Basis::new(eye, gaze, UP)?;
    let camera = perspective(eye, gaze, angle)?;
    let image = Image::from_fn(size, |column, row| {
        let random = PixelRandom::new(seed(), column, row);
        let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
        let ray = camera.ray_for(size, x, y);
        let count = lens.rays(samples);
        match name {
            "lens-camera" => return light_along(&ray),
            "lens-rays" => return Color::gray(f64::from(count) / f64::from(samples)),
            _ => {}
        }
        let mut sum = Color::BLACK;
        for i in 0..u64::from(count) {
            let place = [2 * i, 2 * i + 1].map(|n| random.uniform(n));
            sum += light_along(&lens.refract(&basis, &ray, place));
        }
        sum * (1.0 / f64::from(count))
    })?;
    Ok(match name {
        "lens-still" => for_screens(image, Transfer::Gamma),
        _ => image,
    })
}
