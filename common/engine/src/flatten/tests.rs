//! Tests of `flatten`: compared with exact arithmetic, the errors of both ways to
//! transform a ray add up to less than the bound.

use glam::DVec3;

use super::*;
use crate::Ray;
use crate::adaptive::PixelRandom;
use crate::lanes::RayPacket;
use crate::shape::{Shape, Sphere};

/// A sum of two doubles, the second below the last digit of the first: some 30 digits
/// (Dekker, A Floating-Point Technique for Extending the Available Precision, 1971).
#[derive(Clone, Copy)]
struct Exact(f64, f64);

impl Exact {
    fn sum(a: f64, b: f64) -> Self {
        let s = a + b;
        let b_in_s = s - a;
        Self(s, (a - (s - b_in_s)) + (b - b_in_s))
    }

    fn plus(self, other: Self) -> Self {
        let s = Self::sum(self.0, other.0);
        Self::sum(s.0, s.1 + self.1 + other.1)
    }

    fn times(self, b: f64) -> Self {
        let halves = |x: f64| {
            let c = 134_217_729.0 * x;
            let high = c - (c - x);
            (high, x - high)
        };
        let (p, (a1, a2), (b1, b2)) = (self.0 * b, halves(self.0), halves(b));
        let rest = ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
        Self::sum(p, rest + self.1 * b)
    }
}

/// Three coordinates moved by all inverses, `w` being 1 for a point and 0 for a vector.
fn exact(steps: &[Transform], x: DVec3, w: f64) -> [Exact; 3] {
    let start = x.to_array().map(|x| Exact(x, 0.0));
    steps.iter().fold(start, |x, step| {
        let rows = step.inverse.transpose().to_cols_array_2d();
        rows.first_chunk::<3>().unwrap().map(|row| {
            let terms = (0..3).map(|j| x[j].times(row[j]));
            terms.fold(Exact(w * row[3], 0.0), Exact::plus)
        })
    })
}

/// A ray moved by all inverses.
fn moved_by(steps: &[Transform], ray: &Ray) -> Ray {
    let rays = RayPacket::new([ray; 4]);
    let [moved, ..] = steps
        .iter()
        .fold(rays, |rays, step| step.rays(&rays))
        .to_rays();
    moved
}

/// The distance of a moved ray at `t` from its exact position, in the outer space.
fn error(steps: &[Transform], ray: &Ray, moved: &Ray, t: f64) -> f64 {
    let part = |x: DVec3, exact: [Exact; 3]| {
        let x = x.to_array();
        std::array::from_fn::<_, 3, _>(|i| Exact(x[i] - exact[i].0, -exact[i].1))
    };
    let o = part(moved.origin, exact(steps, ray.origin, 1.0));
    let d = part(moved.direction, exact(steps, ray.direction, 0.0));
    let x = std::array::from_fn::<_, 3, _>(|i| o[i].plus(d[i].times(t)).0);
    let outwards = steps.iter().rev();
    let moved = |x, step: &Transform| step.matrix.transform_vector3(x);
    outwards.fold(DVec3::from(x), moved).length()
}

fn step(matrix: DMat4, inverse: DMat4) -> Transform {
    Transform { matrix, inverse }
}

fn moved(x: f64) -> Transform {
    let by = |x| DMat4::from_translation(DVec3::new(x, 0.0, 0.0));
    step(by(x), by(-x))
}

/// A random translation, rotation and uneven scaling.
fn anywhere(random: PixelRandom, level: u64) -> Transform {
    let number = |n| 2.0 * random.uniform(10 * level + n) - 1.0;
    let factor = |n| libm::exp2(number(n));
    let to = DVec3::new(number(0), 3.0 * number(1), number(2));
    let stretch = DVec3::new(factor(4), factor(5), -factor(6));
    let (turn_x, turn_z) = (3.0 * number(3), 3.0 * number(7));
    step(
        DMat4::from_translation(to)
            * DMat4::from_rotation_x(turn_x)
            * DMat4::from_scale(stretch)
            * DMat4::from_rotation_z(turn_z),
        DMat4::from_rotation_z(-turn_z)
            * DMat4::from_scale(stretch.recip())
            * DMat4::from_rotation_x(-turn_x)
            * DMat4::from_translation(-to),
    )
}

/// A point at most `far` from the origin.
fn point(random: PixelRandom, first: u64, far: f64) -> DVec3 {
    let x = [0, 1, 2].map(|i| 2.0 * random.uniform(first + i) - 1.0);
    DVec3::from(x) * (far / 3_f64.sqrt())
}

#[test]
fn displacements_stay_below_the_bound() {
    let (mut worst, far) = (0.0_f64, 10.0);
    for n in 0..3000 {
        let random = PixelRandom::new(31, n, 0);
        let levels = u64::from(2 + n % 5);
        let mut steps: Vec<_> = (0..levels).map(|level| anywhere(random, level)).collect();
        if n % 3 == 0 {
            // Far away, and back.
            steps.insert(0, moved(1e5 / 3.0));
            steps.push(moved(-1e5 / 3.0));
        }
        let (o, x) = (point(random, 100, far), point(random, 110, far));
        let ray = Ray {
            origin: o,
            direction: (x - o).normalize(),
        };
        let (flat, bound) = product(&steps, far);
        let error = |moved: Ray| error(&steps, &ray, &moved, (x - o).length());
        let errors = error(moved_by(&steps, &ray)) + error(moved_by(&[flat], &ray));
        assert!(errors < bound, "{errors} of {bound}, {levels} levels");
        worst = worst.max(errors / bound);
    }
    // The bound is small enough to be of use.
    assert!(worst > 1e-3, "{worst}");
}

/// Two transforms: inwards they make an eighth of a length, and 1.5 / 4 + 2 of none;
/// outwards eight times as much.
#[test]
fn the_displacement_comes_from_two_roundings_of_both_ways() {
    let step = |y: f64, s: f64| {
        let moved = |y| DMat4::from_translation(DVec3::new(0.0, y, 0.0));
        let scaled = |s| DMat4::from_scale(DVec3::splat(s));
        step(moved(y) * scaled(s), scaled(1.0 / s) * moved(-y))
    };
    let steps = [step(3.0, 2.0), step(8.0, 4.0)];
    let rounding = 16.0 * f64::EPSILON * 2.0 * 8.0;
    for far in [0.0, 1.0, 8.0] {
        let (_, displacement) = product(&steps, far);
        assert_eq!(displacement, rounding * (3.0 * far / 8.0 + 2.375));
    }
}

fn nested(steps: &[Transform]) -> Transformed<'static> {
    let sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let inwards = steps.iter().rev();
    let shape = inwards.fold(Shape::Sphere(sphere), Shape::transformed);
    match shape {
        Shape::Transformed(shape) => shape,
        _ => unreachable!("there are steps"),
    }
}

/// Transforms that move too far for the bound stay as they are, and so do those with a product
/// that is not well conditioned.
#[test]
fn only_products_within_the_bound_are_taken() {
    for (far, is_flat) in [(1e6, true), (1e12, false)] {
        let mut shape = nested(&[moved(far), moved(-far)]);
        flatten(&mut shape, 10.0, 1.0 / 510.0);
        assert_eq!(shape.steps.len(), if is_flat { 1 } else { 2 }, "{far}");
    }
    let scaled = |s| DMat4::from_scale(DVec3::splat(s));
    let small = step(scaled(1e-60), scaled(1e60));
    let mut shape = nested(&[small, small]);
    flatten(&mut shape, 10.0, 1.0);
    assert_eq!(shape.steps.len(), 2);
}
