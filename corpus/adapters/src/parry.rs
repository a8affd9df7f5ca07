//! `parry3d-f64`: hollow shapes, from the origin of the ray on.

use corpus::{CASES, Found, Question, Shape};
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{Ray, RayCast};
use parry3d_f64::shape::{Ball, HalfSpace, TriMesh, Triangle};

use crate::Adapter;

pub const ADAPTER: Adapter = Adapter {
    name: "parry",
    title: "`parry3d-f64` 0.31.1, `cast_local_ray`, `solid = false`",
    cases: CASES,
    ask,
};

fn v(numbers: [f64; 3]) -> Vector {
    Vector::from_array(numbers)
}

fn ask(question: &Question) -> Option<Found> {
    let [min, max] = question.within;
    if min != 0.0 || !question.under.is_empty() {
        return None;
    }
    let max = max.min(f64::MAX);
    let ray = Ray::new(v(question.origin), v(question.direction));
    match &question.shape {
        Shape::Sphere { center, radius } => {
            let pose = Pose::from_translation(v(*center));
            Some(Ball::new(*radius).cast_ray(&pose, &ray, max, false))
        }
        Shape::Box { low, high } => {
            Some(Aabb::new(v(*low), v(*high)).cast_local_ray(&ray, max, false))
        }
        // Its half space is solid on one side: only from outside of it.
        Shape::Plane { point, normal } => {
            let normal = v(*normal).normalize();
            let is_outside = (ray.origin - v(*point)).dot(normal) > 0.0;
            let pose = Pose::from_translation(v(*point));
            is_outside.then(|| HalfSpace::new(normal).cast_ray(&pose, &ray, max, false))
        }
        Shape::Triangles(all) => match all.as_slice() {
            [[a, b, c]] => {
                Some(Triangle::new(v(*a), v(*b), v(*c)).cast_local_ray(&ray, max, false))
            }
            all => {
                let corners = all.iter().flatten().map(|corner| v(*corner)).collect();
                let faces = (0..all.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]);
                let mesh = TriMesh::new(corners, faces.collect()).ok()?;
                Some(mesh.cast_local_ray(&ray, max, false))
            }
        },
        Shape::Disc { .. } | Shape::Tube { .. } => None,
    }
}
