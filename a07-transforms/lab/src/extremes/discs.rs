//! Discs: their rims, their radii and grazing rays from the corpus, and rays that leave a disc.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use a04_lab::rows;
use a04_lab::support::{Numbers, first};
use a06_shadows_reflection::secondary_ray;
use common::Error;
use corpus::{Row, Shape};
use measure::Effort;
use measure::extremes::{Both, Case, count_wrong};

use crate::protocol;
use crate::search::DISC;
use a07_transforms::Disc;

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let mut cases = rows::cases(&["disc"], of_corpus);
    cases.push(Case::of_wrong(
        "B34",
        format!("disc, {count} rays that leave it: met again"),
        leaving(count),
    ));
    cases
}

/// A case of the corpus.
fn of_corpus(row: &Row) -> Case {
    let Shape::Disc {
        center,
        normal,
        radius,
    } = row.case.question.shape
    else {
        return Case::default();
    };
    let numbers = [&center[..], &normal, &[radius]].concat();
    rows::met((&DISC, vec![numbers]), row)
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
