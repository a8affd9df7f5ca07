//! Normals under scalings, rotations and reflections.

use std::f64::consts::FRAC_PI_2;

use a02_math::{Direction, Normal3, Point3, Vector3};
use a04_intersections::lab::support::raw_ray;
use a04_intersections::{Interval, Sphere, World};
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Case, Equal, Fails, Id, tried};

use crate::lab::protocol;
use crate::{Mat4x4, Node, Transform};

fn normal(
    id: Id,
    what: &str,
    n: Normal3,
    transform: Result<Transform, ArgumentError>,
    exact: [f64; 3],
    theirs: fn(Mat4x4, Normal3) -> Option<Normal3>,
) -> Case {
    let theirs = transform.clone().map(|t| theirs(t.matrix(), n));
    let ours = transform.map(|t| t.normal_from_object(n));
    let bound = Absolute(4.0 * f64::EPSILON);
    Case::new(id, format!("the normal {what}"), exact, bound, ours).protocol(Fails, theirs)
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let step = Transform::IDENTITY;
    let (root, fifth) = (0.5_f64.sqrt(), 0.2_f64.sqrt());
    let [slant, right, up] = [[root, root, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        .map(|n| Normal3::from_glam(n.into()));
    let as_vector = protocol::normal_as_vector;
    let transposed = protocol::transposed_normal;
    // An object twice as large is as bright under a light straight above.
    let (light, double) = (Vector3::from(up), step.scale(2.0, 2.0, 2.0));
    let dark = double.clone().map(|t| light.dot(protocol::unnormalized_normal(t.inverse(), up)));
    let bright = double.map(|t| t.normal_from_object(up).map(|n| n.dot(light)));
    vec![
        normal("G10", "(1, 1, 0) under scale (1, 1/2, 1)",
            slant, step.scale(1.0, 0.5, 1.0), [fifth, 2.0 * fifth, 0.0], as_vector),
        normal("G11", "(1, 1, 0) under scale (1, 1e-8, 1)",
            slant, step.scale(1.0, 1e-8, 1.0), [1e-8, 1.0, 0.0], as_vector),
        Case::new("G12", "n · l under scale 2, light from above", 1.0, Absolute(2.0 * f64::EPSILON), bright)
            .protocol(Fails, dark),
        mirrored("G13"),
        normal("G19", "(1, 0, 0) under rotate_z π/2",
            right, step.rotate_z(FRAC_PI_2), [0.0, 1.0, 0.0], transposed),
        normal("G20", "(1, 1, 0) under scale (1, 1/2, 1), only transposed",
            slant, step.scale(1.0, 0.5, 1.0), [fifth, 2.0 * fifth, 0.0], transposed),
        normal("G31", "(0, 1, 0) under translate (1, 2, 3), moved like a point",
            up, step.translate(Point3::new(1.0, 2.0, 3.0)), [0.0, 1.0, 0.0], protocol::normal_as_point),
    ]
}

/// A mirrored sphere still faces the eye.
fn mirrored(id: Id) -> Case {
    let ours = tried(|| {
        let mirror = Transform::IDENTITY.scale(-1.0, 1.0, 1.0)?;
        let sphere = Node::new(mirror).with(Sphere::new(Point3::new(-2.0, 0.0, 0.0), 1.0)?);
        let world = World::new(Color::BLACK)?.with(sphere, ());
        let ray = raw_ray(([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
        Ok(world.hit(&ray, Interval::AHEAD).map(|(hit, ())| hit.normal))
    });
    let what = "the normal towards the eye under scale (-1, 1, 1)";
    Case::new(id, what, [1.0, 0.0, 0.0], Equal, ours)
}
