//! Chains of steps, compared with the solution.

use crate::prelude::*;

yours! { chain }

type Code = fn(&[Step]) -> [Mat4x4; 2];

pub fn exercise() -> Exercise<Code> {
    let (turn, step) = (Step::Rotate(2, FRAC_PI_2), Step::Translate([2.0, 0.0, 0.0]));
    let p = [1.0, 0.0, 0.0];
    let chains = Questions {
        words: "chain {}, p = {}",
        simple: vec![
            (vec![], p),
            (vec![step], p),
            (vec![step, turn], p),
            (vec![turn, step], p),
            (vec![Step::Scale([1e-12, 1.0, 1e12]), turn], [1.0, 2.0, 3.0]),
            (vec![Step::Rotate(1, 1e-6), step], [1.0, 2.0, 3.0]),
            (
                vec![Step::Translate([1e-6, 1e6, 0.0]), turn],
                [1.0, 2.0, 3.0],
            ),
        ],
        others: random(|r| (Step::random(r), r.triple(3.0))),
        answer: |chain: &Code, (steps, p): (Vec<Step>, _)| {
            let [p, back] = chain(&steps).map(|matrix| array(matrix * point(p)));
            Answer::named("the matrix times p", p).and("the inverse times p", back)
        },
    };
    Exercise {
        questions: chains.into(),
        picture: BOX_SCENE.with(|chain: &Code, world| {
            let [_, inverse] = chain(&steps_of_box());
            Ok(world.with(under_inverse(upright_box()?, inverse), yellow()?))
        }),
        ..Exercise::default()
    }
}

/// A box under the transform with this inverse.
fn under_inverse(child: AxisAlignedBox, inverse: Mat4x4) -> impl Geometry {
    own(move |ray: &Ray, within| {
        let inner = Ray::derived(inverse * ray.origin(), inverse * ray.direction());
        let Hit { t, normal, .. } = child.hit(&inner, within)?;
        let n = inverse.transposed() * Vector3::from(normal);
        Some(Hit::new(t, n.normalized()?.as_normal()))
    })
}
