//! Rotations about all axes, compared with the solution.

use crate::prelude::*;

yours! { rotation }

type Code = fn(Vector3, f64) -> Made<Transform>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [4.0, 4.5, 5.0],
        to: [0.6; 3],
    };
    Exercise {
        picture: lit(eye, wheel),
        ..Exercise::asked(|rotation: &Code, (axis, angle)| {
            let turn = rotation(vector(axis), angle).ok()?;
            // No symmetric point, so that it turns about every axis.
            let turned = |by: Mat4x4| array(by * vector([1.0, 2.0, 4.0]));
            Some(
                Answer::named("(1, 2, 4) turned", turned(turn.matrix()))
                    .and("turned back", turned(turn.inverse())),
            )
        })
    }
}

/// Three corners of a cube around its diagonal, each turned a third.
fn wheel(rotation: &Code) -> Made<World<Color>> {
    let mut world = World::new(Color::gray(0.08))?;
    for (third, color) in [(0.0, Color::RED), (1.0, Color::GREEN), (2.0, Color::BLUE)] {
        let turn = rotation(vector([1.0; 3]), TAU / 3.0 * third)?;
        let beam = AxisAlignedBox::new(point([0.3, -0.4, -0.4]), point([2.2, 0.4, 0.4]))?;
        world = world.with(Node::new(turn).with(beam), color * 0.6 + Color::gray(0.4));
    }
    Ok(world)
}
