//! Wrong solutions: another matrix.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use testing::exercise::Wrong;

use crate::under_transform;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the matrix instead of the inverse",
        says: "the origin in the space of the object, moved",
        check: |c| {
            under_transform::check(
                c,
                |t, ray| Ray::derived(t.matrix() * ray.origin(), t.matrix() * ray.direction()),
                a07_transforms::Transform::normal_from_object,
            );
        },
    },
    Wrong {
        mistake: "the direction is normalised",
        says: "the direction in the space of the object",
        check: |c| {
            under_transform::check(
                c,
                |t, ray| {
                    let d = t.inverse() * ray.direction();
                    Ray::derived(t.inverse() * ray.origin(), d.normalized().unwrap_or(d))
                },
                a07_transforms::Transform::normal_from_object,
            );
        },
    },
    Wrong {
        mistake: "the direction is moved like a point",
        says: "the direction in the space of the object, moved",
        check: |c| {
            under_transform::check(
                c,
                |t, ray| {
                    let d = t.inverse() * (Point3::ORIGIN + ray.direction());
                    Ray::derived(t.inverse() * ray.origin(), d - Point3::ORIGIN)
                },
                a07_transforms::Transform::normal_from_object,
            );
        },
    },
    Wrong {
        mistake: "the normal is transformed like a vector",
        says: "the normal in the space around the object, stretched",
        check: |c| {
            under_transform::check(c, a07_transforms::Transform::ray_to_object, |t, n| {
                (t.matrix() * Vector3::from(n))
                    .normalized()
                    .map(Vector3::as_normal)
            });
        },
    },
    Wrong {
        mistake: "the inverse is not transposed",
        says: "the normal in the space around the object, turned",
        check: |c| {
            under_transform::check(c, a07_transforms::Transform::ray_to_object, |t, n| {
                (t.inverse() * Vector3::from(n))
                    .normalized()
                    .map(Vector3::as_normal)
            });
        },
    },
    Wrong {
        mistake: "the normal is not of length 1",
        says: "the normal in the space around the object, stretched",
        check: |c| {
            under_transform::check(c, a07_transforms::Transform::ray_to_object, |t, n| {
                Some((t.inverse().transposed() * Vector3::from(n)).as_normal())
            });
        },
    },
];
