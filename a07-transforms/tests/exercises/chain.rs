//! Chains of steps, compared with the lesson's `Transform`.

use crate::prelude::*;

pub fn chain(steps: &[Step]) -> [Mat4x4; 2] {
    let transform = transform(steps);
    [transform.matrix(), transform.inverse()]
}

pub fn check(check: &mut Check, yours: fn(&[Step]) -> [Mat4x4; 2]) {
    let (turn, step) = (Step::Rotate(2, FRAC_PI_2), Step::Translate([2.0, 0.0, 0.0]));
    let simple = [vec![], vec![step], vec![step, turn], vec![turn, step]];
    check.compare(
        "chain {}, p = {}",
        simple.map(|steps| (steps, [1.0, 0.0, 0.0])),
        random(|r| (Step::random(r), r.triple(3.0))),
        [chain, yours],
        |chain, (steps, p)| {
            let [p, back] = chain(&steps).map(|matrix| (matrix * point(p)).to_glam().to_array());
            Answer::named("the matrix times p", p).and("the inverse times p", back)
        },
    );
    let [_, i] = yours(&steps_of_box());
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

variants! { check:
    yours => chain;
    right "two products" => |steps| {
        let there = steps.iter().map(|step| step.matrix());
        let back = steps.iter().rev().map(|step| step.inverse());
        [product(there), product(back)]
    };
    wrong "the last step is applied first" => |steps| {
        chain(&steps.iter().rev().copied().collect::<Vec<_>>())
    };
    wrong "the last step is undone last" => |steps| {
        let back = steps.iter().map(|step| step.inverse());
        [chain(steps)[0], product(back)]
    };
    wrong "only a turn is undone by its transpose" => |steps| {
        let [matrix, _] = chain(steps);
        [matrix, matrix.transposed()]
    };
}
