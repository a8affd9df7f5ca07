//! Compares the hits of the engine with the hits of the lesson's list, bit by bit.

use std::sync::Mutex;

use a02_math::{Normal3, Vector3};
use a03_rays_cameras::{Ray, Sampler};
use a04_intersections::fast::{Translate, add_objects};
use a04_intersections::{Hit, Interval, World};
use common::{Color, Settings, Size};
use engine::{Camera, Renderer, Scene, Shading, Surface};

/// A ray and its hit: all their numbers, bit by bit, and the surface of the object.
type Found = ([[u64; 3]; 5], usize);

fn found(ray: &Ray, Hit { t, normal, face }: Hit, surface: usize) -> Found {
    let (origin, direction) = (ray.origin().to_glam(), ray.direction().to_glam());
    let [normal, face] = [normal, face].map(Normal3::to_glam);
    let numbers = [origin, direction, [t; 3].into(), normal, face];
    (numbers.map(|v| v.to_array().map(f64::to_bits)), surface)
}

fn hits_of_list(world: &World<usize>, rays: &[Ray]) -> Vec<Found> {
    let hit = |ray| {
        let (hit, surface) = world.hit(ray, Interval::AHEAD)?;
        Some(found(ray, hit, *surface))
    };
    rays.iter().filter_map(hit).collect()
}

/// Each ray is a pixel of a picture with 64 rays in each pair of rows, and the surfaces write down
/// their hits.
fn hits_of_engine(world: &World<usize>, shapes: Translate, rays: &[Ray]) -> Vec<Found> {
    let hits = Mutex::new(Vec::new());
    let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
    add_objects(&mut scene, world, shapes, |surface| {
        let hits = &hits;
        Surface::matt(Shading::Other(Box::new(move |ray, hit| {
            let found = found(&ray.into(), hit.into(), *surface);
            hits.lock().unwrap().push(found);
            Color::BLACK
        })))
    });
    let settings = Settings {
        size: Size::new(32, 2 * (rays.len() / 64) as u32).unwrap(),
        ..Settings::default()
    };
    let camera = Camera::Other(Box::new(|_, x, y| {
        let [x, y] = [x, y].map(|at| at as usize);
        // The engine traces squares of four pixels together.
        (&rays[64 * (y / 2) + 4 * (x / 2) + 2 * (y % 2) + x % 2]).into()
    }));
    let renderer = Renderer::new(scene, camera, &settings);
    let sampler = Sampler::new(&settings);
    renderer.render(&sampler, &settings, &()).unwrap();
    drop(renderer);
    hits.into_inner().unwrap()
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

    let mut of_engine = hits_of_engine(world, shapes, &all);
    let mut of_list = hits_of_list(world, &all);
    of_engine.sort_unstable();
    of_list.sort_unstable();
    for (engine, list) in of_engine.iter().zip(&of_list) {
        let numbers = |(numbers, _): &Found| numbers.map(|v| v.map(f64::from_bits));
        assert!(engine == list, "{:?}, {:?}", numbers(engine), numbers(list));
    }
    assert_eq!(of_engine.len(), of_list.len());
    hits_of_list(world, rays).len()
}
