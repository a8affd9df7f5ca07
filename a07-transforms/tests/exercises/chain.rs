//! Chains of steps, compared with the lesson's `Transform`.

use crate::prelude::*;
use crate::solutions::chain::chain as lesson;

pub fn check(check: &mut Check, chain: impl Fn(&[Step]) -> [Mat4x4; 2]) {
    let applied = |matrices: [Mat4x4; 2], p| {
        let [p, back] = matrices.map(|matrix| (matrix * point(p)).to_glam().to_array());
        Answer::named("the matrix times p", p).and("the inverse times p", back)
    };
    let (turn, step) = (Step::Rotate(2, FRAC_PI_2), Step::Translate([2.0, 0.0, 0.0]));
    let simple = [vec![], vec![step], vec![step, turn], vec![turn, step]];
    check.compare(
        "chain {}, p = {}",
        simple.map(|steps| (steps, [1.0, 0.0, 0.0])),
        random(|r| (Step::random(r), r.triple(3.0))),
        |(steps, p)| applied(lesson(&steps), p),
        |(steps, p)| applied(chain(&steps), p),
    );
    let [_, i] = chain(&steps_of_box());
    box_scene(check, |child| {
        Own(move |ray: &Ray, within: Interval| {
            let inner = Ray::derived(i * ray.origin(), i * ray.direction());
            let Hit { t, normal, .. } = child.hit(&inner, within)?;
            let n = i.transposed() * Vector3::from(normal);
            Some(Hit::new(t, n.normalized()?.as_normal()))
        })
    });
}

fn product(factors: impl Iterator<Item = Mat4x4>) -> Mat4x4 {
    factors.fold(Mat4x4::IDENTITY, |a, b| a * b)
}

pub const VARIANTS: &[Variant] = &[
    right("two products", |c| {
        check(c, |steps| {
            let back = steps.iter().rev().map(|step| step.inverse());
            [
                product(steps.iter().map(|step| step.matrix())),
                product(back),
            ]
        });
    }),
    wrong("the last step is applied first", |c| {
        check(c, |steps| {
            lesson(&steps.iter().rev().copied().collect::<Vec<_>>())
        });
    }),
    wrong("the last step is undone last", |c| {
        check(c, |steps| {
            [
                lesson(steps)[0],
                product(steps.iter().map(|step| step.inverse())),
            ]
        });
    }),
    wrong("only a turn is undone by its transpose", |c| {
        check(c, |steps| {
            let [matrix, _] = lesson(steps);
            [matrix, matrix.transposed()]
        });
    }),
];
