//! Discs: their rims, their radii and grazing rays from rows, and rays that leave a disc.

use a02_math::arrays::{point, vector};
use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use a04_lab::compared_shape::{ComparedShape, triple, unit_normal};
use a04_lab::rows;
use a04_lab::support::{Numbers, first};
use a06_shadows_reflection::secondary_ray;
use common::Error;
use corpus::{Question, Shape};
use measure::extremes::{AgainstProtocol, Case, Row, count_wrong};

use crate::protocol;
use a07_transforms::Disc;

/// Its centre, its normal and its radius.
const DISC: ComparedShape = ComparedShape {
    make: |x| {
        let normal = vector(triple(&x[3..])).as_normal();
        Some(Box::new(Disc::new(point(triple(x)), normal, x[6]).ok()?))
    },
    protocol: |x, ray| protocol::disc(point(triple(x)), unit_normal(x), x[6], ray),
};

/// The nearest hit of a disc in a row.
pub fn met(row: &Row, question: &Question) -> Case {
    let Shape::Disc {
        center,
        normal,
        radius,
    } = question.shape
    else {
        return Row::unknown();
    };
    let numbers = [&center[..], &normal, &[radius]].concat();
    rows::met((&DISC, vec![numbers]), row, question)
}

/// Rays that leave a disc on the side from which it was hit must not hit it again.
pub fn leaving(count: usize) -> Result<AgainstProtocol<usize>, Error> {
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
            return Ok(AgainstProtocol::default());
        };
        let from_point = Ray::derived(ray.at(hit.t), away);
        Ok(AgainstProtocol {
            ours: first(&disc, &secondary_ray(&ray, &hit, away)).is_some(),
            theirs: protocol::disc(center, normal, 1.0, &from_point).is_some(),
        })
    })
}
