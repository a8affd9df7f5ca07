//! Translated and scaled scenes, whose hits must not change.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::Error;
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds};

use super::{any_ray, arrays, first, meeting};
use crate::lab::experiments::Numbers;
use crate::lab::protocol::{self, Compared};
use crate::{AxisAlignedBox, Plane, Sphere, Triangle};

/// Coordinates are multiples of this: they are exact after a translation by 2^30.
const GRID: f64 = 1.0 / 1_048_576.0;

/// A plane, a box, a triangle and a sphere, scaled, and translated along all axes.
#[derive(Clone, Copy)]
struct Place {
    scale: f64,
    shift: f64,
}

const HERE: Place = Place {
    scale: 1.0,
    shift: 0.0,
};

/// The distances of the four shapes along a number of rays, by our formulas or by the
/// protocol's.
type Distances = fn(&Place, usize) -> Result<Vec<[Option<f64>; 4]>, Error>;

impl Place {
    fn at(&self, coordinates: [f64; 3]) -> Point3 {
        Point3::from_glam(coordinates.map(|x| x * self.scale + self.shift).into())
    }

    /// The `n`-th ray. Its direction does not depend on scale and translation.
    fn ray(&self, n: usize) -> Ray {
        let mut numbers = Numbers::new(41, n);
        let mut on_grid = |reach: f64| (numbers.between(-reach, reach) / GRID).round() * GRID;
        let from: [f64; 3] = std::array::from_fn(|_| on_grid(4.0));
        let d: [f64; 3] = std::array::from_fn(|axis| on_grid(1.0) - from[axis]);
        any_ray((self.at(from).to_glam().to_array(), d))
    }

    fn corners(&self) -> [Point3; 3] {
        [[-1.5, 0.25, 0.0], [1.0, -1.25, 0.5], [0.5, 1.5, -0.75]].map(|corner| self.at(corner))
    }

    fn r#box(&self) -> [Point3; 2] {
        [[-0.75, -0.5, -1.0], [0.5, 1.25, 0.75]].map(|corner| self.at(corner))
    }

    fn plane(&self) -> (Point3, Normal3) {
        (self.at([0.25, -0.5, 1.0]), Normal3::new(1.0, 2.0, -3.0))
    }

    fn sphere(&self) -> (Point3, f64) {
        (self.at([0.25, 0.125, -0.5]), 1.25 * self.scale)
    }
}

const OURS: Distances = |place, rays| {
    let ((a, n), [lbf, run], (c, r)) = (place.plane(), place.r#box(), place.sphere());
    let [p, q, s] = place.corners();
    let (plane, aab) = (Plane::new(a, n)?, AxisAlignedBox::new(lbf, run)?);
    let (triangle, sphere) = (Triangle::new(p, q, s)?, Sphere::new(c, r)?);
    let distances = |ray: Ray| {
        [
            first(&plane, &ray),
            first(&aab, &ray),
            first(&triangle, &ray),
            first(&sphere, &ray),
        ]
    };
    Ok((0..rays).map(|n| distances(place.ray(n))).collect())
};

const THEIRS: Distances = |place, rays| {
    let ((a, n), [lbf, run], (c, r)) = (place.plane(), place.r#box(), place.sphere());
    let (n, corners, c) = (n.unit("normal n")?, place.corners(), c.to_glam().to_array());
    let distances = |ray: Ray| {
        let [o, d] = arrays(&ray);
        [
            protocol::plane(a, n, &ray),
            protocol::axis_aligned_box(lbf, run, &ray, Compared::Three),
            protocol::triangle(&corners, &ray),
            protocol::sphere(&c, r, &o, &d),
        ]
    };
    Ok((0..rays).map(|n| distances(place.ray(n))).collect())
};

/// Number of distances that differ in any bit, except for the scale, at some places.
fn differing(distances: Distances, places: &[Place], rays: usize) -> Result<usize, Error> {
    let here = distances(&HERE, rays)?;
    let bits = |t: Option<f64>| t.map(f64::to_bits);
    let count = |place: &Place| {
        let there = distances(place, rays)?;
        let pairs = here.iter().flatten().zip(there.iter().flatten());
        let differ =
            |(t, u): &(&Option<f64>, &Option<f64>)| bits(t.map(|t| t * place.scale)) != bits(**u);
        Ok(pairs.filter(differ).count())
    };
    places.iter().map(count).sum()
}

fn row(id: &'static str, what: &str, places: &[Place], rays: usize) -> Case {
    let [ours, theirs] = [OURS, THEIRS].map(|distances| differing(distances, places, rays));
    Case::new(id, what, 0.0, Equal, ours).protocol(Fails, theirs)
}

/// The unit sphere and an eye, this far from the origin along all axes.
fn remote(id: &'static str, what: &str, t: f64, exact: f64) -> Case {
    let line = ([t, t, t + 3.0], [0.0, 0.0, -1.0]);
    let ours = meeting(Sphere::new(Point3::new(t, t, t), 1.0), line);
    Case::new(id, what, exact, Equal, ours)
        .protocol(Holds, protocol::sphere(&[t; 3], 1.0, &line.0, &line.1))
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let moved = Place { shift: libm::scalbn(1.0, 30), ..HERE };
    let scales = (-300..=300).step_by(50).map(|power| libm::scalbn(1.0, power));
    let scaled: Vec<_> = scales.map(|scale| Place { scale, ..HERE }).collect();
    vec![
        row("I11", "four shapes moved by 2^30, all differences exact: distances that change",
            &[moved], effort.choose(1000, 20_000)),
        remote("I12", "eye and sphere at 1e15, 3 apart, where doubles are 1/8 apart", 1e15, 2.0),
        remote("I13", "eye and sphere at 1e16, where doubles are 2 apart: 3 becomes 4", 1e16, 3.0),
        row("S12", "four shapes in 13 scales from 2^-300 to 2^300: distances that change more than the scale",
            &scaled, effort.choose(400, 8000)),
    ]
}
