//! Chains of steps, compared with the lesson's `Transform`.

use std::f64::consts::FRAC_PI_2;

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
    locked_scene(check, "box-transformations", 10.0, || {
        let (lbf, run) = (Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
        let child = AxisAlignedBox::new(lbf, run)?;
        let moved = Own(move |ray: &Ray, within: Interval| {
            let inner = Ray::derived(i * ray.origin(), i * ray.direction());
            let Hit { t, normal, .. } = child.hit(&inner, within)?;
            let n = i.transposed() * Vector3::from(normal);
            Some(Hit::new(t, n.normalized()?.as_normal()))
        });
        Ok(lit_from(ABOVE, false, 0.25)?.with(moved, Box::new(Lambert::new(Color::YELLOW)?)))
    });
}

/// The product of the matrices of steps, from the first to the last or back.
fn product(steps: &[Step], matrix: fn(Step) -> Mat4x4, is_forward: bool) -> Mat4x4 {
    let matrices = steps.iter().map(|step| matrix(*step));
    matrices.fold(
        Mat4x4::IDENTITY,
        |a, b| if is_forward { a * b } else { b * a },
    )
}

fn variant(c: &mut Check, [forward, back]: [bool; 2]) {
    check(c, |steps| {
        [
            product(steps, Step::matrix, forward),
            product(steps, Step::inverse, back),
        ]
    });
}

pub const VARIANTS: &[Variant] = &[
    right("two products", |c| variant(c, [true, false])),
    wrong("the last step is applied first", |c| {
        variant(c, [false, true])
    }),
    wrong("the last step is undone last", |c| variant(c, [true, true])),
    wrong("only a turn is undone by its transpose", |c| {
        check(c, |steps| {
            let matrix = product(steps, Step::matrix, true);
            [matrix, matrix.transposed()]
        });
    }),
];
