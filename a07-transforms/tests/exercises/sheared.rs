//! A smooth triangle and a ball that lean, compared with the solution.

use crate::prelude::*;
use crate::solutions::sheared::Sheared;

type Shape = Box<dyn Geometry>;

/// A ball, or a triangle whose corners have normals aslant.
fn upright(is_ball: bool) -> Result<Shape, ArgumentError> {
    let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(if is_ball {
        Box::new(ball)
    } else {
        Box::new(smooth_triangle(0.0)?)
    })
}

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(Shape, f64) -> G) {
    compare(
        check,
        "a shape (a ball: {}) sheared by {}",
        (true, 0.5),
        |r| (r.below(2) == 0, r.between(-3.0, 3.0)),
        |(is_ball, by)| Ok(Sheared::new(upright(is_ball)?, by)),
        |(is_ball, by)| Ok(new(upright(is_ball)?, by)),
    );
    let world = || {
        let (lbf, run) = (Point3::new(-2.3, 0.0, -0.7), Point3::new(-1.0, 2.0, 0.7));
        let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
        let round = Sphere::new(Point3::new(0.9, 1.0, 0.0), 1.0)?;
        let leaning = new(Box::new(AxisAlignedBox::new(lbf, run)?), 0.6);
        Ok(World::new(Color::gray(0.08))?
            .with(floor, Color::gray(0.6))
            .with(leaning, Color::new(0.4, 0.7, 1.0))
            .with(new(Box::new(round), 0.6), Color::new(1.0, 0.5, 0.3)))
    };
    let (eye, at) = ([0.3, 2.6, 7.5], [0.3, 0.8, 0.0]);
    show_lit(check, world(), eye, at);
}

/// A right shape for another ray, with a flaw in its hit.
fn variant(c: &mut Check, lean: fn(&Ray, f64) -> Ray, flaw: fn(Hit, f64) -> Option<Hit>) {
    check(c, move |shape, by| {
        let leaning = Sheared::new(shape, by);
        Own(move |ray: &Ray, i: Interval| flaw(leaning.hit(&lean(ray, by), i)?, by))
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("the direction is sheared back, too", |c| {
        let forward = |ray: &Ray, by: f64| {
            let d = ray.direction();
            Ray::derived(ray.origin(), d + Vector3::new(by * d.y(), 0.0, 0.0))
        };
        variant(c, forward, |hit, _| Some(hit));
    }),
    wrong("a normal needs the transposed inverse", |c| {
        variant(
            c,
            |ray, _| *ray,
            |hit, by| {
                let n = hit.normal;
                let n = Vector3::new(n.x(), n.y() + by * n.x(), n.z());
                Some(Hit {
                    normal: n.normalized()?.as_normal(),
                    ..hit
                })
            },
        );
    }),
    wrong("both normals lean", |c| {
        variant(c, |ray, _| *ray, |hit, _| Some(Hit::new(hit.t, hit.normal)))
    }),
];
