//! Triangles, also flat and far away, compared with the solution.

use crate::prelude::*;

yours! { triangle_area }

type Code = fn(Point3, Point3, Point3) -> f64;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let [o, x, y] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
    let triangles = Questions {
        words: "corners {}, {} and {}".into(),
        simple: vec![
            (o, x, y),
            (y, x, o),
            (o, x, x),
            (o, x, [2.0, 1.0 / 256.0, 0.0]),
            (o, x, [1.0, 0.0, 1.0 / 1024.0]),
        ],
        others: random(|r| {
            let far = f64::from(r.below(2)) * 1e6;
            let mut corner = || r.triple(9.0).map(|x| x + far);
            (corner(), corner(), corner())
        }),
        answer: |triangle_area: &Code, (a, b, c)| triangle_area(point(a), point(b), point(c)),
    };
    Exercise {
        questions: vec![triangles.into()],
        rounding_flaw: Some("loses digits where a triangle is flat or far away"),
        wrong: vec![
            Other::new("a triangle is half of the parallelogram", |p, q, r| {
                (q - p).parallelogram_area(r - p)
            }),
            Other::new("Heron's sides lose the height of a flat triangle", heron),
            Other::new("sides from the origin lose digits far away", |p, q, r| {
                let [p, q, r] = [p, q, r].map(|corner| corner - Point3::ORIGIN);
                (p.cross(q) + q.cross(r) + r.cross(p)).magnitude() / 2.0
            }),
        ],
        ..Exercise::default()
    }
}

fn heron(p: Point3, q: Point3, r: Point3) -> f64 {
    let [a, b, c] = [r - q, p - r, q - p].map(Vector3::magnitude);
    let s = (a + b + c) / 2.0;
    (s * (s - a) * (s - b) * (s - c)).sqrt()
}
