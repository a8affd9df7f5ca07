//! Triangles whose area is rounding error, and what is interpolated in a triangle. Corners, edges, needles, and
//! tiny and huge triangles are rows of `cases.toml`.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::extremes::{AgainstProtocol, Case, Number, count_wrong, tried};

use super::nearest_hit;
use crate::line::{Line, line};
use crate::protocol;
use crate::support::{Numbers, Triple, first, point};
use a04_intersections::{Geometry, Interval, Triangle};

/// The half of a unit square next to the origin.
const HALF: [Triple; 3] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// The line along -z from 1 above the plane z = 0.
fn at(x: f64, y: f64) -> Line {
    line([x, y, 1.0], [0.0, 0.0, -1.0])
}

fn half() -> Result<Triangle, ArgumentError> {
    let [a, b, c] = HALF.map(point);
    Triangle::new(a, b, c)
}

/// The length of the mean of three perpendicular normals, each of which is longer than their mean.
pub fn mean_of_normals() -> Case {
    const THIRD: f64 = 1.0 / 3.0;
    let normals = [
        Normal3::new(1.0, 0.0, 0.0),
        Normal3::new(0.0, 1.0, 0.0),
        Normal3::new(0.0, 0.0, 1.0),
    ];
    let length = |normal: Normal3| normal.to_glam().length();
    let ours = tried(|| {
        let triangle = half()?.with_normals(normals)?;
        let hit = triangle.hit(&at(THIRD, THIRD).unit_ray()?, Interval::AHEAD);
        Ok(hit.map(|hit| length(hit.normal)))
    });
    let theirs = protocol::interpolated_normal(normals, THIRD, THIRD);
    Case::of(ours, length(theirs))
}

/// How many of some points within a triangle are met. Few of them have β + γ = 1.
pub fn points_within(count: usize) -> Case {
    let (mut ours, mut theirs) = (0, 0);
    for n in 0..count {
        let mut numbers = Numbers::new(33, n);
        let beta = numbers.between(0.01, 0.98);
        let gamma = numbers.between(0.005, 0.99 - beta);
        let is_met = nearest_hit(half(), at(beta, gamma)) == Number(1.0);
        ours += usize::from(is_met);
        let is_inside = protocol::is_inside_by_the_text(beta, gamma);
        theirs += usize::from(is_inside);
    }
    Case::of(ours, theirs)
}

/// For corners on a line up to rounding, the determinant is only rounding error and
/// not 0: the protocol computes hits of some of them, at arbitrary points.
pub fn noise(count: usize) -> Result<AgainstProtocol<usize>, ArgumentError> {
    count_wrong(0..count, |n| {
        let mut numbers = Numbers::new(32, n);
        let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
        let along = numbers.direction();
        let (b, c) = (a + along, a + along * numbers.between(0.3, 0.7));
        let back = numbers.direction() * 3.0;
        let target = a + along * numbers.between(0.2, 0.8);
        let ray = Ray::new(target + back, -back)?;
        let ours = Triangle::new(a, b, c).map(|triangle| first(&triangle, &ray));
        Ok(AgainstProtocol {
            ours: ours.is_ok_and(|t| t.is_some()),
            theirs: protocol::triangle(&[a, b, c], &ray).is_some(),
        })
    })
}
