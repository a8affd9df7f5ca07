//! Spheres and a smooth triangle in all orders, compared with the lesson's `World`.

use a04_intersections::instruments::recorded::{push_background, shaded};

use crate::prelude::*;

pub fn nearest(world: &World<usize>, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
    world.hit(ray, within).map(|(hit, number)| (hit, *number))
}

type Nearest = fn(&World<usize>, &Ray, Interval) -> Option<(Hit, usize)>;

pub fn check(check: &mut Check, yours: Nearest) {
    let ahead = [0.0, 4.5, 7.5].map(|min| ([0.0; 3], [0.0, 0.0, -1.0], min, 99.0));
    let orders = [[-3.0, -6.0, -9.0], [-9.0, -6.0, -3.0], [-6.0, -9.0, -3.0]];
    let rays = world(1.0, &orders[0].map(|z| [0.0, 0.0, z])).map_or(Vec::new(), |world| {
        rays(&Own(move |ray: &Ray, i| Some(nearest(&world, ray, i)?.0)))
    });
    let with = |order| rays.iter().map(move |ray| (order, *ray));
    check.compare(
        &format!("spheres of radius 1 at z = {{}}, a triangle at z = 1; {RAY}"),
        orders.into_iter().flat_map(|zs| ahead.map(|ray| (zs, ray))),
        orders.into_iter().flat_map(with),
        [nearest, yours],
        |nearest, (zs, ray)| {
            let world = world(1.0, &zs.map(|z| [0.0, 0.0, z])).ok()?;
            let (ray, within) = ray_within(ray);
            let (hit, number) = nearest(&world, &ray, within).unzip();
            Some(answer(hit).and("number", number))
        },
    );
    check.scene(&a04_intersections::stage(), "scene-5", |settings| {
        let world = world(0.5, &[[-1.0, 0.0, -3.0], [1.0, 0.0, -6.0]])?;
        let color = |ray: &Ray| {
            let hit = yours(&world, ray, Interval::AHEAD);
            let hit = hit.inspect(|(hit, _)| shaded(ray, hit, || ()));
            push_background(Color::BLACK);
            hit.map_or(Color::BLACK, |_| Color::RED)
        };
        paint(&*scene_5()?.camera, &color, settings)
    });
}

/// Spheres, and a triangle whose corners have normals aslant, each with its number.
fn world(r: f64, centres: &[[f64; 3]]) -> Made<World<usize>> {
    let mut world = World::new(Color::BLACK)?.with(smooth_triangle(1.0)?, 0);
    for (number, centre) in (1..).zip(centres) {
        world = world.with(Sphere::new(point(*centre), r)?, number);
    }
    Ok(world)
}

/// All hits, each the nearest of its object.
fn hits(world: &World<usize>, ray: &Ray, within: Interval) -> impl Iterator<Item = (Hit, usize)> {
    let objects = world.objects();
    objects.filter_map(move |(shape, number)| Some((shape.hit(ray, within)?, *number)))
}

variants! { check:
    yours => nearest;
    right "all hits, and then the first" => |world, ray, i| {
        let first = hits(world, ray, i).min_by(|(a, _), (b, _)| a.t.total_cmp(&b.t));
        first.map(|(hit, number)| (turned(hit, hit.face, ray), number))
    };
    wrong "the nearest counts, not the last" => |world, ray, i| {
        let last = hits(world, ray, i).last();
        last.map(|(hit, number)| (turned(hit, hit.face, ray), number))
    };
    wrong "a hit before the interval hides one in it" => |world, ray, i| {
        nearest(world, ray, Interval::AHEAD).filter(|(hit, _)| i.contains(hit.t))
    };
    wrong "the face, not the normal, says what is seen" => |world, ray, i| {
        let (hit, number) = nearest(world, ray, i)?;
        Some((turned(hit, hit.normal, ray), number))
    };
}
