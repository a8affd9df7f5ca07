//! Discs: their rims, their radii, and grazing rays.

use std::f64::consts::SQRT_2;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use a04_lab::line::{Line, line};
use a04_lab::support::{Numbers, first};
use a06_shadows_reflection::secondary_ray;
use common::Error;
use measure::Effort;
use measure::extremes::{Both, Case, Fails, Holds, Nothing, Number, Refused, Ulps, count_wrong};

use crate::protocol;
use crate::search::DISC;
use a07_transforms::Disc;

/// The first hit of the disc around the origin whose normal is y.
fn met(radius: f64, line: Line) -> Case {
    DISC.met(&[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, radius], line)
}

/// The line downwards from 1 above the disc's plane.
fn down(x: f64, z: f64) -> Line {
    line([x, 1.0, z], [0.0, -1.0, 0.0])
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let mut cases = rims_and_radii();
    cases.extend(grazing());
    cases.extend(endless_radii());
    cases.push(Case::of_wrong(
        "B34",
        format!("disc, {count} rays that leave it: met again"),
        leaving(count),
    ));
    cases
}

fn rims_and_radii() -> Vec<Case> {
    vec![
        Case {
            id: "B12",
            what: "disc, the rim, |p| = r = 5".into(),
            exact: Number(1.0),
            bound: Ulps(1.0),
            protocol: Fails,
            ..met(5.0, down(3.0, 4.0))
        },
        Case {
            id: "B13",
            what: "disc, |p|² = 2, r = √2 of which the square is 2 + 2^-51".into(),
            exact: Number(1.0),
            bound: Ulps(1.0),
            protocol: Fails,
            ..met(SQRT_2, down(1.0, 1.0))
        },
        Case {
            id: "B14",
            what: "disc, one unit in the last place outside of the rim".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(5.0, down(3.0, 4.0_f64.next_up()))
        },
        Case {
            id: "B15",
            what: "disc, r = -2".into(),
            exact: Refused,
            protocol: Fails,
            ..met(-2.0, down(0.0, 0.0))
        },
        Case {
            id: "B16",
            what: "disc, r = 1e-170, whose square is 0".into(),
            exact: Refused,
            protocol: Fails,
            ..met(1e-170, down(0.0, 0.0))
        },
    ]
}

/// Rays along the plane, or almost.
fn grazing() -> Vec<Case> {
    vec![
        Case {
            id: "B17",
            what: "disc, grazing, through the centre".into(),
            exact: Number(1.0),
            bound: Ulps(1.0),
            protocol: Holds,
            ..met(1.0, line([-1.0, 1e-16, 0.0], [1.0, -1e-16, 0.0]))
        },
        Case {
            id: "B18",
            what: "disc, a ray within the plane of the disc".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(1.0, line([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]))
        },
        Case {
            id: "B21",
            what: "disc, a ray from its rim, within the plane".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(1.0, line([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]))
        },
        Case {
            id: "B22",
            what: "disc, a ray from its rim, downwards".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(1.0, line([1.0, 0.0, 0.0], [0.0, -1.0, 0.0]))
        },
        Case {
            id: "B31",
            what: "disc, a slope of 5e-324, t beyond all numbers".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(1.0, line([0.0, 1.0, 0.0], [1.0, -5e-324, 0.0]))
        },
    ]
}

fn endless_radii() -> Vec<Case> {
    vec![
        Case {
            id: "B32",
            what: "disc, r = NaN".into(),
            exact: Refused,
            protocol: Fails,
            ..met(f64::NAN, down(0.0, 0.0))
        },
        Case {
            id: "B33",
            what: "disc, r = infinity".into(),
            exact: Refused,
            protocol: Fails,
            ..met(f64::INFINITY, down(0.0, 0.0))
        },
    ]
}

/// Rays that leave a disc on the side from which it was hit must not hit it again.
fn leaving(count: usize) -> Result<Both<usize>, Error> {
    let center = Point3::new(0.1, 0.2, 0.3);
    let normal = Normal3::new(0.3, 1.0, 0.2).unit("normal n")?;
    let disc = Disc::new(center, normal, 1.0)?;
    let away = Vector3::from(normal);
    count_wrong(0..count, |i| {
        let aside = Numbers::new(18, i).triple(-0.5, 0.5);
        let eye = Point3::new(4.0, 5.0, 3.0);
        let target = center + Vector3::new(aside.x(), aside.y() / 9.0, aside.z());
        let ray = Ray::new(eye, target - eye)?;
        let Some(hit) = disc.hit(&ray, Interval::AHEAD) else {
            return Ok(Both::default());
        };
        let from_point = Ray::derived(ray.at(hit.t), away);
        Ok(Both {
            ours: first(&disc, &secondary_ray(&ray, &hit, away)).is_some(),
            theirs: protocol::disc(center, normal, 1.0, &from_point).is_some(),
        })
    })
}
