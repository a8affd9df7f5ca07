//! Boxes anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Point3) -> Result<G, ArgumentError>,
) {
    compare_boxes(check, AxisAlignedBox::new, &new);
    let [lbf, run] = [point([-0.5, 0.0, -0.5]), point([0.5, 1.0, 0.5])];
    scene(check, "scene-3", scene_3, new(lbf, run));
}

/// A ray is in the box where it is in all slabs: from the last entry, with its axis, to the
/// first exit. Rays parallel to a slab are never in it, or always.
fn variant(c: &mut Check, is_crossed: fn(f64, f64) -> bool) {
    check(c, move |lbf, run| {
        own(move |ray: &Ray, within| {
            let [o, lbf, run] = [ray.origin(), lbf, run].map(Point3::to_glam);
            let d = ray.direction().to_glam();
            let (mut entries, mut exits) = (Vec::new(), Vec::new());
            for axis in 0..3 {
                let [a, b] = [lbf, run].map(|corner| (corner[axis] - o[axis]) / d[axis]);
                if d[axis] != 0.0 {
                    entries.push((a.min(b), axis, -d[axis]));
                    exits.push((a.max(b), axis, d[axis]));
                } else if o[axis] < lbf[axis] || o[axis] > run[axis] {
                    return None;
                }
            }
            let near = entries.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
            let far = exits.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
            let mut ends = [near, far]
                .into_iter()
                .filter(|_| is_crossed(near.0, far.0));
            let (t, axis, side) = ends.find(|(t, _, _)| within.contains(*t))?;
            let mut normal = [0.0; 3];
            normal[axis] = side.signum();
            Some(Hit::new(t, vector(normal).as_normal()))
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("parallel slabs apart", |c| {
        variant(c, |near, far| near <= far)
    }),
    wrong("edges belong to the box", |c| {
        variant(c, |near, far| near < far)
    }),
    wrong("beside the box, the exit comes before the entry", |c| {
        variant(c, |_, _| true)
    }),
];
