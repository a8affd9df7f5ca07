//! Translated and scaled scenes, whose hits must not change.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Protocol};

use super::{any_ray, first, meeting};
use crate::lab::experiments::Numbers;
use crate::lab::protocol::{self, Compared};
use crate::{AxisAlignedBox, Plane, Sphere, Triangle};

/// Coordinates are multiples of this: they are exact after a translation by 2^30.
const GRID: f64 = 1.0 / 1_048_576.0;

/// A plane, a box, a triangle and a sphere, scaled, and translated along all axes.
struct Place {
    scale: f64,
    shift: f64,
}

/// Four distances.
type Distances = [Option<f64>; 4];

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

    fn ours(&self, rays: usize) -> Result<Vec<Distances>, ArgumentError> {
        let ((a, n), [lbf, run], (c, r)) = (self.plane(), self.r#box(), self.sphere());
        let [p, q, s] = self.corners();
        let (plane, aab) = (Plane::new(a, n)?, AxisAlignedBox::new(lbf, run)?);
        let (triangle, sphere) = (Triangle::new(p, q, s)?, Sphere::new(c, r)?);
        let distances = |n| {
            let ray = self.ray(n);
            [
                first(&plane, &ray),
                first(&aab, &ray),
                first(&triangle, &ray),
                first(&sphere, &ray),
            ]
        };
        Ok((0..rays).map(distances).collect())
    }

    fn theirs(&self, rays: usize) -> Result<Vec<Distances>, ArgumentError> {
        let ((a, n), [lbf, run], (c, r)) = (self.plane(), self.r#box(), self.sphere());
        let (n, corners, c) = (n.unit("normal n")?, self.corners(), c.to_glam().to_array());
        let distances = |index| {
            let ray = self.ray(index);
            let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()].map(|v| v.to_array());
            [
                protocol::plane(a, n, &ray),
                protocol::axis_aligned_box(lbf, run, &ray, Compared::Three),
                protocol::triangle(&corners, &ray),
                protocol::sphere(&c, r, &o, &d),
            ]
        };
        Ok((0..rays).map(distances).collect())
    }
}

/// Number of distances that differ in any bit after scaling.
fn differing(one: &[Distances], other: &[Distances], scale: f64) -> usize {
    let bits = |t: Option<f64>| t.map(f64::to_bits);
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    let differ = pairs.filter(|(one, other)| bits(one.map(|t| t * scale)) != bits(**other));
    differ.count()
}

const HERE: Place = Place {
    scale: 1.0,
    shift: 0.0,
};

type Count = Result<usize, ArgumentError>;

/// Differing distances over many scales: ours and the protocol's.
fn rescaled(rays: usize) -> (Count, Count) {
    let places = || {
        (-300..=300).step_by(50).map(|exponent| Place {
            scale: libm::scalbn(1.0, exponent),
            shift: 0.0,
        })
    };
    let ours = || {
        let here = HERE.ours(rays)?;
        let counts = places().map(|p| Ok(differing(&here, &p.ours(rays)?, p.scale)));
        counts.sum()
    };
    let theirs = || {
        let here = HERE.theirs(rays)?;
        let counts = places().map(|p| Ok(differing(&here, &p.theirs(rays)?, p.scale)));
        counts.sum()
    };
    (ours(), theirs())
}

fn moved(rays: usize) -> (Count, Count) {
    let there = Place {
        scale: 1.0,
        shift: libm::scalbn(1.0, 30),
    };
    let ours = || Ok(differing(&HERE.ours(rays)?, &there.ours(rays)?, 1.0));
    let theirs = || Ok(differing(&HERE.theirs(rays)?, &there.theirs(rays)?, 1.0));
    (ours(), theirs())
}

/// The unit sphere and an eye, this far from the origin along all axes.
fn remote(id: &'static str, what: &str, t: f64, exact: f64, says: Protocol) -> Case {
    let line = ([t, t, t + 3.0], [0.0, 0.0, -1.0]);
    let ours = meeting(Sphere::new(Point3::new(t, t, t), 1.0), line);
    Case::new(id, what, exact, Bound::Equal, ours)
        .protocol(says, protocol::sphere(&[t; 3], 1.0, &line.0, &line.1))
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let (ours, theirs) = moved(effort.choose(1000, 20_000));
    let place = Case::new(
        "I11",
        "four shapes moved by 2^30, all differences exact: distances that change",
        0.0,
        Bound::Equal,
        ours,
    )
    .protocol(Fails, theirs);
    let (ours, theirs) = rescaled(effort.choose(400, 8000));
    let scale = Case::new(
        "S12",
        "four shapes in 13 scales from 2^-300 to 2^300: distances that change more than the scale",
        0.0,
        Bound::Equal,
        ours,
    )
    .protocol(Fails, theirs);
    vec![
        place,
        remote(
            "I12",
            "eye and sphere at 1e15, 3 apart, where doubles are 1/8 apart",
            1e15,
            2.0,
            Holds,
        ),
        remote(
            "I13",
            "eye and sphere at 1e16, where doubles are 2 apart: 3 becomes 4",
            1e16,
            3.0,
            Holds,
        ),
        scale,
    ]
}
