//! Turns about all axes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Vector3, f64) -> Made<Transform>) {
    check.compare(
        "axis {}, angle {}",
        [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -2.0, 0.0]].map(|axis| (axis, 1.0)),
        random(|r| (r.triple(5.0), r.between(-9.0, 9.0))),
        [rotation, yours],
        |rotation, (axis, angle)| {
            let turn = rotation(vector(axis), angle).ok()?;
            // No symmetric point, so that it turns about every axis.
            let turned = |by: Mat4x4| (by * vector([1.0, 2.0, 4.0])).to_glam().to_array();
            let there = Answer::named("(1, 2, 4) turned", turned(turn.matrix()));
            Some(there.and("turned back", turned(turn.inverse())))
        },
    );
    // Three corners of a cube around its diagonal, each turned a third.
    let wheel = || {
        let mut world = World::new(Color::gray(0.08))?;
        for (third, color) in [(0.0, Color::RED), (1.0, Color::GREEN), (2.0, Color::BLUE)] {
            let turn = yours(vector([1.0; 3]), TAU / 3.0 * third)?;
            let beam = AxisAlignedBox::new(point([0.3, -0.4, -0.4]), point([2.2, 0.4, 0.4]))?;
            world = world.with(Node::new(turn).with(beam), color * 0.6 + Color::gray(0.4));
        }
        Ok(world)
    };
    show_lit(check, wheel(), [4.0, 4.5, 5.0], [0.6; 3]);
}

variants! { check:
    yours => rotation;
    wrong "a turn about x leads from z down" => |k, angle| {
        rotation(Vector3::new(k.x(), -k.y(), k.z()), angle)
    };
    wrong "the arc tangent of x / z knows no quadrant" => |k, angle| {
        let side = k.z().signum();
        rotation(Vector3::new(side * k.x(), k.y(), side * k.z()), angle)
    };
    wrong "a turn is counterclockwise for an eye before the axis" => |axis, angle| rotation(axis, -angle);
}
