//! The stiff and extreme cases of this stage: transforms, nodes and discs, whose rims, radii
//! and grazing rays are here.

pub mod matrices;
mod nodes;

use std::f64::consts::SQRT_2;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use a04_lab::support::{Line, Numbers, first};
use a06_shadows_reflection::secondary_ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::{Case, Fails, Holds, Id, Nothing, Outcome, Protocol, Refused, Ulps};
use measure::extremes::{case, wrong};

use crate::protocol;
use crate::search::DISC;
use a07_transforms::Disc;

pub fn cases(effort: Effort) -> Vec<Case> {
    [discs(effort), matrices::cases(), nodes::cases(effort)].concat()
}

/// The `t` at which a ray hits the disc around the origin, whose normal is y.
fn hit(id: Id, what: &str, r: f64, line: Line, exact: impl Into<Outcome>, says: Protocol) -> Case {
    let both = DISC.met(&[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, r], line);
    case(id, format!("disc, {what}"), both, exact, Ulps(1.0), says)
}

#[rustfmt::skip]
fn discs(effort: Effort) -> Vec<Case> {
    let from = |x, z| ([x, 1.0, z], [0.0, -1.0, 0.0]);
    let (above, count) = (from(0.0, 0.0), effort.choose(2_000, 20_000));
    vec![
        hit("B12", "the rim, |p| = r = 5", 5.0, from(3.0, 4.0), 1.0, Fails),
        hit("B13", "|p|² = 2, r = √2 of which the square is 2 + 2^-51", SQRT_2, from(1.0, 1.0), 1.0, Fails),
        hit("B14", "one unit in the last place outside of the rim",
            5.0, from(3.0, 4.0_f64.next_up()), Nothing, Holds),
        hit("B15", "r = -2", -2.0, above, Refused, Fails),
        hit("B16", "r = 1e-170, whose square is 0", 1e-170, above, Refused, Fails),
        hit("B17", "grazing, through the centre", 1.0, ([-1.0, 1e-16, 0.0], [1.0, -1e-16, 0.0]), 1.0, Holds),
        hit("B18", "a ray within the plane of the disc",
            1.0, ([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]), Nothing, Holds),
        hit("B21", "a ray from its rim, within the plane",
            1.0, ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), Nothing, Holds),
        hit("B22", "a ray from its rim, downwards", 1.0, ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]), Nothing, Holds),
        hit("B31", "a slope of 5e-324, t beyond all numbers",
            1.0, ([0.0, 1.0, 0.0], [1.0, -5e-324, 0.0]), Nothing, Holds),
        hit("B32", "r = NaN", f64::NAN, above, Refused, Fails),
        hit("B33", "r = infinity", f64::INFINITY, above, Refused, Fails),
        Case::wrong("B34", format!("disc, {count} rays that leave it: met again"), leaving(count)),
    ]
}

/// Rays that leave a disc on the side from which it was hit must not hit it again.
fn leaving(count: usize) -> Result<[usize; 2], ArgumentError> {
    let (c, n, r) = (Point3::new(0.1, 0.2, 0.3), Normal3::new(0.3, 1.0, 0.2), 1.0);
    let (n, disc) = (n.unit("normal n")?, Disc::new(c, n, r)?);
    wrong(0..count, |i| {
        let aside = Numbers::new(18, i).triple(-0.5, 0.5);
        let eye = Point3::new(4.0, 5.0, 3.0);
        let target = c + Vector3::new(aside.x(), aside.y() / 9.0, aside.z());
        let ray = Ray::new(eye, target - eye)?;
        let Some(hit) = disc.hit(&ray, Interval::AHEAD) else {
            return Ok([false; 2]);
        };
        let away = Vector3::from(n);
        let ours = first(&disc, &secondary_ray(&ray, &hit, away));
        let theirs = protocol::disc(c, n, r, &Ray::derived(ray.at(hit.t), away));
        Ok([ours, theirs].map(|t| t.is_some()))
    })
}
