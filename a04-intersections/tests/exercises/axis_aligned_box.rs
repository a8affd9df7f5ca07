//! Boxes anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, Point3) -> Made<Shape>) {
    compare_boxes(check, &|lbf, run| boxed(AxisAlignedBox::new(lbf, run)), new);
    let [lbf, run] = [point([-0.5, 0.0, -0.5]), point([0.5, 1.0, 0.5])];
    scene(check, "scene-3", scene_3, new(lbf, run));
}

/// The slabs of all axes at once: a ray is in the box from the last entry to the first exit.
fn slabs(c: &mut Check, is_crossed: fn(f64, f64) -> bool) {
    check(c, &move |lbf, run| {
        own(move |ray: &Ray, within| {
            let (o, d) = (ray.origin().to_glam(), ray.direction().to_glam());
            let [a, b] = [lbf, run].map(|corner| (corner.to_glam() - o) / d);
            let (near, far) = (a.min(b).max_element(), a.max(b).min_element());
            let mut ends = [(near, a.min(b), -d), (far, a.max(b), d)].into_iter();
            let (t, axes, side) = ends.find(|(t, _, _)| within.contains(*t))?;
            let axis = (0..3).find(|axis| axes[*axis] == t)?;
            let mut normal = [0.0; 3];
            normal[axis] = side[axis].signum();
            is_crossed(near, far).then(|| Hit::new(t, vector(normal).as_normal()))
        })
    });
}

variants! { slabs:
    yours => &|lbf, run| shape::boxed(AxisAlignedBox::new(lbf, run));
    right "all axes at once" => |near, far| near <= far;
    wrong "edges belong to the box" => |near, far| near < far;
}
