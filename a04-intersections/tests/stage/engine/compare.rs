//! Compares the hits of the engine with the hits of the lesson's list, bit by bit.

use a02_math::{Normal3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::fast::{Translate, add_objects};
use a04_intersections::{Hit, Interval, World};
use common::{Color, Settings};
use engine::{Camera, Renderer, Scene, Shading, Surface};

/// A world prepared by the engine.
pub fn prepared(world: &World<usize>, shapes: Translate) -> Renderer<'_> {
    let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
    add_objects(&mut scene, world, shapes, |_| {
        Surface::matt(Shading::SingleColor(Color::BLACK))
    });
    let camera = Camera::Other(Box::new(|_, _, _| engine::Ray {
        origin: [0.0; 3].into(),
        direction: [1.0, 0.0, 0.0].into(),
    }));
    Renderer::new(scene, camera, &Settings::default())
}

/// A hit: all its numbers, bit by bit, and the index of the object.
type Found = Option<([u64; 7], usize)>;

fn bits(Hit { t, normal, face }: Hit) -> [u64; 7] {
    let [n, f] = [normal, face].map(Normal3::to_glam);
    [t, n.x, n.y, n.z, f.x, f.y, f.z].map(f64::to_bits)
}

fn of_list(world: &World<usize>, ray: &Ray, within: Interval) -> Found {
    let (hit, surface) = world.hit(ray, within)?;
    Some((bits(hit), *surface))
}

fn of_engine(world: &World<usize>, found: Option<(engine::Hit, u32)>) -> Found {
    let (hit, object) = found?;
    let (_, surface) = world.objects().nth(object as usize)?;
    Some((bits((&hit).into()), *surface))
}

/// Compares the hits of four rays, of the ones whose bits are set in `active`.
pub fn compare_four(
    world: &World<usize>,
    engine: &Renderer,
    rays: [&(Ray, Interval); 4],
    active: u32,
) {
    let four = rays.map(|(ray, _)| engine::Ray::from(ray));
    let hits = engine.hit_together(four.each_ref(), active);
    let max = rays.map(|(_, within)| within.max);
    let is_hit = engine.is_hit_together(four.each_ref(), max, active);
    for (lane, (ray, within)) in rays.into_iter().enumerate() {
        if active >> lane & 1 == 0 {
            continue;
        }
        let together = of_engine(world, hits[lane]);
        assert_eq!(together, of_list(world, ray, Interval::AHEAD), "{ray:?}");
        let before = Interval::before(within.max);
        let expected = world.is_hit(ray, before);
        assert_eq!(is_hit >> lane & 1 != 0, expected, "{ray:?}");
    }
}

/// Compares the hits of rays alone and in fours, and returns how many rays hit
/// anything.
pub fn compare(world: &World<usize>, shapes: Translate, rays: &[(Ray, Interval)]) -> usize {
    let engine = &prepared(world, shapes);
    let mut hits = 0;
    for (ray, within) in rays {
        let expected = of_list(world, ray, *within);
        let Interval { min, max } = *within;
        let (alone, inside) = (ray.into(), engine::Interval { min, max });
        let found = of_engine(world, engine.hit(&alone, inside));
        assert_eq!(found, expected, "{ray:?}");
        let is_hit = engine.is_hit(&alone, inside);
        assert_eq!(is_hit, world.is_hit(ray, *within), "{ray:?}");
        hits += usize::from(expected.is_some());
    }
    // Four in a row go different ways; of ten kinds, rays ten apart are alike.
    for (i, forty) in rays.chunks_exact(40).enumerate() {
        let lanes = 1 + i as u32 % 15;
        for k in 0..10 {
            let four = [0, 10, 20, 30].map(|further| &forty[k + further]);
            compare_four(world, engine, four, lanes);
            compare_four(world, engine, four, 0b1111);
            let four = [0, 1, 2, 3].map(|further| &forty[4 * k + further]);
            compare_four(world, engine, four, 0b1111);
        }
    }
    // Rays that differ little are followed together.
    for (i, (ray, within)) in rays.iter().enumerate() {
        let aside = |k: i32| Vector3::new(1e-3, -2e-4, 3e-4) * f64::from(k);
        let near =
            [0, 1, 2, 3].map(|k| Ray::new(ray.origin(), ray.direction() + aside(k)).unwrap());
        let near = near.map(|ray| (ray, *within));
        compare_four(world, engine, near.each_ref(), 1 + i as u32 % 15);
    }
    hits
}
