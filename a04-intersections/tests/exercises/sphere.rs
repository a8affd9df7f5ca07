//! Spheres anywhere, compared with the lesson's.

use crate::prelude::*;

/// Straight ahead, twice as fast, from inside, away from it, touching it, and beside it.
const SIMPLE: [[[f64; 3]; 2]; 6] = [
    [[0.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, 0.0], [0.0, 0.0, -2.0]],
    [[0.0, 0.0, -3.0], [0.0, 0.0, -1.0]],
    [[0.0, 0.0, -4.0], [0.0, 0.0, -1.0]],
    [[0.5, 0.0, 0.0], [0.0, 0.0, -1.0]],
    [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
];

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, f64) -> Result<G, ArgumentError>,
) {
    let ball = ([0.0, 0.0, -3.0], 0.5);
    compare(
        check,
        "sphere around {} of radius {}",
        (ball, &SIMPLE),
        |r| (r.triple(5.0), r.between(0.2, 4.0)),
        |(c, r)| Sphere::new(point(c), r),
        |(c, r)| new(point(c), r),
    );
    scene(
        check,
        "scene-2",
        a04_intersections::scenes::scene_2,
        new(point(ball.0), ball.1),
    );
}

/// The textbook's `a t² + 2 b t + k = 0`, and a choice of its root.
fn textbook(c: &mut Check, choose: fn([f64; 3], Interval) -> Option<f64>) {
    check(c, move |c, r| {
        own(move |ray: &Ray, within| {
            let (f, d) = (ray.origin() - c, ray.direction());
            let t = choose([d.dot(d), f.dot(d), f.dot(f) - r * r], within)?;
            Some(Hit::new(t, ((ray.at(t) - c) * (1.0 / r)).as_normal()))
        })
    });
}

fn roots([a, b, k]: [f64; 3]) -> Option<[f64; 2]> {
    let discriminant = b * b - a * k;
    let root = (discriminant >= 0.0).then(|| discriminant.sqrt())?;
    Some([(-b - root) / a, (-b + root) / a])
}

pub const VARIANTS: &[Variant] = &[
    right("the textbook's discriminant", |c| {
        textbook(c, |abk, i| roots(abk)?.into_iter().find(|t| i.contains(*t)));
    }),
    wrong("from inside, only the far root lies ahead", |c| {
        textbook(c, |abk, i| Some(roots(abk)?[0]).filter(|t| i.contains(*t)));
    }),
    wrong("a ray that touches hits: its discriminant is 0", |c| {
        textbook(c, |abk, i| {
            let [near, far] = roots(abk)?;
            [near, far]
                .into_iter()
                .find(|t| near < far && i.contains(*t))
        });
    }),
    wrong("the interval says which t is valid, not an epsilon", |c| {
        textbook(c, |abk, _| roots(abk)?.into_iter().find(|t| *t > 1e-4));
    }),
    wrong("the direction may have any length, so a is not 1", |c| {
        textbook(c, |[_, b, k], i| {
            roots([1.0, b, k])?.into_iter().find(|t| i.contains(*t))
        });
    }),
];
