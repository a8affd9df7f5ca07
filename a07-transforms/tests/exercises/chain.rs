//! Chains of up to five steps: their effect on points, step by step; both matrices undo
//! each other.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval};
use a05_lighting::Lambert;
use a07_transforms::Mat4x4;
use common::Color;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::steps::{ABOVE, Step, expect_scene, hit_of_child, lit_from, point, steps_of_box};

/// Rounding errors of coordinates up to 1e4.
const BOUND: Bound = Bound::Absolute(1e-9);

pub fn check(check: &mut Check, chain: impl Fn(&[Step]) -> [Mat4x4; 2]) {
    let mut random = Random::new(71);
    let mut case = |kind: &str, steps: &[Step], p: Point3| {
        let [matrix, inverse] = chain(steps);
        // The last step is applied first.
        let moved = steps.iter().rev().fold(p, |p, step| step.matrix() * p);
        let words = format!("chain {steps:.2?}, point {:.2}", p.to_glam());
        let mut expect = |what: &str, exact: Point3, got: Point3| {
            let [exact, got] = [exact, got].map(|p| p.to_glam().to_array());
            check.expect(format!("{what}, {kind}; {words}"), exact, BOUND, got);
        };
        expect("the matrix times a point", moved, matrix * p);
        expect("the inverse times the moved point", p, inverse * moved);
    };
    let (turn, step) = (
        Step::RotateZ(std::f64::consts::FRAC_PI_2),
        Step::Translate([2.0, 0.0, 0.0]),
    );
    let x = Point3::new(1.0, 0.0, 0.0);
    case("no step", &[], x);
    case("one step", &[step], x);
    case("two steps", &[step, turn], x);
    case("two steps", &[turn, step], x);
    for count in [1, 2, 3, 4, 5, 2, 3, 4] {
        let steps: Vec<_> = (0..count).map(|_| Step::random(&mut random)).collect();
        case("some steps", &steps, point(&mut random, 3.0));
    }
    let [_, inverse] = chain(&steps_of_box());
    expect_scene(check, "box-transformations", 10.0, || {
        let (lbf, run) = (Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
        let child = AxisAlignedBox::new(lbf, run)?;
        let world = lit_from(ABOVE, false, 0.25)?;
        let moved = Moved { child, inverse };
        Ok(world.with(moved, Box::new(Lambert::new(Color::YELLOW)?)))
    });
}

/// A box under a matrix with this inverse.
#[derive(Debug)]
struct Moved {
    child: AxisAlignedBox,
    inverse: Mat4x4,
}

impl Geometry for Moved {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let i = self.inverse;
        let to_object = |ray: &Ray| Ray::derived(i * ray.origin(), i * ray.direction());
        let from_object = |n: Normal3| {
            let n = i.transposed() * Vector3::from(n);
            n.normalized().map(Vector3::as_normal)
        };
        hit_of_child(&self.child, ray, within, &to_object, &from_object)
    }
}
