//! Colours in fog, thick and thin, compared with the solution.

use crate::prelude::*;
use crate::solutions::fogged::fogged as solution;

pub fn check(check: &mut Check, fogged: impl Fn(Color, Color, f64, f64) -> Color + Sync) {
    let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let cases = [
        (1.0, 0.0),
        (0.0, 2.0),
        (1.0, 1.0),
        (1.0, f64::INFINITY),
        (0.0, f64::INFINITY),
    ];
    check.compare(
        "colour {}, fog {}, density {}, distance {}",
        cases.map(|(density, distance)| (red, blue, density, distance)),
        random(|r| {
            (
                channels(r),
                channels(r),
                r.between(0.0, 0.5),
                r.between(0.0, 9.0),
            )
        }),
        |(c, f, density, t)| solution(color(c), color(f), density, t).channels(),
        |(c, f, density, t)| fogged(color(c), color(f), density, t).channels(),
    );
    show(
        check,
        [[-3.0, 2.5, 6.0], [0.5, 0.7, -4.0]],
        row(),
        |world, ray| {
            let fogged = |color, t| fogged(color, Color::new(0.7, 0.75, 0.8), 0.08, t);
            let nearest = world.hit(ray, Interval::AHEAD);
            nearest.map_or(fogged(world.background(), f64::INFINITY), |(hit, color)| {
                fogged(*color * f64::midpoint(1.0, hit.normal.y()), hit.t)
            })
        },
    );
}

fn row() -> Result<World<Color>, ArgumentError> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let world = World::new(Color::new(0.1, 0.2, 0.5))?.with(floor, Color::new(0.3, 0.35, 0.2));
    (0..9).try_fold(world, |world, k| {
        let ball = Sphere::new(Point3::new(0.0, 1.0, -4.0 * f64::from(k)), 1.0)?;
        Ok(world.with(ball, Color::new(0.9, 0.2, 0.1)))
    })
}

/// The mixture by the share that is left of the colour.
fn mixed(c: &mut Check, left: fn(f64, f64) -> f64) {
    check(c, |color, fog, density, distance| {
        let left = left(density, distance);
        color * left + fog * (1.0 - left)
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("without fog, 0 times infinity is not a number", |c| {
        mixed(c, |density, distance| libm::exp(-density * distance));
    }),
    wrong("each metre takes a share of what is left", |c| {
        mixed(c, |density, t| {
            if density == 0.0 {
                1.0
            } else {
                (1.0 - density * t).max(0.0)
            }
        });
    }),
    wrong("the fog adds its own colour", |c| {
        check(c, |color, _, density, t| {
            solution(color, Color::BLACK, density, t)
        });
    }),
];
