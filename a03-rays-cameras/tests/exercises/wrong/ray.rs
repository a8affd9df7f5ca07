//! Wrong solutions.

use a02_math::Direction;
use testing::exercise::Wrong;

use crate::ray;

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the distance in the place of t",
        says: "t of a point on the ray",
        check: |c| {
            ray::check(c, a03_rays_cameras::Ray::at, |ray, p| {
                (p - ray.origin()).magnitude()
            });
        },
    },
    Wrong {
        mistake: "the direction is taken to have length 1",
        says: "t of a point on the ray",
        check: |c| {
            ray::check(c, a03_rays_cameras::Ray::at, |ray, p| {
                (p - ray.origin()).dot(ray.direction())
            });
        },
    },
    Wrong {
        mistake: "divided by the length, not by its square",
        says: "t of a point on the ray",
        check: |c| {
            ray::check(c, a03_rays_cameras::Ray::at, |ray, p| {
                (p - ray.origin()).dot(ray.direction()) / ray.direction().magnitude()
            });
        },
    },
    Wrong {
        mistake: "one coordinate divided by another, which does not see points beside",
        says: "t of a point beside the ray",
        check: |c| {
            ray::check(c, a03_rays_cameras::Ray::at, |ray, p| {
                (p.y() - ray.origin().y()) / ray.direction().y()
            });
        },
    },
    Wrong {
        mistake: "the direction is normalised",
        says: "the point; ",
        check: |c| {
            ray::check(
                c,
                |ray, t| ray.origin() + ray.direction().normalized().unwrap_or_default() * t,
                a03_rays_cameras::Ray::t_of,
            );
        },
    },
];
