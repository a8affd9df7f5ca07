//! Hits through nodes, normals under scalings, rotations and reflections, and rays that leave
//! shapes under transforms of every size.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::mem;

use a02_math::arrays::array;
use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use a04_intersections::{AxisAlignedBox, Interval, Sphere};
use a04_lab::support::{Line, Triple, first, point, raw_ray};
use a06_lab::surface::world;
use common::{ArgumentError, Error};
use measure::Effort;
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Id, Protocol, tried};

use crate::protocol::{self, normal_as_point, normal_as_vector, transposed_normal};
use a07_transforms::kinds::KINDS;
use a07_transforms::{Mat4x4, Node, Transform};

/// The `t` of the first hit of a node.
fn t(id: Id, what: &str, line: Line, exact: f64, bound: f64, node: Result<Node, Error>) -> Case {
    let ours = node.map(|node| first(&node, &raw_ray(line)));
    Case::new(id, format!("{what}: t"), exact, Absolute(bound), ours)
}

pub fn cases(effort: Effort) -> Vec<Case> {
    [normals(), hits(effort)].concat()
}

#[rustfmt::skip]
fn hits(effort: Effort) -> Vec<Case> {
    let along_z = ([0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    vec![
        // Exact roots of the quadratic of these numbers; the bounds are 4 eps
        // |o| / cos, in the space of the sphere and in units of the direction.
        t("G14", "sphere under scale (1e-8, 1, 1e8), oblique",
            ([3e-8, 2.0, 1.5e8], [-2.5e-8, -1.9, -1.2e8]), 0.871_375_248_053_142_6, 1.066e-15, ellipsoid()),
        t("G29", "sphere under scale (1e-8, 1, 1e8), along its thin axis",
            ([5e-8, 0.25, 0.0], [-1e-8, 0.01, 1e6]), 4.043_961_576_572_06, 4.667e-15, ellipsoid()),
        t("G30", "sphere under scale (1e-8, 1, 1e8), from above",
            ([0.0, 4.0, 3e8], [0.0, -1.0, -0.8e8]), 3.131_151_790_202_834_3, 3.511e-15, ellipsoid()),
        t("G15", "100 nodes of a hundredth of a turn around a box",
            ([2.0, 0.25, 5.0], [0.0, 0.0, -1.0]), 4.5, 400.0 * 5.0 * f64::EPSILON, nested_turns()),
        rotated_box("G16", effort.choose(2_000, 20_000)),
        t("G17", "a child 4 away, and one 5 away that is 10 times larger", along_z, 4.0, 0.0, small_and_large()),
        order("G18", "children at 2 and 5", [2.0, 5.0], Fails),
        order("G21", "children at 5 and 2", [5.0, 2.0], Holds),
    ]
}

fn unit_box() -> Result<AxisAlignedBox, ArgumentError> {
    AxisAlignedBox::new(point([-0.5; 3]), point([0.5; 3]))
}

/// A ball of radius 1.
fn ball(x: f64, z: f64) -> Result<Sphere, ArgumentError> {
    Sphere::new(Point3::new(x, 0.0, z), 1.0)
}

fn ellipsoid() -> Result<Node, Error> {
    let transform = Transform::IDENTITY.scale(1e-8, 1.0, 1e8)?;
    Ok(Node::new(transform).with(ball(0.0, 0.0)?))
}

/// The rotations add up to a full turn, which returns the box to its position
/// beside the axis.
fn nested_turns() -> Result<Node, Error> {
    let beside = Transform::IDENTITY.translate(Point3::new(2.0, 0.0, 0.0))?;
    (0..100).try_fold(Node::new(beside).with(unit_box()?), |node, _| {
        let turn = Transform::IDENTITY.rotate_z(TAU / 100.0)?;
        Ok(Node::new(turn).with(node))
    })
}

fn small_and_large() -> Result<Node, Error> {
    let large = Transform::IDENTITY.scale(10.0, 10.0, 10.0)?;
    let large = Node::new(large).with(ball(0.0, -1.0)?);
    let both = Node::new(Transform::IDENTITY).with(large);
    Ok(both.with(ball(0.0, 0.0)?))
}

/// Rays along the normal of a face that a quarter turn has made almost parallel to
/// an axis: π/2 is not exact in 53 binary digits.
fn rotated_box(id: Id, rays: usize) -> Case {
    let misses = tried(|| {
        let node = Node::new(Transform::IDENTITY.rotate_z(FRAC_PI_2)?).with(unit_box()?);
        let random = PixelRandom::new(16, 0, 0);
        let place = |n: usize| 0.999 * (random.uniform(n as u64) - 0.5);
        let misses = |i: &usize| {
            let ray = raw_ray(([place(2 * i), 4.5, place(2 * i + 1)], [0.0, -1.0, 0.0]));
            first(&node, &ray).is_none_or(|t| (t - 4.0).abs() > 8.0 * f64::EPSILON)
        };
        Ok((0..rays).filter(misses).count())
    });
    let what = format!("a box under rotate_z π/2, {rays} rays: not hit at 4");
    Case::new(id, what, 0.0, Equal, misses)
}

/// The nearer of two balls of a node, whose nearest points have these distances.
fn order(id: Id, what: &str, [a, b]: [f64; 2], says: Protocol) -> Case {
    let line = ([0.0; 3], [0.0, 0.0, -1.0]);
    let node = || {
        let first = Node::new(Transform::IDENTITY).with(ball(0.0, -a - 1.0)?);
        Ok(first.with(ball(0.0, -b - 1.0)?))
    };
    let last = |mut node: Node| {
        let children = KINDS.children_mut(&mut node).map(mem::take);
        protocol::last_hit(&children.unwrap_or_default(), &raw_ray(line))
    };
    let theirs = tried(|| Ok(node().map(last)?.map(|hit| hit.t)));
    t(id, what, line, a.min(b), 0.0, node()).protocol(says, theirs)
}

/// The protocol's normal of a transformed object.
type Theirs = fn(Mat4x4, Normal3) -> Option<Normal3>;

#[rustfmt::skip]
fn normals() -> Vec<Case> {
    let step = Transform::IDENTITY;
    let (root, fifth) = (0.5_f64.sqrt(), 0.2_f64.sqrt());
    let [slant, right, up] = [[root, root, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        .map(|n| Normal3::from_glam(n.into()));
    // An object twice as large is as bright under a light straight above.
    let (light, double) = (Vector3::from(up), step.scale(2.0, 2.0, 2.0));
    let dark = double.clone().map(|t| light.dot(protocol::unnormalized_normal(t.inverse(), up)));
    let bright = double.map(|t| t.normal_from_object(up).map(|n| n.dot(light)));
    // A mirrored ball still faces the eye.
    let mirrored = tried(|| {
        let ball = Node::new(step.scale(-1.0, 1.0, 1.0)?).with(ball(-2.0, 0.0)?);
        let ray = raw_ray(([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
        Ok(world(ball)?.hit(&ray, Interval::AHEAD).map(|(hit, ())| array(hit.normal)))
    });
    let normal = |id, what: &str, n, transform: Result<Transform, _>, exact: Triple, theirs: Theirs| {
        let theirs = transform.clone().map(|t| theirs(t.matrix(), n).map(array));
        let ours = transform.map(|t| t.normal_from_object(n).map(array));
        let bound = Absolute(4.0 * f64::EPSILON);
        Case::new(id, format!("the normal {what}"), exact, bound, ours).protocol(Fails, theirs)
    };
    vec![
        normal("G10", "(1, 1, 0) under scale (1, 1/2, 1)",
            slant, step.scale(1.0, 0.5, 1.0), [fifth, 2.0 * fifth, 0.0], normal_as_vector),
        normal("G11", "(1, 1, 0) under scale (1, 1e-8, 1)",
            slant, step.scale(1.0, 1e-8, 1.0), [1e-8, 1.0, 0.0], normal_as_vector),
        Case::new("G12", "n · l under scale 2, light from above", 1.0, Absolute(2.0 * f64::EPSILON), bright)
            .protocol(Fails, dark),
        Case::new("G13", "the normal towards the eye under scale (-1, 1, 1)", [1.0, 0.0, 0.0], Equal, mirrored),
        normal("G19", "(1, 0, 0) under rotate_z π/2",
            right, step.rotate_z(FRAC_PI_2), [0.0, 1.0, 0.0], transposed_normal),
        normal("G20", "(1, 1, 0) under scale (1, 1/2, 1), only transposed",
            slant, step.scale(1.0, 0.5, 1.0), [fifth, 2.0 * fifth, 0.0], transposed_normal),
        normal("G31", "(0, 1, 0) under translate (1, 2, 3), moved like a point",
            up, step.translate(Point3::new(1.0, 2.0, 3.0)), [0.0, 1.0, 0.0], normal_as_point),
    ]
}
