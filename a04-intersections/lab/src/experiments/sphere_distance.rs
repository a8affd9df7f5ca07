//! Accuracy of the formulas for far spheres and for huge spheres.

use std::rc::Rc;

use a02_lab::exact::DoubleDouble;
use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Unit};

use crate::support::{
    Numbers, Real, arrays, difference, dot, first, point, raw_ray, sphere_condition,
};
use crate::{exact, protocol};
use a04_intersections::Sphere;

/// A ray towards a sphere: the sphere's centre and radius, and the ray's origin and direction.
pub type Shot<F> = ([F; 3], F, [F; 3], [F; 3]);

/// The formula of the renderer in either precision.
pub fn stable<F: Real>(c: &[F; 3], r: F, o: &[F; 3], d: &[F; 3]) -> Option<F> {
    let f = difference(o, c);
    stable_roots(&f, r, d, dot(&f, &f) - r * r)
}

/// The renderer's formula with `f · f - r²` in twice as many digits: near a huge
/// sphere this is the difference of two huge numbers.
fn compensated(c: &[f64; 3], r: f64, o: &[f64; 3], d: &[f64; 3]) -> Option<f64> {
    let f = exact::difference(o, c);
    let power = dot(&f, &f) - DoubleDouble::from(r) * r.into();
    stable_roots(&f.map(DoubleDouble::value), r, d, power.value())
}

/// The renderer's `d · d`, the `t` nearest to the centre, and its discriminant `r² - l · l`.
pub fn stable_terms<F: Real>(f: &[F; 3], r: F, d: &[F; 3]) -> [F; 3] {
    let a = dot(d, d);
    let middle = -dot(f, d) / a;
    let l: [F; 3] = std::array::from_fn(|axis| f[axis] + d[axis] * middle);
    [a, middle, r * r - dot(&l, &l)]
}

/// The least positive root, given `power` = `f · f - r²`.
fn stable_roots<F: Real>(f: &[F; 3], r: F, d: &[F; 3], power: F) -> Option<F> {
    let [a, middle, discriminant] = stable_terms(f, r, d);
    if discriminant < F::zero() {
        return None;
    }
    let t1 = middle + (discriminant / a).sqrt().copysign(middle);
    let t0 = power / (a * t1);
    let (near, far) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
    [near, far].into_iter().find(|t| *t > F::zero())
}

/// Rays by their number, each towards a sphere of centre and radius, from a point in a
/// direction that is brought to length 1.
type Shots = fn(f64, usize) -> ([f64; 3], f64, Vector3, Vector3);

/// The unit sphere at the origin and rays from all around, at a distance, that
/// aim at a disc of 1.2 radii.
pub const FROM_AFAR: Shots = |distance, n| {
    let mut numbers = Numbers::new(11, n);
    let [back, aside] = numbers.perpendicular();
    let o = back * distance;
    let d = aside * (1.2 * numbers.between(0.0, 1.0).sqrt()) - o;
    ([0.0; 3], 1.0, o, d)
};

/// A sphere of this radius whose top is the origin, such as a ground, and rays from
/// one to two units above it, three of four of them downwards.
pub const AT_GROUND: Shots = |radius, n| {
    let mut numbers = Numbers::new(12, n);
    let o = numbers.triple(-1.0, 1.0);
    let o = Vector3::new(o.x(), numbers.between(1.0, 2.0), o.z());
    let down = if numbers.below(4) == 0 { 1.0 } else { -1.0 };
    let mut slope = || numbers.between(-0.5, 0.5);
    let d = Vector3::new(slope(), down, slope());
    ([0.0, -radius, 0.0], radius, o, d)
};

/// These rays in either precision.
pub fn shots<F: Real>(shots: Shots, parameter: f64, rays: usize) -> Rc<[Shot<F>]> {
    let shot = |n| {
        let (c, r, o, d) = shots(parameter, n);
        let [o, d] = arrays(&Ray::derived(Point3::ORIGIN + o, d * (1.0 / d.magnitude())));
        let [c, o, d] = [c, o, d].map(|triple| triple.map(F::rounded));
        (c, F::rounded(r), o, d)
    };
    (0..rays).map(shot).collect()
}

/// The error of a `t`, except near the rim of the sphere, where rounding of the ray itself
/// has an effect. A miss counts as 1.
pub fn error<F: Real>((c, r, o, d): &Shot<F>, found: Option<F>) -> Option<Deviation> {
    let [centre, origin, direction] = [c, o, d].map(|triple| triple.map(Into::into));
    let radius = (*r).into();
    let exact = exact::sphere(&centre, radius, &origin, &direction);
    let [near, _] = exact.roots?;
    let counts = exact.distance < 0.9 * radius && near.value() > 0.0;
    counts.then(|| {
        let error = found.map_or(1.0, |t| near.error_of(t.into()));
        let condition = sphere_condition(&centre, radius, &[origin, direction], near.value());
        Deviation::new(error, near.value(), condition).of_epsilon(F::epsilon().into())
    })
}

/// Whether a formula hits or misses the unit sphere wrongly, though the ray passes the rim at more
/// than four rounding errors of the numbers given.
pub fn is_wrong<F: Real>((c, r, o, d): &Shot<F>, found: Option<F>) -> bool {
    let [centre, origin, direction] = [c, o, d].map(|triple| triple.map(Into::into));
    let exact = exact::sphere(&centre, (*r).into(), &origin, &direction);
    let margin = 4.0 * F::epsilon().into() * dot(&origin, &origin).sqrt();
    (exact.distance - 1.0).abs() > margin && found.is_some() != exact.roots.is_some()
}

/// The first powers of 8 and their rays.
fn sets<F: Real>(all: Shots, powers: i32, effort: Effort) -> Vec<(f64, Rc<[Shot<F>]>)> {
    let rays = effort.choose(4096, 65_536);
    let parameters = (1..=powers).map(|power| libm::pow(8.0, power.into()));
    parameters
        .map(|parameter| (parameter, shots(all, parameter, rays)))
        .collect()
}

/// The `t` of the sphere of centre and radius for the ray of origin and direction.
pub type Formula<F> = fn(&[F; 3], F, &[F; 3], &[F; 3]) -> Option<F>;

/// The renderer's sphere, with its constructor and the normal of the hit.
pub const OURS: Formula<f64> =
    |c, r, o, d| first(&Sphere::new(point(*c), r).ok()?, &raw_ray((*o, *d)));

fn curve<F: Real + 'static>(
    method: &'static str,
    sets: &[(f64, Rc<[Shot<F>]>)],
    formula: Formula<F>,
) -> Curve<'static> {
    let answer = move |(c, r, o, d): &_| formula(c, *r, o, d);
    Curve::of_tasks(method, sets, answer, error)
}

/// All formulas, with the slopes of the protocol's and of the compensated one; and the ranges
/// in which the protocol's slope holds, the others, and those in single precision.
fn curves(
    (shots, powers_of_singles): (Shots, i32),
    [theirs, least]: [f64; 2],
    [until_lost, everywhere, single]: [(f64, f64); 3],
    effort: Effort,
) -> Vec<Curve<'static>> {
    let doubles = sets(shots, 10, effort);
    let singles = sets(shots, powers_of_singles, effort);
    vec![
        curve("protocol", &doubles, protocol::sphere).with_slope(theirs, until_lost),
        curve("stable (ours)", &doubles, stable).with_slope(1.0, everywhere),
        curve("compensated", &doubles, compensated).with_slope(least, everywhere),
        curve("protocol (single)", &singles, protocol::sphere::<f32>).with_slope(theirs, single),
        curve("stable (single)", &singles, stable).with_slope(1.0, single),
    ]
}

pub fn far() -> Experiment<'static> {
    let ranges = [(8.0, 2e7), (8.0, 2e9), (8.0, 512.0)];
    Experiment::new("sphere-far")
        .asking("How far away may a sphere of radius 1 be?")
        .over(Axis::Parameter, "distance (radii)", "rays")
        .with_error("rms error of t")
        .with_unit(Unit::Other("radii"))
        .with_exact("against 30 digits; a miss counts as 1; seven of ten rays hit")
        .with_seeds(&[11])
        .with_curves(move |effort| curves((FROM_AFAR, 3), [2.0, 1.0], ranges, effort))
}

pub fn near() -> Experiment<'static> {
    let ranges = [(64.0, 2e9), (64.0, 2e9), (64.0, 3e5)];
    Experiment::new("sphere-near")
        .asking("How large may a sphere be whose surface is near the eye?")
        .over(Axis::Parameter, "radius (eye heights)", "rays")
        .with_error("rms error of t")
        .with_unit(Unit::Other("heights of the eye"))
        .with_exact("against 30 digits; three of four rays hit")
        .with_seeds(&[12])
        .with_curves(move |effort| curves((AT_GROUND, 6), [1.0, 0.0], ranges, effort))
}

pub fn decisions() -> Experiment<'static> {
    fn curve<'a, F: Real + 'a>(
        method: &'a str,
        powers: i32,
        effort: Effort,
        of: Formula<F>,
    ) -> Curve<'a> {
        let answer = move |(c, r, o, d): &Shot<F>| of(c, *r, o, d);
        Curve::of_decisions(method, &sets(FROM_AFAR, powers, effort), answer, is_wrong)
    }
    Experiment::new("sphere-decisions")
        .asking("From how far away is a sphere of radius 1 hit and missed as it should?")
        .over(Axis::Parameter, "distance (radii)", "rays")
        .with_error("fraction of rays that hit or miss wrongly")
        .with_unit(Unit::Share)
        .with_exact("against 30 digits, more than four roundings beside the rim")
        .with_seeds(&[11])
        .with_curves(|effort| {
            let all = 0.0..=f64::INFINITY;
            vec![
                curve("protocol", 10, effort, protocol::sphere::<f64>),
                curve("stable (ours)", 10, effort, stable::<f64>).with_bound(0.0, all.clone()),
                curve("protocol (single)", 6, effort, protocol::sphere::<f32>),
                curve("stable (single)", 6, effort, stable::<f32>).with_bound(0.0, all),
            ]
        })
}
