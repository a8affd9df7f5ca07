//! Points in cubes and on their faces, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Point3, Normal3) -> Color) {
    let cubes = [[0, 0, 0], [1, 0, 0], [0, -1, 0], [-2, 0, -1]];
    let middles = cubes.map(|cube| cube.map(|x| f64::from(x) + 0.5));
    check.compare(
        "p = {}, n = {}",
        middles.map(|middle| (middle, [0.0, 1.0, 0.0])),
        // On a face of a cube, up to rounding, with the normal of the face.
        random(|r| {
            let (mut p, mut n, axis) = (r.triple(9.0), [0.0; 3], r.below(3) as usize);
            p[axis] = p[axis].round() * (1.0 + r.between(-1.0, 1.0).round() * f64::EPSILON);
            n[axis] = if r.below(2) == 0 { 1.0 } else { -1.0 };
            (p, n)
        }),
        [checkerboard, yours],
        |checkerboard, (p, n)| checkerboard(point(p), vector(n).as_normal()).channels(),
    );
    let (eye, at) = ([3.0, 4.0, 7.0], [0.0, 0.6, 0.0]);
    show_world(check, floor_and_box(), eye, at, &|_, p, n| {
        yours(p, n) * 0.7 + Color::gray(0.15)
    });
}

fn floor_and_box() -> Made<World<Color>> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let cube = AxisAlignedBox::new(point([-2.0, 0.0, -2.0]), point([1.0, 2.0, 1.0]))?;
    Ok(World::new(Color::gray(0.1))?
        .with(floor, Color::WHITE)
        .with(cube, Color::WHITE))
}

variants! { check:
    yours => checkerboard;
    wrong "a cast cuts off: -0.5 and 0.5 become 0" => |p, n| {
        let below = p - Vector3::from(n) * 1e-6;
        checkerboard(Point3::from_glam(below.to_glam().trunc()), NONE)
    };
    wrong "on a face, rounding chooses the cube" => |p, _| checkerboard(p, NONE);
    wrong "below the surface is against the normal" => |p, n| checkerboard(p, -n);
}

const NONE: Normal3 = Normal3::new(0.0, 0.0, 0.0);
