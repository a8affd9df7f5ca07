//! Compares the hits of the engine with the hits of the lesson's list, bit by bit: both
//! render a picture in which a pixel is the hit of a ray of its own.

use std::hash::{DefaultHasher, Hash, Hasher};

use a02_math::Vector3;
use a03_rays_cameras::{Camera, Ray, Sampler, fast, render};
use a04_intersections::fast::{Translate, add_objects};
use a04_intersections::{Hit, Interval, World};
use common::{Color, Settings, Size};
use engine::{Renderer, Scene, Shading, Surface};

/// The rays of a picture of 32 columns, four for each square of pixels, which the engine
/// traces together.
struct Rays(Vec<Ray>);

impl Camera for Rays {
    fn ray_for(&self, _: Size, x: f64, y: f64) -> Ray {
        let [x, y] = [x, y].map(|at| at as usize);
        self.0[64 * (y / 2) + 4 * (x / 2) + 2 * (y % 2) + x % 2]
    }
}

/// A hit as a pixel: `t`, a hash of all other numbers of ray and hit, and the surface.
fn pixel(ray: &Ray, hit: &Hit, surface: usize) -> Color {
    let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
    let numbers = [o, d, hit.normal.to_glam(), hit.face.to_glam()];
    let mut hasher = DefaultHasher::new();
    numbers
        .map(|v| v.to_array().map(f64::to_bits))
        .hash(&mut hasher);
    Color::new(hit.t, (hasher.finish() >> 11) as f64, surface as f64)
}

/// Compares the hits of these rays, and returns the number of rays that hit anything.
pub fn compare(world: &World<usize>, shapes: Translate, rays: &[Ray]) -> usize {
    // Neighbours of ten kinds go different ways; rays ten apart are alike.
    let mut all = rays.to_vec();
    for kind in 0..10 {
        all.extend(rays.iter().skip(kind).step_by(10).copied());
    }
    // Rays that differ little traverse the tree together: four of each ray, and 64 of some.
    let near = |ray: &Ray, k: u32| {
        let aside = Vector3::new(1e-3, -2e-4, 3e-4) * f64::from(k);
        Ray::new(ray.origin(), ray.direction() + aside).unwrap()
    };
    all.extend(rays.iter().flat_map(|ray| (0..4).map(|k| near(ray, k))));
    all.resize(all.len().next_multiple_of(64), rays[0]);
    let some = rays.iter().step_by(33);
    all.extend(some.flat_map(|ray| (0..64).map(|k| near(ray, k))));

    let settings = Settings {
        size: Size::new(32, 2 * (all.len() / 64) as u32).unwrap(),
        ..Settings::default()
    };
    let camera = Rays(all);
    let nearest = |ray: &Ray| match world.hit(ray, Interval::AHEAD) {
        Some((hit, surface)) => pixel(ray, &hit, *surface),
        None => world.background(),
    };
    let of_list = render(&camera, nearest, &settings, &()).unwrap();
    let mut scene = Scene::new(world.background(), Color::BLACK, 1);
    add_objects(&mut scene, world, shapes, |surface| {
        let shade = |ray: &_, hit: &_| pixel(&Ray::from(ray), &Hit::from(hit), *surface);
        Surface::matt(Shading::Other(Box::new(shade)))
    });
    let renderer = Renderer::new(scene, fast::camera(&camera), &settings);
    let of_engine = renderer.render(&Sampler::new(&settings), &settings, &());
    for (engine, list) in of_engine.unwrap().pixels().iter().zip(of_list.pixels()) {
        assert_eq!(engine, list);
    }
    let is_hit = |ray: &&Ray| world.is_hit(ray, Interval::AHEAD);
    rays.iter().filter(is_hit).count()
}
