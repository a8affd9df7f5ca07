//! Turns about all axes, compared with the solution.

use crate::prelude::*;
use crate::solutions::rotation::rotation as solution;

type Turn = Result<Transform, ArgumentError>;

pub fn check(check: &mut Check, rotation: impl Fn(Vector3, f64) -> Turn) {
    let axes = || [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(vector);
    let turned = |turn: Turn| {
        let turn = turn.ok()?;
        let [[x, y, z], [back, ..]] = [turn.matrix(), turn.inverse()]
            .map(|matrix| axes().map(|axis| (matrix * axis).to_glam().to_array()));
        let turned = Answer::named("x turned", x).and("y turned", y);
        Some(turned.and("z turned", z).and("x turned back", back))
    };
    check.compare(
        "axis {}, angle {}",
        [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -2.0, 0.0]].map(|axis| (axis, 1.0)),
        random(|r| (r.triple(5.0), r.between(-9.0, 9.0))),
        |(axis, angle)| turned(solution(vector(axis), angle)),
        |(axis, angle)| turned(rotation(vector(axis), angle)),
    );

    // Three corners of a cube around its diagonal, each turned a third.
    let wheel = || {
        let mut world = World::new(Color::gray(0.08))?;
        for (third, color) in [(0.0, Color::RED), (1.0, Color::GREEN), (2.0, Color::BLUE)] {
            let angle = std::f64::consts::TAU / 3.0 * third;
            let turn = rotation(Vector3::new(1.0, 1.0, 1.0), angle)?;
            let (lbf, run) = (Point3::new(0.3, -0.4, -0.4), Point3::new(2.2, 0.4, 0.4));
            let node = Node::new(turn).with(AxisAlignedBox::new(lbf, run)?);
            world = world.with(node, color * 0.6 + Color::gray(0.4));
        }
        Ok(world)
    };
    show_lit(check, wheel(), [4.0, 4.5, 5.0], [0.6; 3]);
}

/// With other angles of the axis around y and up from the plane.
fn variant(c: &mut Check, angles: fn(Vector3) -> [f64; 2], sign: f64) {
    check(c, move |axis, angle| {
        let [around, up] = angles(axis.unit("axis")?);
        let to_z = Transform::IDENTITY.rotate_y(around)?.rotate_x(-up)?;
        to_z.rotate_z(sign * angle)?.rotate_x(up)?.rotate_y(-around)
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("a turn about x leads from z down", |c| {
        variant(c, |k| [libm::atan2(k.x(), k.z()), -libm::asin(k.y())], 1.0);
    }),
    wrong(
        "an arc tangent of a quotient does not know the quadrant",
        |c| {
            variant(c, |k| [libm::atan(k.x() / k.z()), libm::asin(k.y())], 1.0);
        },
    ),
    wrong(
        "counterclockwise, seen by an eye to which the axis points",
        |c| {
            variant(c, |k| [libm::atan2(k.x(), k.z()), libm::asin(k.y())], -1.0);
        },
    ),
];
