//! Rotations about all axes, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { rotation => std::sync::Arc::new(rotation) }

type Code = Arc<dyn Fn(Vector3, f64) -> Made<Transform> + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let rotations = Questions {
        words: "axis {}, angle {}".into(),
        simple: vec![
            ([0.0, 0.0, 1.0], 1.0),
            ([1.0, 0.0, 0.0], 1.0),
            ([0.0, -2.0, 0.0], 1.0),
            ([0.0, 0.0, -2.0], 1.0),
            ([0.0, 0.0, 0.0], 1.0),
        ],
        others: random(|r| (r.triple(5.0), r.between(-9.0, 9.0))),
        answer: |rotation: &Code, (axis, angle)| {
            let turn = rotation(vector(axis), angle).ok()?;
            // No symmetric point, so that it turns about every axis.
            let turned = |by: Mat4x4| (by * vector([1.0, 2.0, 4.0])).to_glam().to_array();
            Some(
                Answer::named("(1, 2, 4) turned", turned(turn.matrix()))
                    .and("turned back", turned(turn.inverse())),
            )
        },
    };
    let eye = Eye {
        from: [4.0, 4.5, 5.0],
        to: [0.6; 3],
    };
    Exercise {
        questions: vec![rotations.into()],
        picture: lit(eye, wheel),
        wrong: vec![
            Other::from_right("a turn about x leads from z down", |right| {
                Arc::new(move |k, angle| right(Vector3::new(k.x(), -k.y(), k.z()), angle))
            }),
            Other::from_right("the arc tangent of x / z knows no quadrant", |right| {
                Arc::new(move |k, angle| {
                    let side = k.z().signum();
                    right(Vector3::new(side * k.x(), k.y(), side * k.z()), angle)
                })
            }),
            Other::from_right(
                "a turn is counterclockwise for an eye before the axis",
                |right| Arc::new(move |axis, angle| right(axis, -angle)),
            ),
        ],
        ..Exercise::default()
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
