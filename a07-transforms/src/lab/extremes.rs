//! The stiff and extreme cases of this stage.

mod discs;
pub mod matrices;
mod nodes;
mod normals;
mod self_hits;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::extremes::Case;

/// All rows of the table.
pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = discs::cases(effort);
    cases.extend(matrices::cases());
    cases.extend(normals::cases());
    cases.extend(nodes::cases(effort));
    cases.extend(self_hits::cases(effort));
    cases
}

/// A ray of exactly these numbers: not brought to length 1.
fn ray(o: [f64; 3], d: [f64; 3]) -> Ray {
    Ray::derived(Point3::from_glam(o.into()), Vector3::from_glam(d.into()))
}

fn numbers(n: Normal3) -> [f64; 3] {
    n.to_glam().to_array()
}
