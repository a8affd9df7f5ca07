//! Triangle tests on thinner and thinner triangles.

use a02_math::arrays::array;
use std::rc::Rc;

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use measure::experiment::{Axis, Curve, Deviation, Experiment, Unit};

use crate::support::{Numbers, arrays, corners, first, triangle_condition};
use crate::{exact, protocol};
use a04_intersections::Triangle;

/// A triangle and a ray. Half of the rays hit, far from grazing.
pub type Needle = (Triangle, Ray);

/// Rays from 2 to 5 lengths away towards sixteen triangles with this ratio of length to
/// height, in various orientations.
pub fn needles(aspect: f64, rays: usize) -> Rc<[Needle]> {
    let each = rays / 16;
    (0..16).flat_map(|n| needle(n, aspect, each)).collect()
}

fn needle(n: usize, aspect: f64, rays: usize) -> impl Iterator<Item = Needle> {
    let mut numbers = Numbers::new(13, n);
    let [along, across] = numbers.perpendicular();
    let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let middle = along * numbers.between(0.3, 0.7);
    // Longer than 1, so that the constructor accepts it.
    let triangle = Triangle::new(a, a + along, a + middle + across * (1.0 / aspect));
    let ray = move |m| {
        let mut numbers = Numbers::new(14 + n as u64, m);
        let (beta, gamma) = (numbers.between(0.0, 1.0), numbers.between(0.0, 1.0));
        let aim = along * beta + (middle + across * (1.0 / aspect)) * gamma;
        let slanted = along.cross(across) + numbers.triple(-0.5, 0.5);
        let back = slanted * numbers.between(2.0, 5.0);
        let (origin, way) = (a + aim + back, -back);
        Ray::derived(origin, way * (1.0 / way.magnitude()))
    };
    (0..rays).filter_map(move |m| Some((triangle.clone().ok()?, ray(m))))
}

/// The relative error of a `t`, if the exact barycentric coordinates are not near 0. A
/// miss counts as 1.
pub fn error((triangle, ray): &Needle, found: Option<f64>) -> Option<Deviation> {
    let line @ [o, d] = arrays(ray);
    let corners = corners(triangle).map(array);
    let [t, beta, gamma] = exact::triangle(&corners, &o, &d);
    let [beta, gamma] = [beta.value(), gamma.value()];
    let least = beta.min(gamma).min(1.0 - beta - gamma);
    (least > 0.05).then(|| {
        let error = found.map_or(t.value(), |found| t.error_of(found));
        let condition = triangle_condition(&corners, [beta, gamma], &line, t.value());
        Deviation::new(error, t.value(), condition).as_share_of(t.value())
    })
}

/// A formula for the distance of the triangle along the ray.
pub type Formula = fn(&Needle) -> Option<f64>;

/// The protocol's test.
pub const CRAMER: Formula = |(triangle, ray)| protocol::triangle(&corners(triangle), ray);

/// The renderer's test.
pub const OURS: Formula = |(triangle, ray)| first(triangle, ray);

/// The test of Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997.
fn moeller_trumbore((triangle, ray): &Needle) -> Option<f64> {
    let [a, b, c] = corners(triangle);
    let (ab, ac) = (b - a, c - a);
    let across = ray.direction().cross(ac);
    let determinant = ab.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let from_a = ray.origin() - a;
    let beta = from_a.dot(across) / determinant;
    if !(0.0..=1.0).contains(&beta) {
        return None;
    }
    let moment = from_a.cross(ab);
    let gamma = ray.direction().dot(moment) / determinant;
    if gamma < 0.0 || beta + gamma > 1.0 {
        return None;
    }
    let t = ac.dot(moment) / determinant;
    (t > 0.0).then_some(t)
}

/// The renderer's test with Kahan's difference of products, whose error is at most
/// 1.5 units in the last place (Jeannerod, Louvet and Muller, 2013).
#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two is what the method lives on"
)]
fn compensated((triangle, ray): &Needle) -> Option<f64> {
    let d = ray.direction().to_glam();
    let z = d.abs().max_position();
    let (x, y) = ((z + 1) % 3, (z + 2) % 3);
    let [a, b, c] = corners(triangle).map(|corner| {
        let p = (corner - ray.origin()).to_glam();
        [
            p[x] - d[x] / d[z] * p[z],
            p[y] - d[y] / d[z] * p[z],
            p[z] * (1.0 / d[z]),
        ]
    });
    let area = |p: [f64; 3], q: [f64; 3]| {
        let product = p[1] * q[0];
        p[0].mul_add(q[1], -product) + (-p[1]).mul_add(q[0], product)
    };
    let [u, v, w] = [area(c, b), area(a, c), area(b, a)];
    let is_inside = u.min(v).min(w) >= 0.0 || u.max(v).max(w) <= 0.0;
    let t = (u * a[2] + v * b[2] + w * c[2]) / (u + v + w);
    (is_inside && t > 0.0).then_some(t)
}

pub fn experiment() -> Experiment<'static> {
    Experiment::new("triangle-needle")
        .asking("How thin may a triangle be?")
        .over(Axis::Parameter, "length / height", "tests")
        .with_error("rms error of t")
        .with_unit(Unit::Other("fraction of t"))
        .with_exact("against 30 digits, away from the edges; half of the rays hit")
        .with_seeds(&[13, 14])
        .with_curves(|effort| {
            let rays = effort.choose(4096, 65_536);
            let aspects = (0..=9).map(|power| libm::pow(8.0, power.into()));
            let sets = aspects.map(|aspect| (aspect, needles(aspect, rays)));
            let sets: Vec<_> = sets.collect();
            let curve = |method, slope: Option<f64>, formula: Formula| {
                Curve::of_tasks(method, &sets, formula, error).with_slope(slope, (64.0, 2e8))
            };
            vec![
                curve("Cramer (protocol)", Some(1.0), CRAMER),
                curve("Moeller-Trumbore", Some(1.0), moeller_trumbore),
                curve("Woop (ours)", None, OURS).with_bound(4.0 * f64::EPSILON, 1.0..=64.0),
                curve("Woop (compensated)", Some(0.0), compensated),
            ]
        })
}
