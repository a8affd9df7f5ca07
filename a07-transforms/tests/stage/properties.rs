//! Laws of all matrices, transforms and nodes.
//!
//! The same cases come every time; `PROPTEST_CASES=100000` makes more of them.
//! In the bounds u is the unit of rounding, half of eps. Terms with u² are left
//! out, and the bounds rounded up.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere};
use a07_transforms::{Disc, Mat4x4, Node, Transform};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const EPS: f64 = f64::EPSILON;

fn config() -> ProptestConfig {
    ProptestConfig {
        // A failure is printed, and comes again without a file that tells of it.
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    }
}

/// Of either sign, up to 2^20 and down to 2^-20 and 0.
fn number() -> impl Strategy<Value = f64> {
    let numbers = (-1.0..1.0, -20..=20).prop_map(|(x, exponent)| libm::scalbn(x, exponent));
    prop_oneof![9 => numbers, 1 => Just(0.0)]
}

type Rows = [[f64; 4]; 4];

/// A matrix with the last row of all affine transforms.
fn rows() -> impl Strategy<Value = Rows> {
    prop::array::uniform3(prop::array::uniform4(number()))
        .prop_map(|[x, y, z]| [x, y, z, [0.0, 0.0, 0.0, 1.0]])
}

/// All numbers without their signs: rounding errors are relative to them.
fn unsigned(matrix: Mat4x4) -> Mat4x4 {
    Mat4x4::from_rows(matrix.rows().map(|row| row.map(f64::abs)))
}

/// Whether two matrices are apart by at most `bound` of a third, entry by entry.
fn are_close(one: Mat4x4, other: Mat4x4, bound: f64, of: Mat4x4) -> bool {
    let [one, other, of] = [one, other, of].map(|m| m.rows().concat());
    let pairs = one.iter().zip(&other).zip(&of);
    pairs
        .into_iter()
        .all(|((a, b), of)| (a - b).abs() <= bound * of)
}

/// A step of a transform.
#[derive(Clone, Copy, Debug)]
enum Step {
    Translate(f64, f64, f64),
    Scale(f64, f64, f64),
    Rotate(u32, f64),
}

impl Step {
    fn after(self, transform: Transform) -> Transform {
        let chained = match self {
            Self::Translate(x, y, z) => transform.translate(Point3::new(x, y, z)),
            Self::Scale(x, y, z) => transform.scale(x, y, z),
            Self::Rotate(0, angle) => transform.rotate_x(angle),
            Self::Rotate(1, angle) => transform.rotate_y(angle),
            Self::Rotate(_, angle) => transform.rotate_z(angle),
        };
        chained.expect("a step")
    }
}

fn step() -> impl Strategy<Value = Step> {
    let way = || -100.0..100.0;
    let factor = || prop_oneof![0.001..1000.0, -1000.0..-0.001];
    prop_oneof![
        (way(), way(), way()).prop_map(|(x, y, z)| Step::Translate(x, y, z)),
        (factor(), factor(), factor()).prop_map(|(x, y, z)| Step::Scale(x, y, z)),
        (0..3_u32, -10.0..10.0).prop_map(|(axis, angle)| Step::Rotate(axis, angle)),
    ]
}

/// A multiple of 1/8 up to 16.
fn eighths() -> impl Strategy<Value = f64> {
    (-128..=128).prop_map(|n| f64::from(n) / 8.0)
}

fn place() -> impl Strategy<Value = Point3> {
    prop::array::uniform3(eighths()).prop_map(|[x, y, z]| Point3::new(x, y, z))
}

proptest! {
    #![proptest_config(config())]

    /// The same products, added up in the same order.
    #[test]
    fn a_transposed_product_is_the_product_of_the_transposed(a in rows(), b in rows()) {
        let [a, b] = [a, b].map(Mat4x4::from_rows);
        prop_assert_eq!((a * b).transposed(), b.transposed() * a.transposed());
    }

    /// Each of the two products on each side is off by 4u of |A| |B| |C|.
    #[test]
    fn it_does_not_matter_which_product_comes_first(a in rows(), b in rows(), c in rows()) {
        let [a, b, c] = [a, b, c].map(Mat4x4::from_rows);
        let all = unsigned(a) * unsigned(b) * unsigned(c);
        prop_assert!(are_close((a * b) * c, a * (b * c), 9.0 * EPS, all));
    }

    /// Each step multiplies, which costs 4u on the way there and 4u on the way
    /// back, and is undone by its inverse but for 4u: the error of two squares of
    /// libm's sine and cosine, which are right to a unit in the last place. The
    /// last product costs 4u. All relative to the steps without their signs.
    #[test]
    fn what_a_chain_does_its_inverse_undoes(steps in prop::collection::vec(step(), 0..7)) {
        let (mut chain, mut there, mut back) =
            (Transform::IDENTITY, Mat4x4::IDENTITY, Mat4x4::IDENTITY);
        for step in &steps {
            let alone = step.after(Transform::IDENTITY);
            chain = step.after(chain);
            there = there * unsigned(alone.matrix());
            back = unsigned(alone.inverse()) * back;
        }
        let bound = (6.0 * steps.len() as f64 + 3.0) * EPS;
        let (m, i) = (chain.matrix(), chain.inverse());
        prop_assert!(are_close(m * i, Mat4x4::IDENTITY, bound, there * back));
        prop_assert!(are_close(i * m, Mat4x4::IDENTITY, bound, back * there));
    }

    /// Moved by eighths and stretched by powers of two nothing is rounded on the
    /// way into the node, so that `t` equals the `t` of a shape that lies there.
    #[test]
    fn a_node_with_an_exact_transform_is_hit_at_the_same_t(
        c in place(), r in 1..64_u32, k in -3..=3, way in place(), from in place(), to in place(),
    ) {
        let s = libm::scalbn(1.0, k);
        let moved = |p: Point3| Point3::from_glam(p.to_glam() * s + way.to_glam());
        let transform = Transform::IDENTITY.translate(way).unwrap().scale(s, s, s).unwrap();
        let Ok(ray) = Ray::new(from, to - from) else {
            return Ok(());
        };
        let r = f64::from(r) / 8.0;
        let corner = c + Vector3::new(r, 2.0 * r, 0.5 * r);
        let boxes = [(c, corner), (moved(c), moved(corner))];
        let [inner, outer] = boxes.map(|(a, b)| AxisAlignedBox::new(a, b).unwrap());
        let t = |shape: &dyn Geometry| shape.hit(&ray, Interval::AHEAD).map(|hit| hit.t);
        prop_assert_eq!(t(&Node::new(transform).with(inner)), t(&outer));
        let inner = Sphere::new(c, r).unwrap();
        let outer = Sphere::new(moved(c), r * s).unwrap();
        prop_assert_eq!(t(&Node::new(transform).with(inner)), t(&outer));
    }

    /// Bound: 8 eps of the way and the coordinates, as for all shapes.
    #[test]
    fn a_hit_of_a_disc_is_one_of_its_plane_and_within_its_radius(
        c in place(), n in place(), r in 0.1..8.0, from in place(), to in place(),
    ) {
        let n = Normal3::from_glam(n.to_glam());
        let (Ok(disc), Ok(ray)) = (Disc::new(c, n, r), Ray::new(from, to - from)) else {
            return Ok(());
        };
        if let Some(hit) = disc.hit(&ray, Interval::AHEAD) {
            let plane = Plane::new(c, n).unwrap();
            prop_assert_eq!(plane.hit(&ray, Interval::AHEAD), Some(hit));
            let p = ray.at(hit.t);
            let off = 8.0 * EPS * (hit.t + from.largest_coordinate() + p.largest_coordinate());
            prop_assert!((p - c).magnitude() <= r + off);
        }
    }
}
