//! Compares the hits of the engine, by each of its instruction sets, with the hits of the lesson's list,
//! bit by bit, in a picture in which a pixel is the hit of a ray of its own.

use std::hash::{DefaultHasher, Hash, Hasher};

use a02_math::Vector3;
use a03_rays_cameras::{Ray, Sampler};
use a04_intersections::kinds::Shapes;
use a04_intersections::{Hit, Interval, World};
use common::{Color, Settings, Size};
use engine::{Camera, Renderer, Scene, Shading, Surface};

/// A hit as a pixel: `t`, a hash of all other numbers of ray and hit, and the surface.
fn pixel(ray: &Ray, hit: &Hit, surface: usize) -> Color {
    let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
    let numbers = [o, d, hit.normal.to_glam(), hit.geometric_normal.to_glam()];
    let mut hasher = DefaultHasher::new();
    numbers
        .map(|v| v.to_array().map(f64::to_bits))
        .hash(&mut hasher);
    Color::new(hit.t, (hasher.finish() >> 11) as f64, surface as f64)
}

/// The number of the ray of a pixel in a picture of 32 columns: four for each square of pixels,
/// which the engine traces together.
const fn number(x: usize, y: usize) -> usize {
    64 * (y / 2) + 4 * (x / 2) + 2 * (y % 2) + x % 2
}

/// Compares the hits of these rays, and returns the number of rays that hit anything.
pub fn compare(world: &World<usize>, shapes: Shapes, rays: &[Ray]) -> usize {
    let of_list = |ray: Ray| match world.hit(&ray, Interval::AHEAD) {
        Some((hit, surface)) => (ray, pixel(&ray, &hit, *surface)),
        None => (ray, Color::BLACK),
    };
    let alone: Vec<_> = rays.iter().map(|ray| of_list(*ray)).collect();
    // Neighbours of ten kinds go different ways; rays ten apart are alike.
    let mut all = alone.clone();
    for kind in 0..10 {
        all.extend(alone.iter().skip(kind).step_by(10));
    }
    // Rays that differ little traverse the tree together: four of each ray, and 64 of some.
    let near = |ray: &Ray, k: u32| {
        let aside = Vector3::new(1e-3, -2e-4, 3e-4) * f64::from(k);
        of_list(Ray::new(ray.origin(), ray.direction() + aside).unwrap())
    };
    for same @ (ray, _) in &alone {
        all.extend([*same, near(ray, 1), near(ray, 2), near(ray, 3)]);
    }
    all.resize(all.len().next_multiple_of(64), alone[0]);
    for ray in rays.iter().step_by(33) {
        all.extend((0..64).map(|k| near(ray, k)));
    }

    let height = 2 * (all.len() / 64);
    let settings = Settings {
        size: Size::new(32, height as u32).unwrap(),
        ..Settings::default()
    };
    let render = || {
        let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
        shapes.add_objects(&mut scene, world, |surface| {
            let shade = |ray: &_, hit: &_| pixel(&Ray::from(ray), &Hit::from(hit), *surface);
            Surface::matt(Shading::Other(Box::new(shade)))
        });
        let ray_for = |_, x: f64, y: f64| (&all[number(x as usize, y as usize)].0).into();
        let renderer = Renderer::new(scene, Camera::Other(Box::new(ray_for)), &settings);
        let picture = renderer.render(&Sampler::new(&settings), &settings, &());
        picture.unwrap()
    };
    for of_engine in engine::at_each_level(render) {
        for (y, row) in (0..height).rev().zip(of_engine.rows()) {
            for (x, engine) in row.iter().enumerate() {
                let (ray, list) = &all[number(x, y)];
                assert_eq!(engine, list, "{ray:?}");
            }
        }
    }
    alone.iter().filter(|(_, hit)| *hit != Color::BLACK).count()
}
