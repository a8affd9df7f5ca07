//! Translated and scaled scenes, whose hits must not change.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::Error;
use measure::Effort;
use measure::extremes::{Case, Equal, Holds, Id, wrong};

use super::meeting;
use crate::lab::protocol::{self, Compared};
use crate::lab::support::{Numbers, any_ray, arrays, first};
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

    /// The distances of the four shapes along the `n`-th ray, by our formulas and by the
    /// protocol's.
    fn distances(&self, n: usize) -> Result<[[Option<f64>; 4]; 2], Error> {
        let ray = self.ray(n);
        let (a, n) = (self.at([0.25, -0.5, 1.0]), Normal3::new(1.0, 2.0, -3.0));
        let [lbf, run] = [[-0.75, -0.5, -1.0], [0.5, 1.25, 0.75]].map(|corner| self.at(corner));
        let corners = [[-1.5, 0.25, 0.0], [1.0, -1.25, 0.5], [0.5, 1.5, -0.75]];
        let corners @ [p, q, s] = corners.map(|corner| self.at(corner));
        let (c, r) = (self.at([0.25, 0.125, -0.5]), 1.25 * self.scale);
        let ours = [
            first(&Plane::new(a, n)?, &ray),
            first(&AxisAlignedBox::new(lbf, run)?, &ray),
            first(&Triangle::new(p, q, s)?, &ray),
            first(&Sphere::new(c, r)?, &ray),
        ];
        let [o, d] = arrays(&ray);
        let theirs = [
            protocol::plane(a, n.unit("normal n")?, &ray),
            protocol::axis_aligned_box(lbf, run, &ray, Compared::Three),
            protocol::triangle(&corners, &ray),
            protocol::sphere(&c.to_glam().to_array(), r, &o, &d),
        ];
        Ok([ours, theirs])
    }
}

/// Number of distances that differ in any bit, except for the scale, at some places: ours,
/// and the protocol's.
fn differing(places: &[Place], rays: usize) -> Result<[usize; 2], Error> {
    let shapes = (0..4).flat_map(|shape| (0..rays).map(move |n| (shape, n)));
    let trials = shapes.flat_map(|(shape, n)| places.iter().map(move |place| (shape, n, place)));
    wrong(trials, |(shape, n, place)| {
        let (here, there) = (HERE.distances(n)?, place.distances(n)?);
        Ok([0, 1].map(|formula| {
            let [t, u] = [here, there].map(|distances| distances[formula][shape]);
            t.map(|t| (t * place.scale).to_bits()) != u.map(f64::to_bits)
        }))
    })
}

/// The unit sphere and an eye, this far from the origin along all axes.
fn remote(id: Id, what: &str, t: f64, exact: f64) -> Case {
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
        Case::wrong("I11", "four shapes moved by 2^30, all differences exact: distances that change",
            differing(&[moved], effort.choose(1000, 20_000))),
        remote("I12", "eye and sphere at 1e15, 3 apart, where doubles are 1/8 apart", 1e15, 2.0),
        remote("I13", "eye and sphere at 1e16, where doubles are 2 apart: 3 becomes 4", 1e16, 3.0),
        Case::wrong("S12", "four shapes in 13 scales from 2^-300 to 2^300: distances that change more than the scale",
            differing(&scaled, effort.choose(400, 8000))),
    ]
}
