//! Spheres and a smooth triangle in all orders, compared with the solution.

use a04_intersections::instruments::instrumented::{push_background, shaded};

use crate::prelude::*;

yours! { nearest }

type Code = fn(&World<usize>, &Ray, Interval) -> Option<(Hit, usize)>;

/// The z of the spheres, in three orders.
const ORDERS: [[f64; 3]; 3] = [[-3.0, -6.0, -9.0], [-9.0, -6.0, -3.0], [-6.0, -9.0, -3.0]];

pub fn exercise() -> Exercise<Code> {
    Exercise {
        questions: questions(),
        picture: Picture::scene("scene-5", |nearest: &Code, settings| {
            let world = world(0.5, &[[-1.0, 0.0, -3.0], [1.0, 0.0, -6.0]])?;
            let color = |ray: &Ray| {
                let hit = nearest(&world, ray, Interval::AHEAD);
                let hit = hit.inspect(|(hit, _)| shaded(ray, hit, || ()));
                push_background(Color::BLACK);
                hit.map_or(Color::BLACK, |_| Color::RED)
            };
            paint(&*scene_5()?.camera, &color, settings)
        }),
        ..Exercise::default()
    }
}

/// Rays to the spheres in each order.
fn questions() -> Vec<CodeQuestion<Code>> {
    let (mut simple, mut others, mut r) = (Vec::new(), Vec::new(), Random::new(2));
    for zs in ORDERS {
        // Also from within spheres on.
        for min in [0.0, 4.5, 7.5, 2.5, 5.5, 8.5] {
            simple.push((zs, ([0.0; 3], [0.0, 0.0, -1.0], min, 99.0)));
        }
        // Along the triangle, which is seen from before and from behind; from behind to the triangle, into a sphere from inside, past all, and up to before the first.
        for (origin, direction, max) in [
            ([-3.0, 0.0, 4.0], [1.0, 0.0, -1.0], 99.0),
            ([3.0, 0.0, -2.0], [-1.0, 0.0, 1.0], 99.0),
            ([0.0, 0.0, -1.5], [0.0, 0.0, 1.0], 99.0),
            ([0.0, 0.0, -6.0], [0.0, 0.0, -2.0], 99.0),
            ([3.0, 0.0, 0.0], [0.0, 0.0, -1.0], 99.0),
            ([0.0; 3], [0.0, 0.0, -1.0], 1.5),
        ] {
            simple.push((zs, (origin, direction, 0.0, max)));
        }
        for _ in 0..8 {
            for ray in around([0.0, 0.0, -6.0], &mut r) {
                others.push((zs, ray));
            }
        }
    }
    // Two hits close to each other, in both orders.
    for distance in [1e-3, 1e-6, 1e-12] {
        for zs in [[-3.0, -3.0 - distance, -9.0], [-3.0 - distance, -3.0, -9.0]] {
            simple.push((zs, ahead([0.0; 3], [0.0, 0.0, -1.0])));
        }
    }
    let questions = Questions {
        words: format!("spheres of radius 1 at z = {{}}, a triangle at z = 1; {RAY}").leak(),
        simple,
        others,
        answer: |nearest: &Code, (zs, ray): ([f64; 3], RayWithin)| {
            let world = world(1.0, &zs.map(|z| [0.0, 0.0, z])).ok()?;
            let (ray, within) = ray_within(ray);
            let (hit, number) = nearest(&world, &ray, within).unzip();
            Some(hit_answer(hit).and("number", number))
        },
    };
    questions.into()
}

/// The number of the triangle, and those of the spheres: none is a place in the list.
const TRIANGLE: usize = 23;
const SPHERES: [usize; 3] = [40, 7, 11];

/// Spheres, and a triangle whose corners have normals aslant, each with its number.
fn world(r: f64, centres: &[[f64; 3]]) -> Made<World<usize>> {
    let mut world = World::new(Color::BLACK)?.with(smooth_triangle(1.0)?, TRIANGLE);
    for (number, centre) in SPHERES.iter().zip(centres) {
        world = world.with(Sphere::new(point(*centre), r)?, *number);
    }
    Ok(world)
}
