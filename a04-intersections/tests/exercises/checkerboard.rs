//! Points in cubes and on their faces, compared with the solution.

use crate::prelude::*;
use crate::solutions::checkerboard::checkerboard as solution;

pub fn check(check: &mut Check, checkerboard: impl Fn(Point3, Normal3) -> Color + Sync) {
    let cubes = [
        [0.5; 3],
        [1.5, 0.5, 0.5],
        [0.5, -0.5, 0.5],
        [-1.5, 0.5, -0.5],
    ];
    let name = |color| match color {
        Color::WHITE => "white".to_owned(),
        Color::BLACK => "black".to_owned(),
        other => format!("{other:?}"),
    };
    check.compare(
        "p = {}, n = {}",
        cubes.map(|middle| (middle, [0.0, 1.0, 0.0])),
        // On a face of a cube, up to rounding, with the normal of the face.
        random(|r| {
            let (mut p, mut n, axis) = (r.triple(9.0), [0.0; 3], r.below(3) as usize);
            p[axis] = p[axis].round() * (1.0 + r.between(-1.0, 1.0).round() * f64::EPSILON);
            n[axis] = if r.below(2) == 0 { 1.0 } else { -1.0 };
            (p, n)
        }),
        |(p, n)| Answer::words(name(solution(point(p), vector(n).as_normal()))),
        |(p, n)| Answer::words(name(checkerboard(point(p), vector(n).as_normal()))),
    );
    let (eye, at) = ([3.0, 4.0, 7.0], [0.0, 0.6, 0.0]);
    show_world(check, floor_and_box(), eye, at, |(), p, n| {
        checkerboard(p, n) * 0.7 + Color::gray(0.15)
    });
}

fn floor_and_box() -> Result<World<()>, ArgumentError> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let (lbf, run) = (Point3::new(-2.0, 0.0, -2.0), Point3::new(1.0, 2.0, 1.0));
    let world = World::new(Color::gray(0.1))?.with(floor, ());
    Ok(world.with(AxisAlignedBox::new(lbf, run)?, ()))
}

/// White where this number of the point just below the surface is even.
fn variant(c: &mut Check, number: fn([f64; 3]) -> f64) {
    check(c, |p, n| {
        let below = p - Vector3::from(n) * 1e-6;
        let is_even = number(below.to_glam().to_array()) == 0.0;
        if is_even { Color::WHITE } else { Color::BLACK }
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("a cast cuts off, so -0.5 and 0.5 are both in cube 0", |c| {
        variant(c, |p| {
            p.map(|x| x as i64).iter().sum::<i64>().rem_euclid(2) as f64
        });
    }),
    wrong(
        "the remainder of a negative number is negative: -3 % 2 is -1",
        |c| {
            variant(c, |p| {
                (p.map(f64::floor).iter().sum::<f64>() % 2.0).max(0.0)
            });
        },
    ),
    wrong(
        "on a face, rounding chooses the cube: look just below",
        |c| {
            check(c, |p, _| solution(p, Normal3::new(0.0, 0.0, 0.0)));
        },
    ),
    wrong("below the surface is against the normal", |c| {
        check(c, |p, n| solution(p, -n))
    }),
];
