//! Spheres anywhere, compared with the lesson's.

use crate::prelude::*;

yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }

type Code = NewShape<([f64; 3], f64)>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-2", scene_2, ([0.0, 0.0, -3.0], 0.5)),
        remark: Some(|new: &Code| search("sphere", &|x: &[f64]| new(([x[0], x[1], x[2]], x[3])))),
        right: vec![Other::new("the textbook's discriminant", textbook(first))],
        wrong: vec![
            Other::new(
                "from inside, only the far root is ahead",
                textbook(|[near, _], within| Some(near).filter(|t| within.contains(*t))),
            ),
            Other::new(
                "a ray that touches hits: no root is below 0",
                textbook(|roots, within| first(roots, within).filter(|_| roots[0] < roots[1])),
            ),
        ],
        ..shapes(Shapes {
            words: "sphere around {} of radius {}",
            first: ([0.0, 0.0, 0.0], 1.0),
            any: |r| (r.triple(5.0), r.between(0.2, 4.0)),
        })
    }
}

/// The textbook's `a t² + 2 b t + k = 0`, with a choice among its roots.
fn textbook(choose: fn([f64; 2], Interval) -> Option<f64>) -> Code {
    new_shape(move |(c, r): (_, f64)| {
        let c = point(c);
        Ok(own(move |ray: &Ray, within| {
            let (f, d) = (ray.origin() - c, ray.direction());
            let (a, b) = (d.dot(d), f.dot(d));
            let root = (b * b - a * (f.dot(f) - r * r)).sqrt();
            let t = choose([(-b - root) / a, (-b + root) / a], within)?;
            Some(Hit::new(t, ((ray.at(t) - c) * (1.0 / r)).as_normal()))
        }))
    })
}

fn first(roots: [f64; 2], within: Interval) -> Option<f64> {
    roots.into_iter().find(|t| within.contains(*t))
}
