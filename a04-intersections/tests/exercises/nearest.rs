//! Spheres and a smooth triangle in all orders, compared with the lesson's `World`.

use std::sync::Arc;

use crate::prelude::*;

pub fn check(
    check: &mut Check,
    nearest: impl Fn(&World<usize>, &Ray, Interval) -> Option<(Hit, usize)> + Sync,
) {
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let zs = order.map(|i| [-3.0, -6.0, -9.0][i]);
        let Ok(world) = world(zs) else { continue };
        let world = Arc::new(world);
        let objects = world.clone();
        let any = Own(move |ray: &Ray, i| objects.hit(ray, i).map(|(hit, _)| hit));
        let words = format!("spheres of radius 1 at z = {zs:?}, a triangle at z = 1; {RAY}");
        let found = |hit: Option<(Hit, usize)>| {
            let number = hit.map(|(_, number)| number);
            answer(hit.map(|(hit, _)| hit)).and("number", number)
        };
        let ahead = [
            [0.0, 0.0, 0.0],
            [0.0, 0.0, -6.0],
            [0.0, 0.0, 2.0],
            [2.0, 0.0, 0.0],
        ];
        let starts = [0.0, 4.5].into_iter();
        check.compare::<_, Answer, Answer>(
            &words,
            starts.flat_map(|min| ahead.map(|o| (o, [0.0, 0.0, -1.0], min, f64::INFINITY))),
            rays(&any),
            |input| {
                let (ray, within) = ray_within(input);
                found(world.hit(&ray, within).map(|(hit, number)| (hit, *number)))
            },
            |input| {
                let (ray, within) = ray_within(input);
                found(nearest(&world, &ray, within))
            },
        );
    }
    check.scene(&a04_intersections::stage(), "scene-5", |settings| {
        let View {
            camera,
            world: scene,
        } = scene_5()?;
        let (scene, mut world) = (Arc::new(scene), World::new(Color::BLACK)?);
        for number in 0..scene.objects().count() {
            let scene = scene.clone();
            let shape = Own(move |ray: &Ray, i| scene.objects().nth(number)?.0.hit(ray, i));
            world = world.with(shape, number);
        }
        let color = |ray: &Ray| {
            let (_, number) = nearest(&world, ray, Interval::AHEAD)?;
            Some(*scene.objects().nth(number)?.1)
        };
        render(
            &camera,
            |ray: &Ray| color(ray).unwrap_or(Color::BLACK),
            settings,
            &(),
        )
    });
}

/// Spheres, and a triangle whose corners have normals aslant, each with its number.
fn world(zs: [f64; 3]) -> Result<World<usize>, ArgumentError> {
    let mut world = World::new(Color::BLACK)?.with(smooth_triangle(1.0)?, 0);
    for (number, z) in (1..).zip(zs) {
        world = world.with(Sphere::new(Point3::new(0.0, 0.0, z), 1.0)?, number);
    }
    Ok(world)
}

/// All hits, each the nearest of its object.
fn hits(world: &World<usize>, ray: &Ray, within: Interval) -> Vec<(Hit, usize)> {
    let objects = world.objects();
    objects
        .filter_map(|(shape, number)| Some((shape.hit(ray, within)?, *number)))
        .collect()
}

fn first(hits: Vec<(Hit, usize)>) -> Option<(Hit, usize)> {
    hits.into_iter()
        .reduce(|a, b| if b.0.t < a.0.t { b } else { a })
}

/// The hit with its normals turned where this one of them looks along the ray.
fn turned(found: Option<(Hit, usize)>, ray: &Ray, by: fn(&Hit) -> Normal3) -> Option<(Hit, usize)> {
    let (mut hit, number) = found?;
    if by(&hit).dot(ray.direction()) > 0.0 {
        (hit.normal, hit.face) = (-hit.normal, -hit.face);
    }
    Some((hit, number))
}

pub const VARIANTS: &[Variant] = &[
    right("all hits, and then the first", |c| {
        check(c, |world, ray, i| {
            turned(first(hits(world, ray, i)), ray, |hit| hit.face)
        });
    }),
    wrong("not the first of the list, but the nearest", |c| {
        check(c, |world, ray, i| {
            turned(hits(world, ray, i).pop(), ray, |hit| hit.face)
        });
    }),
    wrong("a hit before the interval hides one in it", |c| {
        check(c, |world, ray, i| {
            let hit = first(hits(world, ray, Interval::AHEAD));
            turned(hit.filter(|(hit, _)| i.contains(hit.t)), ray, |hit| {
                hit.face
            })
        });
    }),
    wrong("the face, not the normal, says what is seen", |c| {
        check(c, |world, ray, i| {
            turned(first(hits(world, ray, i)), ray, |hit| hit.normal)
        });
    }),
];
