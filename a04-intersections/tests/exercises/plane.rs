//! Planes anywhere, compared with the solution.

use crate::prelude::*;

yours! { Plane => new_shape(|(a, n)| Plane::new(point(a), vector(n).as_normal())) }

/// Makes a plane by a point and a normal.
type Code = NewShape<([f64; 3], [f64; 3])>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-1", scene_1, ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])),
        wrong: vec![
            Other::from_right("a plane need not pass through the origin", |right| {
                new_shape(move |(_, n)| right(([0.0; 3], n)))
            }),
            Other::new(
                "the ends do not belong to the interval, nor does infinity",
                with_distance(|within, t| within.min <= t && t <= within.max),
            ),
        ],
        ..shapes(Shapes {
            words: "plane through {}, normal {}",
            first: ([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]),
            further: vec![
                ([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]),
                ([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]),
            ],
            on_surface: vec![[0.0, 1.0, 0.0], [3.0, 1.0, -4.0]],
            own_rays: vec![],
            middle: |(a, _)| *a,
            any: |r| (r.triple(5.0), r.triple(5.0)),
        })
    }
}

/// The plane as n · p + k = 0, with a choice of the hits that an interval has.
fn with_distance(is_within: fn(Interval, f64) -> bool) -> Code {
    new_shape(move |(a, n)| {
        let n = vector(n).as_normal().unit("n")?;
        let k = -n.dot(point(a) - Point3::ORIGIN);
        Ok(own(move |ray: &Ray, within: Interval| {
            let t = -(n.dot(ray.origin() - Point3::ORIGIN) + k) / n.dot(ray.direction());
            is_within(within, t).then(|| Hit::new(t, n))
        }))
    })
}
