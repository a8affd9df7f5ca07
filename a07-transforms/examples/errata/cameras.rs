//! The full angle taken for the half one, and stripes beside the horizon.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use a02_math::Point3;
use a03_rays_cameras::{Camera, PinholeCamera, Ray, StripeRule, StripedSky, protocol, render};
use a04_intersections::{Sphere, World};
use common::{Color, Error, Image, Progress, Scene, Settings, Size};

use super::beside;

pub fn tangent() -> Scene {
    let about = "the tangent of the full opening angle, and of half of it";
    beside(
        "tangent",
        about,
        |settings, progress| spheres(&PrintedCamera, settings, progress),
        |settings, progress| {
            let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_4)?;
            spheres(&camera, settings, progress)
        },
    )
}

/// The perspective camera as printed, at the origin and looking along -z.
struct PrintedCamera;

impl Camera for PrintedCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let size = [size.width(), size.height()].map(f64::from);
        let direction = protocol::perspective_direction(size, x, y, FRAC_PI_4);
        Ray::derived(Point3::ORIGIN, direction)
    }
}

/// The two spheres of scene 5.
fn spheres(
    camera: &impl Camera,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    let world = World::new(Color::BLACK)?
        .with(Sphere::new(Point3::new(-1.0, 0.0, -3.0), 0.5)?, Color::RED)
        .with(Sphere::new(Point3::new(1.0, 0.0, -6.0), 0.5)?, Color::RED);
    render(camera, |ray| world.color_for(ray), settings, progress)
}

const STRIPES: u32 = 10;

pub fn stripes() -> Scene {
    let about = "ten stripes, counted by the height without and with its sign";
    beside(
        "stripes",
        about,
        |settings, progress| {
            let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
            let edge = camera.generate_ray(settings.size, 0.5 * width(settings), 0.0);
            let top = edge.direction().y();
            let color = |ray: &Ray| {
                let y = ray.direction().y();
                let is_even = protocol::count_current_stripe(top, STRIPES, y).is_multiple_of(2);
                Color::from_bytes(if is_even {
                    [25, 25, 112]
                } else {
                    [50, 205, 50]
                })
            };
            render(&camera, color, settings, progress)
        },
        |settings, progress| {
            let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
            let sky = StripedSky::new(&camera, settings.size, STRIPES, StripeRule::Direction)?;
            render(&camera, |ray| sky.color_for(ray), settings, progress)
        },
    )
}

fn width(settings: &Settings) -> f64 {
    f64::from(settings.size.width())
}

pub fn half_pixel() -> Scene {
    let about = "a ball on 24x18 pixels, through their corners and through their middles";
    beside(
        "half-pixel",
        about,
        |settings, progress| ball(&Corners, settings, progress),
        |settings, progress| {
            let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_4)?;
            ball(&camera, settings, progress)
        },
    )
}

/// The pinhole camera asked for whole numbers, which are corners of pixels.
struct Corners;

impl Camera for Corners {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [w, h] = [size.width(), size.height()].map(f64::from);
        let direction = protocol::pinhole_direction([w, h], x, h - 1.0 - y, FRAC_PI_4);
        Ray::derived(Point3::ORIGIN, direction)
    }
}

/// A ball straight ahead on a few pixels, each shown as a square.
fn ball(
    camera: &impl Camera,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    const SIDE: u32 = 15;
    let [w, h] = [settings.size.width(), settings.size.height()].map(|n| n.div_ceil(SIDE));
    let few = Settings {
        size: Size::new(w, h)?,
        ..settings.clone()
    };
    let world = World::new(Color::gray(0.1))?
        .with(Sphere::new(Point3::new(0.0, 0.0, -3.0), 0.45)?, Color::RED);
    let image = render(camera, |ray| world.color_for(ray), &few, progress)?;
    Image::from_fn(settings.size, |x, y| {
        image.get(x / SIDE, y / SIDE).unwrap_or_default()
    })
}
