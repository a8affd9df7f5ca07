//! Shears of half of the ray, and normals that are sheared like ways.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Sphere};
use testing::exercise::{Check, Wrong};

use crate::own::Own;
use crate::sheared::check;

/// How a shape is sheared by a number.
#[derive(Clone, Copy)]
struct Shear {
    origin: fn(Point3, f64) -> Point3,
    direction: fn(Vector3, f64) -> Vector3,
    normal: fn(Normal3, f64) -> Vector3,
    face: fn(Normal3, f64) -> Vector3,
}

const RIGHT: Shear = Shear {
    origin: |o, by| Point3::new(o.x() - by * o.y(), o.y(), o.z()),
    direction: |d, by| Vector3::new(d.x() - by * d.y(), d.y(), d.z()),
    normal: right_normal,
    face: right_normal,
};

fn right_normal(n: Normal3, by: f64) -> Vector3 {
    Vector3::new(n.x(), n.y() - by * n.x(), n.z())
}

fn sheared<G: Geometry>(shape: G, by: f64, shear: Shear) -> impl Geometry {
    Own(move |ray: &Ray, within| {
        let origin = (shear.origin)(ray.origin(), by);
        let ray = Ray::derived(origin, (shear.direction)(ray.direction(), by));
        let hit = shape.hit(&ray, within)?;
        Some(Hit {
            t: hit.t,
            normal: (shear.normal)(hit.normal, by).normalized()?.as_normal(),
            face: (shear.face)(hit.face, by).normalized()?.as_normal(),
        })
    })
}

/// Checks both kinds of shapes, sheared in this way.
fn leaning(c: &mut Check, shear: Shear) {
    check(
        c,
        |ball: Sphere, by| sheared(ball, by, shear),
        |aab: AxisAlignedBox, by| sheared(aab, by, shear),
    );
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the direction not sheared",
        says: "t, a ball sheared by 0.75, at [-0.000, -0.800, 0.000], direction of length 2: expected 1, got none",
        check: |c| {
            leaning(
                c,
                Shear {
                    direction: |d, _| d,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "the origin not sheared",
        says: "t, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected 1, got",
        check: |c| {
            leaning(
                c,
                Shear {
                    origin: |o, _| o,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "the ray sheared forward instead of back",
        says: "t, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected 1, got 1.45",
        check: |c| {
            let origin = |o, by: f64| (RIGHT.origin)(o, -by);
            let direction = |d, by: f64| (RIGHT.direction)(d, -by);
            leaning(
                c,
                Shear {
                    origin,
                    direction,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "a direction made unit",
        says: "t, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected 1, got",
        check: |c| {
            let direction = |d, by| {
                let d = (RIGHT.direction)(d, by);
                d.normalized().unwrap_or(d)
            };
            leaning(c, Shear { direction, ..RIGHT });
        },
    },
    Wrong {
        mistake: "a normal sheared like a way",
        says: "normal, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected (1, -1.3877787807814457e-16, 0), got",
        check: |c| {
            let normal = |n: Normal3, by| Vector3::new(n.x() + by * n.y(), n.y(), n.z());
            leaning(
                c,
                Shear {
                    normal,
                    face: normal,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "the upright normal",
        says: "normal, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected (1, -1.3877787807814457e-16, 0), got (0.8",
        check: |c| {
            leaning(
                c,
                Shear {
                    normal: |n, _| n.into(),
                    face: |n, _| n.into(),
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "a normal sheared by the matrix instead of its inverse",
        says: "normal, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected (1, -1.3877787807814457e-16, 0), got (0.55",
        check: |c| {
            let normal = |n: Normal3, by: f64| right_normal(n, -by);
            leaning(
                c,
                Shear {
                    normal,
                    face: normal,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "a shear by height along z",
        says: "t, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected 1, got",
        check: |c| {
            let origin = |o: Point3, by| Point3::new(o.x(), o.y(), o.z() - by * o.y());
            let direction = |d: Vector3, by| Vector3::new(d.x(), d.y(), d.z() - by * d.y());
            leaning(
                c,
                Shear {
                    origin,
                    direction,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "the face's normal left upright",
        says: "face, a ball sheared by 0.75, at [1.250, 0.600, 0.000], direction of length 2: expected (1, -1.3877787807814457e-16, 0), got (0.8",
        check: |c| {
            leaning(
                c,
                Shear {
                    face: |n, _| n.into(),
                    ..RIGHT
                },
            );
        },
    },
];
