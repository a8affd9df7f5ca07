//! Rays in random worlds of mirrors, compared with the solution.

use crate::prelude::*;

yours! { trace }

type Code = fn(&ShadowedWorld, &Ray, u32) -> Color;

pub fn exercise() -> Exercise<Code> {
    // To the background, to the floor, which mirrors it, and to the triangle.
    let directions = [[4.0, 3.0, 0.0], [4.0, -3.0, 0.0], [0.0, -2.5, -8.0]];
    let mut simple = Vec::new();
    for depth in [1, 2, 0, 5] {
        for d in directions {
            let ball = ([0.0, 1.0, 0.0], 1.0);
            simple.push((ball, Color::new(0.5, 0.5, 1.0), [[0.0, 4.0, 4.0], d], depth));
        }
    }
    let rays = Questions {
        words: "a ball around {} of radius {}, everything mirrors {}, ray from and along {}, \
            depth {}",
        simple,
        others: random(|r| {
            let ball = (r.triple(3.0), r.between(0.2, 2.0));
            let [x, y, _] = r.triple(3.0);
            let [red, green, blue] = [(); 3].map(|()| r.between(0.1, 1.0));
            let reflection = Color::new(red, green, blue);
            // From before the objects to a place among them.
            let origin = [x, y.abs() + 0.1, 6.0];
            let [u, v, w] = r.triple(4.0);
            let direction = point([u / 2.0, v.abs(), w - 4.0]) - point(origin);
            (ball, reflection, [origin, array(direction)], r.below(7))
        }),
        answer: |trace: &Code, ((centre, radius), reflection, [o, d], depth): (_, _, [_; 2], _)| {
            let world = mirrors(centre, radius, reflection).ok()?;
            let ray = Ray::derived(point(o), unit(d));
            let is_asked = !is_bent(&world, &ray, depth);
            is_asked.then(|| trace(&world, &ray, depth).channels())
        },
    };
    Exercise {
        questions: all([rays.into(), between_two_mirrors()]),
        picture: Picture::scene("sphere", |trace: &Code, settings| {
            traced_picture(scenes::sphere()?, settings, |world, ray, depth| {
                trace(world, ray, depth)
            })
        }),
        ..Exercise::default()
    }
}

/// Whether a leaning normal reflects the ray into a triangle. The lesson's tracer bends it, which is
/// no part of this exercise.
fn is_bent(world: &ShadowedWorld, ray: &Ray, depth: u32) -> bool {
    let mut ray = *ray;
    for _ in 0..depth {
        let Some((hit, _)) = world.objects().hit(&ray, Interval::AHEAD) else {
            return false;
        };
        let direction = (-ray.direction()).reflected_on(hit.normal);
        if direction.dot(hit.geometric_normal) < 0.0 {
            return true;
        }
        ray = secondary_ray(&ray, &hit, direction);
    }
    false
}

/// Rays between two mirrors that are near to each other or far, and bright or dark.
fn between_two_mirrors() -> Vec<CodeQuestion<Code>> {
    let mut simple = Vec::new();
    for height in [1.0, 5e-7, 1e6] {
        for reflection in [
            Color::new(0.5, 0.25, 0.125),
            Color::new(0.1, 0.2, 0.05),
            Color::new(1.0, 0.0, 1e-6),
        ] {
            for depth in [2, 5, 9] {
                simple.push((height, reflection, depth));
            }
        }
    }
    let rays = Questions {
        words: "mirrors y = 0 and y = {}, both reflect {}, ray from half way along [0.6, 0.8, 0], \
            depth {}",
        simple,
        others: vec![],
        answer: |trace: &Code, (height, reflection, depth)| {
            let world = two_mirrors(height, reflection).ok()?;
            let origin = Point3::new(0.0, height / 2.0, 0.0);
            let ray = Ray::derived(origin, Vector3::new(0.6, 0.8, 0.0));
            Some(trace(&world, &ray, depth).channels())
        },
    };
    rays.into()
}
