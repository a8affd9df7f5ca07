//! Hits through nodes, and normals under scalings, rotations and reflections; those with a single ray and exact
//! numbers are rows.

use std::f64::consts::FRAC_PI_2;
use std::mem;

use a02_math::arrays::array;
use a02_math::{Direction, Normal3, Point3, Vector3};
use a04_intersections::{Interval, Sphere};
use a04_lab::line::{Line, line};
use a04_lab::rows;
use a04_lab::support::{first, point};
use a06_lab::surface::surface;
use common::{ArgumentError, Error};
use corpus::{Question, Shape, Step};
use measure::extremes::{Case, Outcome, Refused, Row, tried};

use crate::protocol::{self, normal_as_point, normal_as_vector, transposed_normal};
use a07_transforms::registry::ALL_SHAPES;
use a07_transforms::{Mat4x4, Node, Transform};

const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

/// The `t` of the first hit of a node.
fn t(node: Result<Node, Error>, line: Line) -> Outcome {
    node.map(|node| first(&node, &line.raw_ray())).into()
}

/// The `t` of a ball under a transform.
pub fn of_ellipsoid(row: &Question) -> Case {
    let node = sphere(row).and_then(|ball| Ok(Node::new(transform(row)?).with(ball)));
    Case::of_ours(t(node, rows::line_of(row)))
}

/// The sphere of a row.
fn sphere(row: &Question) -> Result<Sphere, Error> {
    match row.shape {
        Shape::Sphere { center, radius } => Ok(Sphere::new(point(center), radius)?),
        _ => Err(Error::Usage(format!("{} is no sphere", row.id))),
    }
}

/// The transform of a row: its steps, the last of which is applied first.
fn transform(row: &Question) -> Result<Transform, ArgumentError> {
    let mut transform = Transform::IDENTITY;
    for step in &row.under {
        transform = match *step {
            Step::Translate(by) => transform.translate(point(by))?,
            Step::Scale([x, y, z]) => transform.scale(x, y, z)?,
        };
    }
    Ok(transform)
}

/// A ball of radius 1.
fn ball(x: f64, z: f64) -> Result<Sphere, ArgumentError> {
    Sphere::new(Point3::new(x, 0.0, z), 1.0)
}

/// A node of two balls, whose nearest points have these distances.
fn two_balls(a: f64, b: f64) -> Result<Node, Error> {
    let first = Node::new(Transform::IDENTITY).with(ball(0.0, -a - 1.0)?);
    Ok(first.with(ball(0.0, -b - 1.0)?))
}

/// The nearer of these balls.
pub fn nearer_child(a: f64, b: f64) -> Case {
    let line = line([0.0; 3], DOWN);
    let theirs = tried(|| {
        let mut node = two_balls(a, b)?;
        let children = ALL_SHAPES.children_mut(&mut node).map(mem::take);
        let hit = protocol::last_hit(&children.unwrap_or_default(), &line.raw_ray());
        Ok(hit.map(|hit| hit.t))
    });
    Case::of(t(two_balls(a, b), line), theirs)
}

/// The protocol's normal of a transformed object.
type Theirs = fn(Mat4x4, Normal3) -> Option<Normal3>;

/// A normal of an object under a transform.
fn normal(n: [f64; 3], transform: Result<Transform, ArgumentError>, theirs: Theirs) -> Case {
    let n = Normal3::from_glam(n.into());
    let theirs = transform.clone().map(|t| theirs(t.matrix(), n).map(array));
    let ours = transform.map(|t| t.normal_from_object(n).map(array));
    Case::of(ours, theirs)
}

/// The brightness of an object twice as large under a light straight above, which is 1 for any size.
pub fn brightness_under_scale() -> Case {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let light = Vector3::from(up);
    let ours = tried(|| {
        let double = Transform::IDENTITY.scale(2.0, 2.0, 2.0)?;
        Ok(double.normal_from_object(up).map(|n| n.dot(light)))
    });
    let theirs = tried(|| {
        let double = Transform::IDENTITY.scale(2.0, 2.0, 2.0)?;
        let normal = protocol::unnormalized_normal(double.inverse(), up);
        Ok(light.dot(normal))
    });
    Case::of(ours, theirs)
}

/// The normal at the hit of a ball under a transform, which faces the eye.
fn normal_of_hit(row: &Question) -> Outcome {
    tried(|| {
        let node = Node::new(transform(row)?).with(sphere(row)?);
        let (world, ray) = (surface(node)?, rows::line_of(row).raw_ray());
        let hit = world.hit(&ray, Interval::AHEAD);
        Ok(hit.map(|(hit, ())| array(hit.normal)))
    })
}

/// The normal of a plane or ball under a transform, and by one of the protocol's formulas.
pub fn of_normal(row: &Row, question: &Question) -> Case {
    let theirs: Theirs = match row.id.as_str() {
        "G20" => transposed_normal,
        "G31" => normal_as_point,
        _ => normal_as_vector,
    };
    match question.shape {
        Shape::Plane { normal: n, .. } => normal_of_plane(n, question, theirs),
        _ => Case::of_ours(normal_of_hit(question)),
    }
}

/// The normal of a plane under the transform of a row.
fn normal_of_plane([x, y, z]: [f64; 3], row: &Question, theirs: Theirs) -> Case {
    match Normal3::new(x, y, z).unit("normal n") {
        Ok(n) => normal(array(n), transform(row), theirs),
        Err(_) => Case::of(Refused, Refused),
    }
}

/// A normal that is turned to another axis.
pub fn turned_normal() -> Case {
    let turned = Transform::IDENTITY.rotate_z(FRAC_PI_2);
    normal([1.0, 0.0, 0.0], turned, transposed_normal)
}
