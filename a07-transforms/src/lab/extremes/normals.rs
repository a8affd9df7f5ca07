//! Normals under scalings, rotations and reflections.

use std::f64::consts::FRAC_PI_2;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a04_intersections::{Interval, Sphere, World};
use common::{ArgumentError, Color};
use measure::extremes::Protocol::Fails;
use measure::extremes::{Bound, Case, Outcome};

use super::{numbers, ray};
use crate::{Mat4x4, Node, Transform, protocol};

type Step = Result<Transform, ArgumentError>;
type Moved = fn(Mat4x4, Normal3) -> Option<Normal3>;

pub fn cases() -> Vec<Case> {
    let step = Transform::IDENTITY;
    let slant = Normal3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0);
    let right = Normal3::new(1.0, 0.0, 0.0);
    let fifth = 0.2_f64.sqrt();
    let as_vector: Moved = protocol::normal_as_vector;
    let transposed: Moved = protocol::transposed_normal;
    vec![
        normal(
            "G10",
            "(1, 1, 0) under scale (1, 1/2, 1)",
            slant,
            step.scale(1.0, 0.5, 1.0),
            [fifth, 2.0 * fifth, 0.0],
            as_vector,
        ),
        normal(
            "G11",
            "(1, 1, 0) under scale (1, 1e-8, 1)",
            slant,
            step.scale(1.0, 1e-8, 1.0),
            [1e-8, 1.0, 0.0],
            as_vector,
        ),
        lambert("G12"),
        mirrored("G13"),
        normal(
            "G19",
            "(1, 0, 0) under rotate_z π/2",
            right,
            step.rotate_z(FRAC_PI_2),
            [0.0, 1.0, 0.0],
            transposed,
        ),
        normal(
            "G20",
            "(1, 1, 0) under scale (1, 1/2, 1), only transposed",
            slant,
            step.scale(1.0, 0.5, 1.0),
            [fifth, 2.0 * fifth, 0.0],
            transposed,
        ),
        normal(
            "G31",
            "(0, 1, 0) under translate (1, 2, 3), moved like a point",
            Normal3::new(0.0, 1.0, 0.0),
            step.translate(Point3::new(1.0, 2.0, 3.0)),
            [0.0, 1.0, 0.0],
            protocol::normal_as_point,
        ),
    ]
}

fn normal(
    id: &'static str,
    what: &str,
    n: Normal3,
    transform: Step,
    exact: [f64; 3],
    theirs: Moved,
) -> Case {
    let what = format!("the normal {what}");
    let bound = Bound::Absolute(4.0 * f64::EPSILON);
    let theirs = transform.clone().map_or(Outcome::Refused, |t| {
        theirs(t.matrix(), n).map(numbers).into()
    });
    let ours = transform.map_or(Outcome::Refused, |t| {
        t.normal_from_object(n).map(numbers).into()
    });
    Case::new(id, what, exact, bound, ours).protocol(Fails, theirs)
}

/// An object twice as large is as bright under a light straight above.
fn lambert(id: &'static str) -> Case {
    let (up, light) = (Normal3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
    let double = Transform::IDENTITY.scale(2.0, 2.0, 2.0);
    let theirs = double
        .clone()
        .map(|t| light.dot(protocol::unnormalized_normal(t.inverse(), up)));
    let ours = double.map_or(Outcome::Refused, |t| {
        t.normal_from_object(up).map(|n| n.dot(light)).into()
    });
    let bound = Bound::Absolute(2.0 * f64::EPSILON);
    Case::new(
        id,
        "n · l under scale 2, light from above",
        1.0,
        bound,
        ours,
    )
    .protocol(Fails, theirs)
}

/// A mirrored sphere still faces the eye.
fn mirrored(id: &'static str) -> Case {
    let seen = || {
        let mirror = Transform::IDENTITY.scale(-1.0, 1.0, 1.0)?;
        let sphere = Node::new(mirror).with(Sphere::new(Point3::new(-2.0, 0.0, 0.0), 1.0)?);
        let world = World::new(Color::BLACK)?.with(sphere, ());
        let hit = world.hit(&ray([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), Interval::AHEAD);
        Ok::<_, ArgumentError>(hit.map(|(hit, ())| numbers(hit.normal)))
    };
    let ours = seen().map_or(Outcome::Refused, Outcome::from);
    let what = "the normal towards the eye under scale (-1, 1, 1)";
    Case::new(id, what, [1.0, 0.0, 0.0], Bound::Equal, ours)
}
