//! Points in triangles, outside and beside their planes, compared with the solution.

use crate::prelude::*;

yours! { barycentric }

type Code = fn(Point3, [Point3; 3]) -> Option<[f64; 3]>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(triangle),
        ..Exercise::asked(|barycentric: &Code, (p, a, b, c)| {
            barycentric(point(p), [a, b, c].map(point))
        })
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
