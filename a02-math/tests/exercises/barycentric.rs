//! Points mixed of corners by shares that are known.

use a02_math::{Point3, Vector3};
use common::{Color, Image};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

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
    let triangles = [
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        // The other way round, beside the origin, and aslant.
        [[5.0, 2.0, 1.0], [3.0, 4.0, 0.0], [7.0, 3.0, -1.0]],
        [[1.0, 2.0, 3.0], [1.0, 2.0, 7.0], [1.0, -6.0, 4.0]],
        // Small, but no line.
        [[0.0, 0.0, 0.0], [0.0, 1e-5, 0.0], [0.0, 0.0, 2e-5]],
    ];
    let mut random = Random::new(3);
    let more =
        std::iter::repeat_with(|| [[(); 3]; 3].map(|p| p.map(|()| random.between(-9.0, 9.0))));
    for corners in triangles.into_iter().chain(more.take(10)) {
        let [a, b, c] = corners.map(point);
        let across = (b - a).cross(c - a);
        for exact in shares {
            let [_, beta, gamma] = exact;
            let p = a + (b - a) * beta + (c - a) * gamma;
            for (place, height) in [("in the plane", 0.0), ("above", 0.75), ("below", -2.0)] {
                let p = p + across * height;
                let what = format!("shares of {}, {place}, in {corners:?}", p.to_glam());
                let got = barycentric(p, [a, b, c]);
                // Some roundings of coordinates up to 1000, over the area.
                check.expect(what, Some(exact), Bound::Absolute(1e-11), got);
            }
        }
    }

    let way = Vector3::new(1.0, 2.0, -1.0);
    for (place, p) in [
        ("the corner a", [1.0; 3]),
        ("a point beside it", [0.0, 3.0, 5.0]),
    ] {
        for steps in [0.0, 1.0, 3.0, -2.0] {
            let a = point([1.0, 1.0, 1.0]);
            for corners in [[a, a + way, a + way * steps], [a + way * steps, a, a + way]] {
                let got = barycentric(point(p), corners);
                let what =
                    format!("shares of {place} on a line of corners, the third {steps} steps away");
                check.expect(what, None::<[f64; 3]>, Bound::Equal, got);
            }
        }
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
