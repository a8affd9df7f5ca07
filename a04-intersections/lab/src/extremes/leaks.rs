//! Rays that pass between triangles, or past the edges of a box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use common::Error;
use measure::extremes::{Case, tried};

use crate::aimed_box::{Aimed, LBF, OTHERS, RUN};
use crate::closed_mesh::{Aim, ClosedMesh};
use crate::protocol;
use crate::support::{corners, first};
use a04_intersections::{AxisAlignedBox, Triangle};

/// A position far from the origin, where coordinates are coarse, from Embree's tests.
pub const FAR: Point3 = Point3::new(148_376.0, 1_234.0, -223_423.0);

/// By our triangles or the protocol's.
type IsHit = fn(&Triangle, &Ray) -> bool;

fn is_hit(triangle: &Triangle, ray: &Ray) -> bool {
    first(triangle, ray).is_some()
}

fn is_hit_by_the_protocol(triangle: &Triangle, ray: &Ray) -> bool {
    protocol::triangle(&corners(triangle), ray).is_some()
}

/// Number of rays from near the middle of a closed mesh that miss all its triangles.
fn leaking(middle: Point3, aim: Aim, rays: usize, is_hit: IsHit) -> Result<usize, Error> {
    let mesh = ClosedMesh::around(middle)?;
    let mut leaking = 0;
    for n in 0..rays {
        let ray = mesh.ray(aim, n)?;
        let mut triangles = mesh.triangles.iter();
        let is_held = triangles.any(|triangle| is_hit(triangle, &ray));
        leaking += usize::from(!is_held);
    }
    Ok(leaking)
}

/// Rays that get out of a closed mesh.
pub fn mesh(middle: Point3, aim: Aim, rays: usize) -> Case {
    Case::of(
        leaking(middle, aim, rays, is_hit),
        leaking(middle, aim, rays, is_hit_by_the_protocol),
    )
}

/// Rays at a box, where some faces meet, that are lost or hit it elsewhere: by ours and by another formula.
pub fn at_a_box(faces: usize, formula: usize, rays: usize) -> Case {
    let ours = tried(|| {
        let aab = AxisAlignedBox::new(LBF, RUN)?;
        Ok(wrong(faces, rays, |ray| first(&aab, ray)))
    });
    Case::of(ours, wrong(faces, rays, OTHERS[formula].t))
}

/// The number of rays for which a formula is wrong.
fn wrong(faces: usize, rays: usize, formula: impl Fn(&Ray) -> Option<f64>) -> usize {
    let aimed = (0..rays).map(|n| Aimed::new(faces, n));
    aimed
        .filter(|aimed| aimed.is_wrong(formula(&aimed.ray)))
        .count()
}
