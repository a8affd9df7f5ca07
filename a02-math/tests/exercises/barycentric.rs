//! Points in triangles, outside and beside their planes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Point3, [Point3; 3]) -> Option<[f64; 3]>) {
    let [o, x, y] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let (all, line) = ([o, x, y], [o, x, [8.0, 0.0, 0.0]]);
    check.compare(
        "p = {}, corners {}",
        [([1.0, 1.0, 0.0], all), ([4.0, 4.0, 1.0], all), (y, line)],
        random(|r| {
            let scale = r.scale();
            let mut triple = || r.triple(9.0).map(|x| x * scale);
            (triple(), [triple(), triple(), triple()])
        }),
        [barycentric, yours],
        |barycentric, (p, corners)| barycentric(point(p), corners.map(point)),
    );
    let corners = [(30.0, 20.0), (290.0, 60.0), (110.0, 220.0)];
    let corners = corners.map(|(x, y)| Point3::new(x, y, 0.0));
    check.picture(|settings| {
        let bottom = settings.size.height() - 1;
        Image::from_fn(settings.size, |x, y| {
            let p = Point3::new(f64::from(x), f64::from(bottom - y), 0.0);
            match yours(p, corners) {
                Some([r, g, b]) if r.min(g).min(b) >= 0.0 => Color::new(r, g, b),
                _ => Color::gray(0.1),
            }
        })
    });
}

variants! { check:
    yours => barycentric;
    wrong "outside, a share is negative" => |p, t| {
        barycentric(p, t).map(|shares| shares.map(f64::abs))
    };
    wrong "corners on a line have no shares" => |p, t| barycentric(p, t).or(Some([f64::NAN; 3]));
    wrong "a small triangle is no line" => |p, [a, b, c]| {
        let area = (b - a).parallelogram_area(c - a);
        barycentric(p, [a, b, c]).filter(|_| area > 1e-9)
    };
}
