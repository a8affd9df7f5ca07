//! Errors over many rays, compared with 30 digits; and translated and scaled scenes, whose
//! hits must not change.

use std::convert::Infallible;

use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Outcome};
use measure::extremes::{case, wrong};

use crate::experiments::sphere_distance::{FROM_AFAR, Formula, OURS, is_wrong, shots};
use crate::protocol;
use crate::subject::{BOX, PLANE, SPHERE, TRIANGLE};
use crate::support::{Numbers, Triple, any_ray};

/// Number of rays from a distance with a wrong decision between hit and miss of a unit sphere.
fn wrong_hits(distance: f64, rays: usize, formula: Formula<f64>) -> Outcome {
    let shots = shots(FROM_AFAR, distance, rays);
    let is_wrong = |shot @ (c, r, o, d): &&_| is_wrong(shot, formula(c, *r, o, d));
    shots.iter().filter(is_wrong).count().into()
}

/// Coordinates are multiples of this: they are exact after a translation by 2^30.
const GRID: f64 = 1.0 / 1_048_576.0;

/// A scale, and a translation along all axes.
type Place = (f64, f64);

const HERE: Place = (1.0, 0.0);

/// The distances of a plane, a box, a triangle and a sphere at a place along the `n`-th ray, each
/// by our formula and by the protocol's. The ray's direction does not depend on the place.
fn distances((scale, shift): Place, n: usize) -> [[Option<f64>; 2]; 4] {
    let at = |triple: Triple| triple.map(|x| x * scale + shift);
    let mut numbers = Numbers::new(41, n);
    let mut on_grid = |reach: f64| (numbers.between(-reach, reach) / GRID).round() * GRID;
    let from: Triple = std::array::from_fn(|_| on_grid(4.0));
    let way: Triple = std::array::from_fn(|axis| on_grid(1.0) - from[axis]);
    let ray = any_ray((at(from), way));
    let opposite = [[-0.75, -0.5, -1.0], [0.5, 1.25, 0.75]];
    let corners = [[-1.5, 0.25, 0.0], [1.0, -1.25, 0.5], [0.5, 1.5, -0.75]];
    let [x, y, z] = at([0.25, 0.125, -0.5]);
    let shapes = [
        (PLANE, [at([0.25, -0.5, 1.0]), [1.0, 2.0, -3.0]].concat()),
        (BOX, opposite.map(at).concat()),
        (TRIANGLE, corners.map(at).concat()),
        (SPHERE, vec![x, y, z, 1.25 * scale]),
    ];
    shapes.map(|(shape, x)| [shape.lesson(&x, &ray), (shape.protocol)(&x, &ray)])
}

/// Number of distances that differ in any bit, except for the scale, at some places: ours,
/// and the protocol's.
fn differing(places: &[Place], rays: usize) -> Result<[usize; 2], Infallible> {
    let shapes = (0..4).flat_map(|shape| (0..rays).map(move |n| (shape, n)));
    let trials = shapes.flat_map(|(shape, n)| places.iter().map(move |place| (shape, n, *place)));
    wrong(trials, |(shape, n, place)| {
        let (here, there) = (distances(HERE, n), distances(place, n));
        Ok([0, 1].map(|formula| {
            let [t, u] = [here, there].map(|distances| distances[shape][formula]);
            t.map(|t| (t * place.0).to_bits()) != u.map(f64::to_bits)
        }))
    })
}

/// The distance of the unit sphere from an eye, both this far from the origin along all axes.
fn remote(t: f64) -> [Outcome; 2] {
    let (eye, down) = ([t, t, t + 3.0], [0.0, 0.0, -1.0]);
    [OURS, protocol::sphere].map(|formula| formula(&[t; 3], 1.0, &eye, &down).into())
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let moved = (1.0, libm::scalbn(1.0, 30));
    let scales = (-300..=300).step_by(50).map(|power| libm::scalbn(1.0, power));
    let scaled: Vec<_> = scales.map(|scale| (scale, 0.0)).collect();
    let rays = effort.choose(1000, 4000);
    let doubles = [OURS, protocol::sphere].map(|formula| wrong_hits(1e8, rays, formula));
    vec![
        Case::wrong("I11", "four shapes moved by 2^30, all differences exact: distances that change",
            differing(&[moved], effort.choose(1000, 20_000))),
        case("I12", "eye and sphere at 1e15, 3 apart, where doubles are 1/8 apart", remote(1e15), 2.0, Equal, Holds),
        case("I13", "eye and sphere at 1e16, where doubles are 2 apart: 3 becomes 4", remote(1e16), 3.0, Equal, Holds),
        case("S10", format!("{rays} rays at and past a sphere 1e8 radii away: wrong hits and misses"),
            doubles, 0.0, Equal, Fails),
        Case::wrong("S12", "four shapes in 13 scales from 2^-300 to 2^300: distances that change more than the scale",
            differing(&scaled, effort.choose(400, 8000))),
    ]
}
