//! Boxes anywhere, compared with the lesson's.

use crate::prelude::*;

yours! { AxisAlignedBox => new_shape(|(lbf, run)| AxisAlignedBox::new(point(lbf), point(run))) }

type Code = NewShape<Corners>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-3", scene_3, ([-0.5, 0.0, -0.5], [0.5, 1.0, 0.5])),
        right: vec![Other::new(
            "all axes at once",
            slabs(|near, far| near <= far),
        )],
        wrong: vec![Other::new(
            "edges belong to the box",
            slabs(|near, far| near < far),
        )],
        ..shapes(BOXES)
    }
}

/// The slabs of all axes at once: a ray is in the box from the last entry to the first exit.
fn slabs(is_crossed: fn(f64, f64) -> bool) -> Code {
    new_shape(move |(lbf, run)| {
        Ok(own(move |ray: &Ray, within| {
            let (o, d) = (ray.origin().to_glam(), ray.direction().to_glam());
            let [a, b] = [lbf, run].map(|corner| (point(corner).to_glam() - o) / d);
            let (near, far) = (a.min(b).max_element(), a.max(b).min_element());
            let mut ends = [(near, a.min(b), -d), (far, a.max(b), d)].into_iter();
            let (t, axes, side) = ends.find(|(t, _, _)| within.contains(*t))?;
            let axis = (0..3).find(|axis| axes[*axis] == t)?;
            let mut normal = [0.0; 3];
            normal[axis] = side[axis].signum();
            is_crossed(near, far).then(|| Hit::new(t, vector(normal).as_normal()))
        }))
    })
}
