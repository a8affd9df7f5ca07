//! Spheres and a smooth triangle in all orders, compared with the solution.

use a04_intersections::instruments::instrumented::{push_background, shaded};

use crate::prelude::*;

yours! { nearest }

type Code = fn(&World<usize>, &Ray, Interval) -> Option<(Hit, usize)>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("scene-5", |nearest: &Code, settings| {
            let world = world(0.5, &[[-1.0, 0.0, -3.0], [1.0, 0.0, -6.0]])?;
            let color = |ray: &Ray| {
                let hit = nearest(&world, ray, Interval::AHEAD);
                let hit = hit.inspect(|(hit, _)| shaded(ray, hit, || ()));
                push_background(Color::BLACK);
                hit.map_or(Color::BLACK, |_| Color::RED)
            };
            paint(&*scene_5()?.camera, &color, settings)
        }),
        ..Exercise::asked(|nearest: &Code, (zs, ray): ([f64; 3], RayWithin)| {
            let world = world(1.0, &zs.map(|z| [0.0, 0.0, z])).ok()?;
            let (ray, within) = ray_within(ray);
            let (hit, number) = nearest(&world, &ray, within).unzip();
            Some(hit_answer(hit).and("number", number))
        })
    }
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
