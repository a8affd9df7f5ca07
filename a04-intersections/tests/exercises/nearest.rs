//! Spheres and a smooth triangle in all orders, compared with the lesson's `World`.

use crate::prelude::*;

pub fn check(
    check: &mut Check,
    nearest: impl Fn(&World<usize>, &Ray, Interval) -> Option<(Hit, usize)> + Sync,
) {
    let found = |hit: Option<(Hit, usize)>| {
        let (hit, number) = hit.unzip();
        answer(hit).and("number", number)
    };
    let ahead = [0.0, 4.5, 7.5].map(|min| ([0.0; 3], [0.0, 0.0, -1.0], min, 99.0));
    let orders = [[-3.0, -6.0, -9.0], [-9.0, -6.0, -3.0], [-6.0, -9.0, -3.0]];
    let rays = world(orders[0]).map_or(Vec::new(), |world| {
        rays(&Own(move |ray: &Ray, i| {
            world.hit(ray, i).map(|(hit, _)| hit)
        }))
    });
    check.compare(
        &format!("spheres of radius 1 at z = {{}}, a triangle at z = 1; {RAY}"),
        orders.into_iter().flat_map(|zs| ahead.map(|ray| (zs, ray))),
        orders
            .into_iter()
            .flat_map(|zs| rays.iter().map(move |ray| (zs, *ray))),
        |(zs, ray)| {
            let (world, (ray, within)) = (world(zs).ok()?, ray_within(ray));
            Some(found(
                world.hit(&ray, within).map(|(hit, number)| (hit, *number)),
            ))
        },
        |(zs, ray)| {
            let (ray, within) = ray_within(ray);
            Some(found(nearest(&world(zs).ok()?, &ray, within)))
        },
    );
    check.scene(&a04_intersections::stage(), "scene-5", |settings| {
        let [left, right] = [(-1.0, -3.0), (1.0, -6.0)].map(|(x, z)| Point3::new(x, 0.0, z));
        let world = World::new(Color::BLACK)?.with(Sphere::new(left, 0.5)?, 0);
        let world = world.with(Sphere::new(right, 0.5)?, 1);
        let color = |ray: &Ray| match nearest(&world, ray, Interval::AHEAD) {
            Some(_) => Color::RED,
            None => Color::BLACK,
        };
        render(&scene_5()?.camera, color, settings, &())
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
