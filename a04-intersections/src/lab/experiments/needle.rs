//! Triangle tests on thinner and thinner triangles.

use std::rc::Rc;

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit};

use super::Numbers;
use crate::lab::extremes::arrays;
use crate::lab::{exact, protocol};

/// The corners of a triangle, and a ray. Half of the rays hit, far from grazing.
pub type Needle = ([Point3; 3], Ray);

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
    let corners = [a, a + along, a + middle + across * (1.0 / aspect)];
    let ray = move |m| {
        let mut numbers = Numbers::new(14 + n as u64, m);
        let (beta, gamma) = (numbers.between(0.0, 1.0), numbers.between(0.0, 1.0));
        let aim = along * beta + (middle + across * (1.0 / aspect)) * gamma;
        let slanted = along.cross(across) + numbers.triple(-0.5, 0.5);
        let back = slanted * numbers.between(2.0, 5.0);
        let (origin, way) = (a + aim + back, -back);
        Ray::derived(origin, way * (1.0 / way.magnitude()))
    };
    (0..rays).map(move |m| (corners, ray(m)))
}

/// The `t` of a ray at a triangle.
type Formula = fn(&[Point3; 3], &Ray) -> Option<f64>;

/// The relative errors of `t` for all rays whose exact barycentric coordinates
/// are not near 0. A miss counts as 1.
pub fn errors(needles: &[Needle], formula: Formula) -> Vec<f64> {
    let error = |(corners, ray): &Needle| {
        let [o, d] = arrays(ray);
        let exact = corners.map(|corner| corner.to_glam().to_array());
        let [t, beta, gamma] = exact::triangle(&exact, &o, &d);
        let [beta, gamma] = [beta.value(), gamma.value()];
        let least = beta.min(gamma).min(1.0 - beta - gamma);
        let found = formula(corners, ray);
        (least > 0.05).then(|| found.map_or(1.0, |found| t.error_of(found) / t.value()))
    };
    needles.iter().filter_map(error).collect()
}

/// The test of Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997.
fn moeller_trumbore(&[a, b, c]: &[Point3; 3], ray: &Ray) -> Option<f64> {
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

/// The renderer's test without the normal, with a given function for `a b - c d`.
fn woop(
    corners: &[Point3; 3],
    ray: &Ray,
    difference_of_products: impl Fn(f64, f64, f64, f64) -> f64,
) -> Option<f64> {
    let d = ray.direction().to_glam();
    let z = d.abs().max_position();
    let (x, y) = ((z + 1) % 3, (z + 2) % 3);
    let (shear_x, shear_y, scale_z) = (d[x] / d[z], d[y] / d[z], 1.0 / d[z]);
    let [a, b, c] = corners.map(|corner| {
        let p = (corner - ray.origin()).to_glam();
        [p[x] - shear_x * p[z], p[y] - shear_y * p[z], scale_z * p[z]]
    });
    let u = difference_of_products(c[0], b[1], c[1], b[0]);
    let v = difference_of_products(a[0], c[1], a[1], c[0]);
    let w = difference_of_products(b[0], a[1], b[1], a[0]);
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return None;
    }
    let determinant = u + v + w;
    if determinant == 0.0 {
        return None;
    }
    let t = (u * a[2] + v * b[2] + w * c[2]) / determinant;
    (t > 0.0).then_some(t)
}

/// The renderer's test.
pub fn plain(corners: &[Point3; 3], ray: &Ray) -> Option<f64> {
    woop(corners, ray, |a, b, c, d| a * b - c * d)
}

/// The renderer's test with Kahan's difference of products, whose error is at most
/// 1.5 units in the last place (Jeannerod, Louvet and Muller, 2013).
#[allow(
    clippy::disallowed_methods,
    reason = "one rounding instead of two is what the method lives on"
)]
pub fn compensated(corners: &[Point3; 3], ray: &Ray) -> Option<f64> {
    woop(corners, ray, |a, b, c, d| {
        let product = c * d;
        let lost = (-c).mul_add(d, product);
        a.mul_add(b, -product) + lost
    })
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let rays = effort.choose(4096, 65_536);
    let aspects = (0..=9).map(|power| libm::pow(8.0, power.into()));
    let sets: Vec<_> = aspects
        .map(|aspect| (aspect, needles(aspect, rays)))
        .collect();
    let curve = |method, slope: Option<f64>, formula: Formula| {
        let errors = |needles: &[_]| errors(needles, formula);
        let run = move |(corners, ray): &Needle| formula(corners, ray).unwrap_or_default();
        Curve::of_tasks(method, &sets, errors, run).with_slope(slope, (64.0, 2e8))
    };
    vec![
        curve("Cramer (protocol)", Some(1.0), protocol::triangle),
        curve("Moeller-Trumbore", Some(1.0), moeller_trumbore),
        curve("Woop (ours)", None, plain).with_remark(
            "dearer than the others, but loses no ray between two triangles: \
             see the extreme cases",
        ),
        curve("Woop (compensated)", Some(0.0), compensated).with_remark(
            "not in the renderer: only needles need it, and a build for any processor \
             computes fused multiply-add by a function call",
        ),
    ]
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "triangle-needle",
        about: "How thin may a triangle be?",
        knob: "length / height",
        work: "tests",
        error: "rms error of t",
        unit: Unit::Other("share of t"),
        exact: "against 30 digits, away from the edges; half of the rays hit",
        seeds: &[13, 14],
        against: Axis::Knob,
        curves: Box::new(curves),
    }
}
