//! Wrong solutions.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval};
use testing::exercise::{Check, Wrong};

use crate::axis_aligned_box;

type Formula = fn([Point3; 2], &Ray, Interval) -> Option<Hit>;

#[derive(Debug)]
struct Box3([Point3; 2], Formula);

impl Geometry for Box3 {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.1)(self.0, ray, within)
    }
}

fn check(check: &mut Check, formula: Formula) {
    axis_aligned_box::check(check, |lbf, run| Ok(Box3([lbf, run], formula)));
}

/// Entry into and exit out of the slab of each axis.
fn slabs([lbf, run]: [Point3; 2], ray: &Ray) -> [[f64; 2]; 3] {
    let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
    let (a, b) = ((lbf.to_glam() - o) / d, (run.to_glam() - o) / d);
    [0, 1, 2].map(|axis| [a[axis].min(b[axis]), a[axis].max(b[axis])])
}

fn normal(axis: usize, sign: f64) -> Normal3 {
    let mut n = [0.0; 3];
    n[axis] = sign.signum();
    Normal3::from_glam(n.into())
}

/// The last entry and its axis, and the first exit.
fn entry(corners: [Point3; 2], ray: &Ray) -> Option<(f64, usize)> {
    let slabs = slabs(corners, ray);
    let last = (0..3).max_by(|a, b| slabs[*a][0].total_cmp(&slabs[*b][0]))?;
    let exit = slabs
        .iter()
        .map(|slab| slab[1])
        .fold(f64::INFINITY, f64::min);
    (slabs[last][0] <= exit).then_some((slabs[last][0], last))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "only the entry",
        says: "from inside",
        check: |c| {
            check(c, |corners, ray, within| {
                let (t, axis) = entry(corners, ray)?;
                let sign = -ray.direction().to_glam()[axis];
                within.contains(t).then(|| Hit::new(t, normal(axis, sign)))
            });
        },
    },
    Wrong {
        mistake: "the first entry instead of the last",
        says: "t, from outside",
        check: |c| {
            check(c, |corners, ray, within| {
                let hit = AxisAlignedBox::new(corners[0], corners[1])
                    .ok()?
                    .hit(ray, within)?;
                let entries = slabs(corners, ray).map(|slab| slab[0]);
                let t = entries.into_iter().fold(f64::INFINITY, f64::min);
                Some(Hit {
                    t: if t.is_finite() { t } else { hit.t },
                    ..hit
                })
            });
        },
    },
    Wrong {
        mistake: "the entry is not compared with the exit",
        says: "beside",
        check: |c| {
            check(c, |corners, ray, within| {
                let slabs = slabs(corners, ray);
                let last = (0..3).max_by(|a, b| slabs[*a][0].total_cmp(&slabs[*b][0]))?;
                let t = slabs[last][0];
                let sign = -ray.direction().to_glam()[last];
                within.contains(t).then(|| Hit::new(t, normal(last, sign)))
            });
        },
    },
    Wrong {
        mistake: "the normal points along the positive axis on all faces",
        says: "the normal, from outside",
        check: |c| {
            check(c, |corners, ray, within| {
                let hit = AxisAlignedBox::new(corners[0], corners[1])
                    .ok()?
                    .hit(ray, within)?;
                let n = hit.normal.to_glam().abs();
                Some(Hit::new(hit.t, Normal3::from_glam(n)))
            });
        },
    },
    Wrong {
        mistake: "from inside, the normal points into the box",
        says: "the normal, from inside",
        check: |c| {
            check(c, |corners, ray, within| {
                let hit = AxisAlignedBox::new(corners[0], corners[1])
                    .ok()?
                    .hit(ray, within)?;
                let faces_eye = hit.normal.to_glam().dot(ray.direction().to_glam()) < 0.0;
                Some(Hit::new(
                    hit.t,
                    if faces_eye { hit.normal } else { -hit.normal },
                ))
            });
        },
    },
];
