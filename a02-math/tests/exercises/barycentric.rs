//! Points mixed of corners by shares that are known.

use a02_math::{Point3, Vector3};
use common::{Color, Image};
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, barycentric: impl Fn(Point3, [Point3; 3]) -> Option<[f64; 3]>) {
    let point = |xyz: [f64; 3]| Point3::from_glam(xyz.into());
    let shares = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.5, 0.5, 0.0],
        [0.25, 0.25, 0.5],
        [0.125, 0.25, 0.625],
        [-0.5, 1.25, 0.25],
        [2.0, -0.5, -0.5],
        [1.5, 0.5, -1.0],
    ];
    for corners in [
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        // The other way round, beside the origin, and aslant.
        [[5.0, 2.0, 1.0], [3.0, 4.0, 0.0], [7.0, 3.0, -1.0]],
        [[1.0, 2.0, 3.0], [1.0, 2.0, 7.0], [1.0, -6.0, 4.0]],
    ] {
        let [a, b, c] = corners.map(point);
        let across = (b - a).cross(c - a);
        for exact in shares {
            let [_, beta, gamma] = exact;
            let p = a + (b - a) * beta + (c - a) * gamma;
            for (place, height) in [("in the plane", 0.0), ("above", 0.75), ("below", -2.0)] {
                let p = p + across * height;
                let what = format!("of {}, {place}, in {corners:?}", p.to_glam());
                let got = barycentric(p, [a, b, c]);
                check.expect(what, Some(exact), Bound::Absolute(1e-13), got);
            }
        }
    }

    let way = Vector3::new(1.0, 2.0, -1.0);
    for steps in [0.0, 1.0, 3.0] {
        let a = point([1.0, 1.0, 1.0]);
        let corners = [a, a + way, a + way * steps];
        let got = barycentric(a, corners);
        let what = "of corners on a line";
        check.expect(what, None::<[f64; 3]>, Bound::Equal, got);
    }

    let corners = [[30.0, 20.0, 0.0], [290.0, 60.0, 0.0], [110.0, 220.0, 0.0]].map(point);
    check.picture(|settings| {
        let bottom = settings.size.height() - 1;
        Image::from_fn(settings.size, |x, y| {
            let p = Point3::new(f64::from(x), f64::from(bottom - y), 0.0);
            match barycentric(p, corners) {
                Some([r, g, b]) if r.min(g).min(b) >= 0.0 => Color::new(r, g, b),
                _ => Color::gray(0.1),
            }
        })
    });
}
