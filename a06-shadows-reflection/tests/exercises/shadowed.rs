//! Balls before, behind, beside and beyond lights, near and far.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere};
use a05_lighting::{Illumination, SingleColor};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::traced::{Objects, Tracer, aab, expect_scene, frame, point};

pub fn check(
    check: &mut Check,
    is_shadowed: impl Fn(&Objects, &Ray, &Hit, &Illumination) -> bool + Sync,
) {
    let mut random = Random::new(61);
    for distance in [4.0, 0.5, 100.0, f64::INFINITY, 7.0, 20.0] {
        let (p, [n, side, _]) = (point(&mut random, 5.0), frame(&mut random));
        // The light 30 degrees above the surface.
        let l = n * 0.5 + side * 0.75_f64.sqrt();
        let reach = if distance.is_finite() {
            distance
        } else {
            1000.0
        };
        let mut expect = |kind: &str, other: Option<Box<dyn Geometry>>, exact: bool| {
            let Ok((world, ray, hit)) = surface(p, n, side, other) else {
                return;
            };
            let light = Illumination {
                color: Color::WHITE,
                direction: l,
                distance,
            };
            let got = is_shadowed(&world, &ray, &hit, &light);
            let what = format!(
                "shadow, {kind}; surface at {} with normal {:.3}, light in the direction {:.3} at distance {distance}",
                p.to_glam(),
                n.to_glam(),
                l.to_glam()
            );
            check.expect(what, exact, Bound::Equal, got);
        };
        let ball = |centre: Point3, r: f64| -> Option<Box<dyn Geometry>> {
            Some(Box::new(Sphere::new(centre, r).ok()?))
        };
        let radius = 0.1 * reach;
        expect("nothing but the surface itself", None, false);
        expect(
            "a ball half way to the light",
            ball(p + l * (0.5 * reach), radius),
            true,
        );
        expect(
            "a ball near the surface",
            ball(p + l * (0.15 * reach), radius),
            true,
        );
        expect(
            "a ball just before the light",
            ball(p + l * (0.85 * reach), radius),
            true,
        );
        expect("a ball around light and point", ball(p, 0.5 * reach), true);
        expect(
            "a ball on the other side of the surface",
            ball(p + l * (-0.5 * reach), radius),
            false,
        );
        expect(
            "a ball beside the way",
            ball(p + l * (0.5 * reach) + n * (0.2 * reach), radius),
            false,
        );
        let is_endless = distance.is_infinite();
        expect(
            "a ball beyond the light",
            ball(p + l * (1.5 * reach), radius),
            is_endless,
        );
        if !is_endless {
            let ceiling = Plane::new(p + l * distance, n.as_normal()).ok();
            let ceiling = ceiling.map(|plane| Box::new(plane) as Box<dyn Geometry>);
            expect("the ceiling that the lamp is fixed to", ceiling, false);
        }
    }
    expect_scene(check, "aab", aab, |world, ray, depth| {
        Tracer {
            is_shadowed: &is_shadowed,
            ..Tracer::new(world)
        }
        .trace(ray, depth)
    });
}

/// A surface through `p`, perhaps another object, and the hit at `p`.
fn surface(
    p: Point3,
    n: Vector3,
    side: Vector3,
    other: Option<Box<dyn Geometry>>,
) -> Result<(Objects, Ray, Hit), ArgumentError> {
    let plane = Plane::new(p, n.as_normal())?;
    let ray = Ray::derived(p + n * 3.0 - side * 2.0, side * 0.5 - n * 0.75);
    let hit = plane
        .hit(&ray, Interval::AHEAD)
        .unwrap_or_else(|| Hit::new(4.0, n.as_normal()));
    let mut world =
        Objects::new(Color::BLACK)?.with(plane, Box::new(SingleColor::new(Color::WHITE)?));
    if let Some(other) = other {
        world = world.with(other, Box::new(SingleColor::new(Color::WHITE)?));
    }
    Ok((world, ray, hit))
}
