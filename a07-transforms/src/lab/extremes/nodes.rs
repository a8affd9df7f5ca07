//! Hits through nodes.

use std::f64::consts::{FRAC_PI_2, TAU};

use a02_math::Point3;
use a03_rays_cameras::PixelRandom;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Sphere};
use common::ArgumentError;
use measure::Effort;
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::ray;
use crate::{Node, Transform, protocol};

pub fn cases(effort: Effort) -> Vec<Case> {
    // Exact roots of the quadratic of these numbers; the bounds are 4 eps
    // |o| / cos, in the space of the sphere and in units of the direction.
    vec![
        ellipsoid(
            "G14",
            "oblique",
            ([3e-8, 2.0, 1.5e8], [-2.5e-8, -1.9, -1.2e8]),
            0.871_375_248_053_142_6,
            1.066e-15,
        ),
        ellipsoid(
            "G29",
            "along its thin axis",
            ([5e-8, 0.25, 0.0], [-1e-8, 0.01, 1e6]),
            4.043_961_576_572_06,
            4.667e-15,
        ),
        ellipsoid(
            "G30",
            "from above",
            ([0.0, 4.0, 3e8], [0.0, -1.0, -0.8e8]),
            3.131_151_790_202_834_3,
            3.511e-15,
        ),
        first(
            "G15",
            "100 nodes of a hundredth of a turn around a box",
            ([2.0, 0.25, 5.0], [0.0, 0.0, -1.0]),
            4.5,
            400.0 * 5.0 * f64::EPSILON,
            nested_turns(),
        ),
        rotated_box("G16", effort.choose(2_000, 20_000)),
        first(
            "G17",
            "a child 4 away, and one 5 away that is 10 times larger",
            OUT_OF_Z,
            4.0,
            0.0,
            small_and_large(),
        ),
        order("G18", "children at 2 and 5", [2.0, 5.0], Fails),
        order("G21", "children at 5 and 2", [5.0, 2.0], Holds),
    ]
}

type Made<T> = Result<T, ArgumentError>;

const OUT_OF_Z: ([f64; 3], [f64; 3]) = ([0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);

fn unit_box() -> Made<AxisAlignedBox> {
    AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5))
}

/// The `t` of the first hit of a geometry.
fn first(
    id: &'static str,
    what: &str,
    (o, d): ([f64; 3], [f64; 3]),
    exact: f64,
    bound: f64,
    geometry: Made<Node>,
) -> Case {
    let ours = geometry.map_or(Outcome::Refused, |geometry| {
        let hit = geometry.hit(&ray(o, d), Interval::AHEAD);
        hit.map(|hit| hit.t).into()
    });
    Case::new(
        id,
        format!("{what}: t"),
        exact,
        Bound::Absolute(bound),
        ours,
    )
}

fn ellipsoid(
    id: &'static str,
    what: &str,
    (o, d): ([f64; 3], [f64; 3]),
    exact: f64,
    bound: f64,
) -> Case {
    let node = || {
        let transform = Transform::IDENTITY.scale(1e-8, 1.0, 1e8)?;
        Ok(Node::new(transform).with(Sphere::new(Point3::ORIGIN, 1.0)?))
    };
    let what = format!("sphere under scale (1e-8, 1, 1e8), {what}");
    first(id, &what, (o, d), exact, bound, node())
}

/// The rotations add up to a full turn, which returns the box to its position
/// beside the axis.
fn nested_turns() -> Made<Node> {
    let beside = Transform::IDENTITY.translate(Point3::new(2.0, 0.0, 0.0))?;
    (0..100).try_fold(Node::new(beside).with(unit_box()?), |node, _| {
        let turn = Transform::IDENTITY.rotate_z(TAU / 100.0)?;
        Ok(Node::new(turn).with(node))
    })
}

fn small_and_large() -> Made<Node> {
    let large = Transform::IDENTITY.scale(10.0, 10.0, 10.0)?;
    Ok(Node::new(Transform::IDENTITY)
        .with(Node::new(large).with(Sphere::new(Point3::new(0.0, 0.0, -1.0), 1.0)?))
        .with(Sphere::new(Point3::ORIGIN, 1.0)?))
}

/// Rays along the normal of a face that a quarter turn has made almost parallel to
/// an axis: π/2 is not exact in 53 binary digits.
fn rotated_box(id: &'static str, rays: usize) -> Case {
    let wrong = || {
        let quarter = Transform::IDENTITY.rotate_z(FRAC_PI_2)?;
        let node = Node::new(quarter).with(unit_box()?);
        let random = PixelRandom::new(16, 0, 0);
        let place = |n: usize| 0.999 * (random.uniform(n as u64) - 0.5);
        let misses = |i: &usize| {
            let ray = ray([place(2 * i), 4.5, place(2 * i + 1)], [0.0, -1.0, 0.0]);
            let hit = node.hit(&ray, Interval::AHEAD);
            hit.is_none_or(|hit| (hit.t - 4.0).abs() > 8.0 * f64::EPSILON)
        };
        Ok::<_, ArgumentError>((0..rays).filter(misses).count())
    };
    let what = format!("a box under rotate_z π/2, {rays} rays: not hit at 4");
    Case::new(id, what, 0.0, Bound::Equal, wrong())
}

/// The nearer of two spheres of a node, whose nearest points have these distances.
fn order(id: &'static str, what: &str, distances: [f64; 2], says: Protocol) -> Case {
    let ray = ray([0.0; 3], [0.0, 0.0, -1.0]);
    let sphere = |t: f64| Sphere::new(Point3::new(0.0, 0.0, -t - 1.0), 1.0);
    let theirs = || {
        let [a, b] = distances.map(sphere);
        let children: [Box<dyn Geometry>; 2] = [Box::new(a?), Box::new(b?)];
        Ok::<_, ArgumentError>(protocol::last_hit(&children, &ray).map(|hit| hit.t))
    };
    let ours = || {
        let [a, b] = distances.map(sphere);
        Ok(Node::new(Transform::IDENTITY).with(a?).with(b?))
    };
    let exact = distances[0].min(distances[1]);
    first(id, what, ([0.0; 3], [0.0, 0.0, -1.0]), exact, 0.0, ours())
        .protocol(says, theirs().map_or(Outcome::Refused, Outcome::from))
}
