//! Spheres along a ray in all orders, hits at the ends of intervals, and normals from
//! inside.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, Sphere, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::aimed::{BOUND, frame, perspective, point};

pub fn check(
    check: &mut Check,
    nearest: impl Fn(&World<usize>, &Ray, Interval) -> Option<(Hit, usize)> + Sync,
) {
    let mut random = Random::new(45);
    for order in [
        [0, 1, 2],
        [2, 1, 0],
        [1, 0, 2],
        [1, 2, 0],
        [0, 2, 1],
        [2, 0, 1],
    ] {
        let (o, [d, ..]) = (point(&mut random, 5.0), frame(&mut random));
        // Spheres of radius 1 around 3, 6 and 9: hit at 2, 5 and 8, left at 4, 7 and 10.
        let spheres = order.map(|i| o + d * (3.0 * f64::from(i + 1)));
        let Ok(world) = world(&spheres) else { continue };
        let number = |i: i32| order.iter().position(|k| *k == i).unwrap_or_default();
        let mut expect = |kind: &str, from: f64, within: Interval, exact: Option<(f64, usize)>| {
            let ray = Ray::derived(o + d * from, d);
            let got = nearest(&world, &ray, within);
            let words =
                format!("spheres 3, 6 and 9 steps along the ray, number {order:?} of the list");
            let (t, object) = (exact.map(|(t, _)| t), exact.map(|(_, object)| object));
            let got_t = got.map(|(hit, _)| hit.t);
            check.expect(
                format!("t {kind}; {words}"),
                t,
                Bound::Absolute(BOUND),
                got_t,
            );
            let got_object = got.map(|(_, object)| object);
            check.expect(
                format!("the object {kind}; {words}"),
                object,
                Bound::Equal,
                got_object,
            );
            if let (Some((hit, _)), true) = (got, exact.is_some()) {
                for (name, normal) in [("normal", hit.normal), ("face", hit.face)] {
                    let cosine = normal.dot(d);
                    let what = format!("the {name} against the ray, n · d, {kind}; {words}");
                    check.expect(what, -1.0, Bound::Absolute(BOUND), cosine);
                }
            }
        };
        expect(
            "of the nearest sphere",
            0.0,
            Interval::AHEAD,
            Some((2.0, number(0))),
        );
        expect(
            "from inside the first sphere",
            3.0,
            Interval::AHEAD,
            Some((1.0, number(0))),
        );
        let after = Interval {
            min: 4.5,
            max: f64::INFINITY,
        };
        expect(
            "as the interval begins at 4.5",
            0.0,
            after,
            Some((5.0, number(1))),
        );
        let between = Interval { min: 5.5, max: 6.5 };
        expect("between 5.5 and 6.5, inside a sphere", 0.0, between, None);
        expect(
            "as the interval ends at 1.5",
            0.0,
            Interval::before(1.5),
            None,
        );
        expect("behind all spheres", 11.0, Interval::AHEAD, None);
    }
    let empty = World::new(Color::BLACK).map(|world| {
        let ray = Ray::derived(Point3::ORIGIN, Vector3::new(1.0, 0.0, 0.0));
        nearest(&world, &ray, Interval::AHEAD).map(|(hit, _)| hit.t)
    });
    check.expect(
        "t in an empty world",
        None::<f64>,
        Bound::Equal,
        empty.ok().flatten(),
    );
    check.scene(&a04_intersections::stage(), "scene-5", |settings| {
        let camera = perspective(Point3::ORIGIN, Vector3::new(0.0, 0.0, -1.0))?;
        let world = World::new(Color::BLACK)?
            .with(Sphere::new(Point3::new(-1.0, 0.0, -3.0), 0.5)?, 0)
            .with(Sphere::new(Point3::new(1.0, 0.0, -6.0), 0.5)?, 1);
        let color = |ray: &Ray| match nearest(&world, ray, Interval::AHEAD) {
            Some(_) => Color::RED,
            None => Color::BLACK,
        };
        a03_rays_cameras::render(&camera, color, settings, &())
    });
}

/// Spheres of radius 1, each with its number in the list.
fn world(centres: &[Point3]) -> Result<World<usize>, ArgumentError> {
    let mut world = World::new(Color::BLACK)?;
    for (number, centre) in centres.iter().enumerate() {
        world = world.with(Sphere::new(*centre, 1.0)?, number);
    }
    Ok(world)
}
