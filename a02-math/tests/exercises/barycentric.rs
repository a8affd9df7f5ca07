//! Points in triangles, outside and beside their planes, compared with the solution.

use crate::prelude::*;

yours! { barycentric }

type Code = fn(Point3, [Point3; 3]) -> Option<[f64; 3]>;

pub fn exercise() -> Exercise<Code> {
    let [o, x, y] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let points = Questions {
        words: "p = {}, corners {}",
        simple: vec![
            ([1.0, 1.0, 0.0], [o, x, y]),
            ([4.0, 4.0, 1.0], [o, x, y]),
            (y, [o, x, y]),
            ([2.0, 2.0, 0.0], [y, x, o]),
            ([-2.0, 1.0, 0.0], [o, x, y]),
            (y, [o, x, [8.0, 0.0, 0.0]]),
            (y, [x, x, x]),
        ],
        others: random(|r| {
            let scale = r.scale();
            let mut triple = || r.triple(9.0).map(|x| x * scale);
            (triple(), [triple(), triple(), triple()])
        }),
        answer: |barycentric: &Code, (p, corners): ([f64; 3], [[f64; 3]; 3])| {
            barycentric(point(p), corners.map(point))
        },
    };
    Exercise {
        questions: points.into(),
        picture: Picture::own(triangle),
    }
}

/// A triangle whose corners are red, green and blue.
fn triangle(barycentric: &Code, settings: &Settings) -> Result<Image, Error> {
    let corners = [
        Point3::new(30.0, 20.0, 0.0),
        Point3::new(290.0, 60.0, 0.0),
        Point3::new(110.0, 220.0, 0.0),
    ];
    let bottom = settings.size.height() - 1;
    Image::from_fn(settings.size, |x, y| {
        let p = Point3::new(f64::from(x), f64::from(bottom - y), 0.0);
        match barycentric(p, corners) {
            Some([r, g, b]) if r.min(g).min(b) >= 0.0 => Color::new(r, g, b),
            _ => Color::gray(0.1),
        }
    })
}
