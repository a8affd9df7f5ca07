//! The full angle taken for the half one, corners of pixels for their middles, and stripes
//! beside the horizon.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use a02_math::Point3;
use a03_rays_cameras::{Camera, PinholeCamera, Ray, StripeRule, StripedSky, View, protocol};
use a04_intersections::{Sphere, World};
use common::{ArgumentError, Color, Error, Scene, Settings, Size};

use super::{beside, traced};

fn pinhole(angle: f64) -> Result<PinholeCamera, ArgumentError> {
    PinholeCamera::new(Point3::ORIGIN, angle)
}

/// The direction of the ray through a place in a picture of this size.
type Direction = fn(size: Size, x: f64, y: f64) -> a02_math::Vector3;

/// A camera of the protocol at the origin, looking along -z, with an angle of 45 degrees.
struct Printed(Direction);

impl Camera for Printed {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        Ray::derived(Point3::ORIGIN, (self.0)(size, x, y))
    }
}

fn sides(size: Size) -> [f64; 2] {
    [size.width(), size.height()].map(f64::from)
}

pub fn tangent() -> Scene {
    let about = "the tangent of the full opening angle, and of half of it";
    let perspective: Direction =
        |size, x, y| protocol::perspective_direction(sides(size), x, y, FRAC_PI_4);
    beside(
        "tangent",
        about,
        move |_| two_spheres(Printed(perspective)),
        |_| two_spheres(pinhole(FRAC_PI_4)?),
    )
}

/// The two spheres of scene 5.
fn two_spheres(camera: impl Camera) -> Result<View, Error> {
    let world = World::new(Color::BLACK)?
        .with(Sphere::new(Point3::new(-1.0, 0.0, -3.0), 0.5)?, Color::RED)
        .with(Sphere::new(Point3::new(1.0, 0.0, -6.0), 0.5)?, Color::RED);
    Ok(traced(camera, move |ray| world.color_for(ray)))
}

const STRIPES: u32 = 10;

pub fn stripes() -> Scene {
    let about = "ten stripes, counted by the height without and with its sign";
    let wrong = |settings: &Settings| {
        let camera = pinhole(FRAC_PI_2)?;
        let [width, _] = sides(settings.size);
        let edge = camera.generate_ray(settings.size, 0.5 * width, 0.0);
        let top = edge.direction().y();
        Ok(traced(camera, move |ray| {
            let y = ray.direction().y();
            let is_even = protocol::count_current_stripe(top, STRIPES, y).is_multiple_of(2);
            Color::from_bytes(if is_even {
                [25, 25, 112]
            } else {
                [50, 205, 50]
            })
        }))
    };
    beside("stripes", about, wrong, |settings| {
        let camera = pinhole(FRAC_PI_2)?;
        let sky = StripedSky::new(&camera, settings.size, STRIPES, StripeRule::Direction)?;
        Ok(traced(camera, move |ray| sky.color_for(ray)))
    })
}

pub fn half_pixel() -> Scene {
    let about = "a ball on 24x18 pixels, through their corners and through their middles";
    // Whole numbers are corners of pixels for the pinhole camera.
    let corners: Direction = |size, x, y| {
        let [w, h] = sides(size);
        protocol::pinhole_direction([w, h], x, h - 1.0 - y, FRAC_PI_4)
    };
    beside(
        "half-pixel",
        about,
        move |_| ball(Printed(corners)),
        |_| ball(pinhole(FRAC_PI_4)?),
    )
}

/// A camera of a picture whose pixels are squares of 15 pixels of the shown one.
struct Enlarged<C>(C);

impl<C: Camera> Camera for Enlarged<C> {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let few = |side: u32| side.div_ceil(15);
        let size = Size::new(few(size.width()), few(size.height())).unwrap_or(size);
        let number = |place: f64| ((place + 0.5) / 15.0).floor();
        self.0.ray_for(size, number(x), number(y))
    }
}

/// A ball straight ahead on a few pixels, each shown as a square.
fn ball(camera: impl Camera) -> Result<View, Error> {
    let world = World::new(Color::gray(0.1))?
        .with(Sphere::new(Point3::new(0.0, 0.0, -3.0), 0.45)?, Color::RED);
    Ok(traced(Enlarged(camera), move |ray| world.color_for(ray)))
}
