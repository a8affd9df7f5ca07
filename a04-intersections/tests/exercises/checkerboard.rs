//! Points in cubes and on their faces, compared with the solution.

use crate::prelude::*;

yours! { checkerboard }

type Code = fn(Point3, Normal3) -> Color;

pub fn exercise() -> Exercise<Code> {
    let mut simple = Vec::new();
    for middle in [
        [0.5; 3],
        [1.5, 0.5, 0.5],
        [0.5, -0.5, 0.5],
        [-1.5, 0.5, -0.5],
        [1_048_576.5, 0.5, 0.5],
        [-1_048_576.5, 0.5, 0.5],
        [-5_000_000_001.5, 0.5, 0.5],
        [5_000_000_000.5, 0.5, 0.5],
    ] {
        simple.push((middle, [0.0, 1.0, 0.0]));
    }
    simple.extend(beside_faces());
    let points = Questions {
        words: "p = {}, n = {}",
        simple,
        // On a face of a cube, up to rounding, with the normal of the face.
        others: random(|r| {
            let (mut p, mut n, axis) = (r.triple(9.0), [0.0; 3], r.below(3) as usize);
            p[axis] = p[axis].round() * (1.0 + r.between(-1.0, 1.0).round() * f64::EPSILON);
            n[axis] = if r.below(2) == 0 { 1.0 } else { -1.0 };
            (p, n)
        }),
        answer: |checkerboard: &Code, (p, n)| {
            checkerboard(point(p), vector(n).as_normal()).channels()
        },
    };
    Exercise {
        questions: points.into(),
        picture: Picture::own(|checkerboard: &Code, settings| {
            let eye = Eye {
                from: [3.0, 4.0, 7.0],
                to: [0.0, 0.6, 0.0],
            };
            eye.show(&floor_and_box()?, settings, &|_, p, n| {
                checkerboard(p, n) * 0.7 + Color::gray(0.15)
            })
        }),
        ..Exercise::default()
    }
}

/// Points in a cube, at several distances from the face that they look away from.
fn beside_faces() -> Vec<([f64; 3], [f64; 3])> {
    let mut points = Vec::new();
    for axis in 0..3 {
        for distance in [0.375, 0.25, 0.0625, 0.015_625] {
            for [face, side] in [[0.0, 1.0], [1.0, -1.0]] {
                let (mut p, mut n) = ([0.5; 3], [0.0; 3]);
                p[axis] = face + side * distance;
                n[axis] = side;
                points.push((p, n));
            }
        }
    }
    // Aslant above a face.
    points.push(([0.5, 0.0625, 0.5], [0.6, 0.8, 0.0]));
    points
}

fn floor_and_box() -> Made<World<Color>> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let cube = AxisAlignedBox::new(point([-2.0, 0.0, -2.0]), point([1.0, 2.0, 1.0]))?;
    Ok(World::new(Color::gray(0.1))?
        .with(floor, Color::WHITE)
        .with(cube, Color::WHITE))
}
