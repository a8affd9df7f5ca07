//! A smooth triangle and a ball that lean, compared with the solution.

use crate::prelude::*;
use crate::solutions::sheared::Sheared;

type Shape = Box<dyn Geometry>;

/// At the triangle, at the ball from both sides, and past both.
const SIMPLE: [[[f64; 3]; 2]; 4] = [
    [[0.0, 0.0, 5.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, -5.0], [0.0, 0.0, 1.0]],
    [[0.5, 4.0, 0.0], [0.0, -2.0, 0.0]],
    [[5.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
];

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
        ((true, 0.5), &SIMPLE),
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
    let (eye, at) = (Point3::new(0.3, 2.6, 7.5), Point3::new(0.3, 0.8, 0.0));
    show_lit(check, world(), eye, at);
}

/// A shape for which origin and direction of the ray are sheared by factors of `by`, and both
/// normals by a function.
fn variant(
    c: &mut Check,
    [of_origin, of_direction]: [f64; 2],
    normal: fn(Normal3, f64) -> Vector3,
) {
    check(c, move |shape, by| {
        Own(move |ray: &Ray, within: Interval| {
            let (o, d) = (ray.origin(), ray.direction());
            let o = o + Vector3::new(of_origin * by * o.y(), 0.0, 0.0);
            let d = d + Vector3::new(of_direction * by * d.y(), 0.0, 0.0);
            let hit = shape.hit(&Ray::derived(o, d), within)?;
            let [n, face] = [hit.normal, hit.face].map(|n| normal(n, by).normalized());
            let (normal, face) = (n?.as_normal(), face?.as_normal());
            Some(Hit {
                normal,
                face,
                ..hit
            })
        })
    });
}

fn transposed(n: Normal3, by: f64) -> Vector3 {
    Vector3::new(n.x(), n.y() - by * n.x(), n.z())
}

pub const VARIANTS: &[Variant] = &[
    wrong("the direction leans, too", |c| {
        variant(c, [-1.0, 0.0], transposed)
    }),
    wrong(
        "a normal is no vector: it is multiplied by the transposed inverse",
        |c| {
            variant(c, [-1.0, -1.0], |n, by| {
                Vector3::new(n.x() + by * n.y(), n.y(), n.z())
            });
        },
    ),
    wrong("both normals lean: the face's, too", |c| {
        check(c, |shape, by| {
            let leaning = Sheared::new(shape, by);
            Own(move |ray: &Ray, i: Interval| {
                leaning.hit(ray, i).map(|hit| Hit::new(hit.t, hit.normal))
            })
        });
    }),
];
