//! The time of single steps of the tracer.
//!
//! ```console
//! $ cargo bench -p a07-transforms --bench kernels            all of them
//! $ cargo bench -p a07-transforms --bench kernels -- shapes  the shapes only
//! ```
//!
//! Each step is taken for 65,536 different rays in a row, so that the processor
//! cannot learn the outcomes by heart, and about half of the rays hit the shape:
//! a test that always fails is cheaper. Read the figures as ratios of one run;
//! a factor that comes and goes with the next build comes from the layout of the
//! program, not from its arithmetic.

use std::f64::consts::FRAC_PI_4;
use std::hint::black_box;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{
    Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, PixelRandom, Ray,
};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a05_lighting::{Lambert, LitWorld, Material, Phong, PointLight, SingleColor};
use a06_shadows_reflection::Reflective;
use a07_transforms::{Disc, Node, Transform};
use common::{ArgumentError, Color, Size};
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
}

const RAYS: usize = 65_536;
const O: Point3 = Point3::ORIGIN;
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

type Made<T> = Result<T, ArgumentError>;

/// Rays from all around towards the surroundings of the origin, far enough beside
/// it that a sphere of radius 1 is hit by half of them.
fn rays() -> Vec<Ray> {
    let ray = |i: usize| {
        let random = PixelRandom::new(1, i as u32, 0);
        let at = |n| 2.0 * random.uniform(n) - 1.0;
        let from = Vector3::new(at(0), at(1), at(2)).normalized()?;
        let aim = Point3::new(at(3), at(4), at(5));
        let origin = O + from * 5.0;
        let aside = Vector3::new(at(6), at(7), at(8)) * 0.6;
        Ray::new(origin, (aim - origin) + aside).ok()
    };
    (0..2 * RAYS).filter_map(ray).take(RAYS).collect()
}

fn count(bencher: Bencher, step: impl Fn(&Ray) -> bool + Sync) {
    let rays = rays();
    bencher
        .counter(ItemsCount::new(rays.len()))
        .bench(|| rays.iter().filter(|ray| step(black_box(ray))).count());
}

fn boxed(geometry: Made<impl Geometry>) -> Made<Box<dyn Geometry>> {
    Ok(Box::new(geometry?))
}

fn geometry(name: &str) -> Made<Box<dyn Geometry>> {
    let unit_sphere = || Sphere::new(O, 1.0);
    match name {
        "plane" => boxed(Plane::new(O, UP.as_normal())),
        "box" => {
            let (lbf, run) = (Point3::new(-0.8, -0.8, -0.8), Point3::new(0.8, 0.8, 0.8));
            boxed(AxisAlignedBox::new(lbf, run))
        }
        "triangle" => boxed(Triangle::new(
            Point3::new(-2.0, -1.5, 0.0),
            Point3::new(2.0, -1.5, 0.3),
            Point3::new(0.0, 2.0, -0.3),
        )),
        "disc" => boxed(Disc::new(O, Normal3::new(0.0, 1.0, 0.0), 1.5)),
        "sphere" => boxed(unit_sphere()),
        // A sphere under nodes that need more and more of a matrix.
        node => {
            let start = Transform::IDENTITY;
            let transform = match node {
                "identity" => start,
                "translation" => start.translate(Point3::new(0.1, 0.2, 0.3))?,
                _ => start.scale(1.2, 0.8, 1.0)?.rotate_y(0.3)?,
            };
            boxed(Ok(Node::new(transform).with(unit_sphere()?)))
        }
    }
}

#[divan::bench(args = ["plane", "sphere", "box", "triangle", "disc"])]
fn shapes(bencher: Bencher, name: &str) {
    let geometry = geometry(name).expect("a shape");
    count(bencher, |ray| geometry.hit(ray, Interval::AHEAD).is_some());
}

#[divan::bench(args = ["identity", "translation", "stretched and turned"])]
fn nodes(bencher: Bencher, name: &str) {
    shapes(bencher, name);
}

fn camera(name: &str) -> Made<Box<dyn Camera>> {
    let gaze = Vector3::new(0.0, 0.0, -1.0);
    Ok(match name {
        "orthographic" => Box::new(OrthographicCamera::new(O, gaze, UP, 3.0)?),
        "perspective" => Box::new(PerspectiveCamera::new(O, gaze, UP, FRAC_PI_4)?),
        _ => Box::new(PinholeCamera::new(O, FRAC_PI_4)?),
    })
}

#[divan::bench(args = ["orthographic", "perspective", "pinhole"])]
fn cameras(bencher: Bencher, name: &str) {
    let camera = camera(name).expect("a camera");
    count(bencher, |ray| {
        let (x, y) = (ray.origin().x() * 60.0, ray.origin().y() * 60.0);
        camera.ray_for(Size::COURSE, x, y).direction().x() > 0.0
    });
}

fn material(name: &str) -> Made<Box<dyn Material>> {
    let (red, half) = (Color::RED, Color::gray(0.5));
    Ok(match name {
        "single color" => Box::new(SingleColor::new(red)?),
        "Lambert" => Box::new(Lambert::new(red)?),
        "Phong" => Box::new(Phong::new(red, Color::WHITE, 64.0)?),
        _ => Box::new(Reflective::new(red, Color::WHITE, 64.0, half)?),
    })
}

/// The colour of each hit of a sphere under one light.
#[divan::bench(args = ["single color", "Lambert", "Phong", "Reflective"])]
fn materials(bencher: Bencher, name: &str) {
    let material = material(name).expect("a material");
    let light = PointLight::new(Color::WHITE, Point3::new(5.0, 8.0, 3.0)).expect("a light");
    let world = LitWorld::new(Color::BLACK, Color::gray(0.1)).expect("a world");
    let world = world.lit_by(Box::new(light));
    let normal = |ray: &Ray| (ray.origin() - O).normalized();
    let hit = |ray: &Ray| Some(Hit::new(4.0, normal(ray)?.as_normal()));
    count(bencher, |ray| {
        hit(ray).is_some_and(|hit| material.color_for(ray, &hit, &world) != Color::BLACK)
    });
}
