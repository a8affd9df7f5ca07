//! The full angle taken for the half one, corners of pixels for their middles, and stripes
//! beside the horizon.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use a02_math::{Point3, Vector3};
use a03_lab::protocol;
use a03_rays_cameras::{Camera, PinholeCamera, Ray, StripeRule, StripedSky, View};
use a04_intersections::{Sphere, World};
use common::{Color, Error, Scene, Size};

use super::{Made, beside, traced};

fn pinhole(angle: f64) -> Made<PinholeCamera> {
    PinholeCamera::new(Point3::ORIGIN, angle)
}

/// The direction of the ray through a place in a picture with these sides.
type Direction = fn([f64; 2], x: f64, y: f64) -> Vector3;

/// A camera of the protocol at the origin, looking along -z.
struct ProtocolCamera(Direction);

impl Camera for ProtocolCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        Ray::derived(Point3::ORIGIN, (self.0)(sides(size), x, y))
    }
}

fn sides(size: Size) -> [f64; 2] {
    [size.width(), size.height()].map(f64::from)
}

const FULL_ANGLE: ProtocolCamera =
    ProtocolCamera(|sides, x, y| protocol::perspective_direction(sides, x, y, FRAC_PI_4));

pub fn tangent() -> Scene {
    beside(
        "tangent",
        "the tangent of the full field of view, and of half of it",
        |_| two_spheres(FULL_ANGLE),
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
    beside(
        "stripes",
        "ten stripes, counted by the height without and with its sign",
        |settings| {
            let camera = pinhole(FRAC_PI_2)?;
            let [width, _] = sides(settings.size);
            let edge = camera.generate_ray(settings.size, 0.5 * width, 0.0);
            let top = edge.direction().y();
            let stripe = move |y| protocol::count_current_stripe(top, STRIPES, y);
            let colors = [[25, 25, 112], [50, 205, 50]].map(Color::from_bytes);
            Ok(traced(camera, move |ray| {
                colors[stripe(ray.direction().y()) as usize % 2]
            }))
        },
        |settings| {
            let camera = pinhole(FRAC_PI_2)?;
            let sky = StripedSky::new(&camera, settings.size, STRIPES, StripeRule::Direction)?;
            Ok(traced(camera, move |ray| sky.color_for(ray)))
        },
    )
}

// Whole numbers are corners of pixels for the pinhole camera.
const CORNERS: ProtocolCamera =
    ProtocolCamera(|[w, h], x, y| protocol::pinhole_direction([w, h], x, h - 1.0 - y, FRAC_PI_4));

pub fn half_pixel() -> Scene {
    beside(
        "half-pixel",
        "a ball on 24x18 pixels, through their corners and through their middles",
        |_| ball(CORNERS),
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
