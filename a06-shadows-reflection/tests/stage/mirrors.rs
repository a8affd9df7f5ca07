//! Mirrors: geometric series, depth, and mirror images.

mod depth;
mod images;
mod surfaces;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Plane, Sphere};
use a05_lighting::SingleColor;
use a06_shadows_reflection::{RecursiveTracer, Reflective, ShadowedWorld, Surface};
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const X: Vector3 = Vector3::new(1.0, 0.0, 0.0);

/// A matt surface of this diffuse colour that also reflects.
fn mirror(diffuse: Color, reflection: Color) -> Box<dyn Surface> {
    Box::new(Reflective::new(diffuse, Color::BLACK, 64.0, reflection).unwrap())
}

fn world(background: Color, ambient: Color) -> ShadowedWorld {
    ShadowedWorld::empty(background, ambient).unwrap()
}

fn plane(through: Point3, n: Vector3) -> Plane {
    Plane::new(through, n.as_normal()).unwrap()
}

fn trace(world: &ShadowedWorld, ray: &Ray, depth: u32) -> Color {
    RecursiveTracer::new(world).trace(ray, depth)
}

fn balls(world: ShadowedWorld) -> ShadowedWorld {
    let colors = [Color::RED, Color::GREEN, Color::BLUE, Color::YELLOW];
    colors
        .into_iter()
        .enumerate()
        .fold(world, |world, (n, color)| {
            let x = n as f64 * 1.7 - 2.5;
            let ball = Sphere::new(Point3::new(x, 1.5 + 0.3 * x, 0.4 * x), 0.8).unwrap();
            world.with(ball, Box::new(SingleColor::new(color).unwrap()))
        })
}

fn views() -> Vec<Ray> {
    let view = |n| {
        let random = PixelRandom::new(15, n, 0);
        let d = [0, 1, 2].map(|i| random.uniform(i) * 2.0 - 1.0);
        let eye = Point3::new(1.0, 3.0, 8.0);
        let aim = Vector3::from_glam(d.into()) * 5.0 - Vector3::new(1.0, 1.0, 9.0);
        Ray::new(eye, aim).unwrap()
    };
    (0..2000).map(view).collect()
}
