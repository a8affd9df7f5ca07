//! Chains of steps, compared with the solution.

use crate::prelude::*;

yours! { chain }

type Code = fn(&[Step]) -> [Mat4x4; 2];

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: BOX_SCENE.with(|chain: &Code, world| {
            let [_, inverse] = chain(&steps_of_box());
            Ok(world.with(under_inverse(upright_box()?, inverse), yellow()?))
        }),
        ..Exercise::asked(|chain: &Code, (steps, p): (Vec<Step>, _)| {
            let [p, back] = chain(&steps).map(|matrix| array(matrix * point(p)));
            Answer::named("the matrix times p", p).and("the inverse times p", back)
        })
    }
}

/// A box under the transform with this inverse.
fn under_inverse(child: AxisAlignedBox, inverse: Mat4x4) -> impl Geometry {
    OwnShape(move |ray: &Ray, within: Interval| {
        let inner = Ray::derived(inverse * ray.origin(), inverse * ray.direction());
        let Hit { t, normal, .. } = child.hit(&inner, within)?;
        let n = inverse.transposed() * Vector3::from(normal);
        Some(Hit::new(t, n.normalized()?.as_normal()))
    })
}
