//! Triangles anywhere, met inside, near their edges and corners, from both sides.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::aimed::{Shown, alone, expect_scene, frame, point};

/// Barycentric coordinates of b and c, and whether their point is inside.
const PLACES: [(&str, f64, f64, bool); 12] = [
    ("in the middle", 0.33, 0.33, true),
    ("near corner a", 1e-6, 1e-6, true),
    ("near corner b", 1.0 - 2e-6, 1e-6, true),
    ("near corner c", 1e-6, 1.0 - 2e-6, true),
    ("just inside edge ab", 0.4, 1e-6, true),
    ("just inside edge bc", 0.5, 0.5 - 1e-6, true),
    ("just inside edge ca", 1e-6, 0.4, true),
    ("just outside edge ab", 0.4, -1e-6, false),
    ("just outside edge bc", 0.5, 0.5 + 1e-6, false),
    ("just outside edge ca", -1e-6, 0.4, false),
    ("beyond corner a", -0.2, -0.2, false),
    ("beyond edge bc", 0.9, 0.9, false),
];

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Point3, Point3) -> Result<G, ArgumentError>,
) {
    // Three numbers whose exact hit can be computed by hand.
    let [a, b, c] = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(|(x, y)| Point3::new(x, y, -2.0));
    if let Ok(triangle) = new(a, b, c) {
        let words = "triangle [0, 0, -2], [4, 0, -2], [0, 4, -2]".to_owned();
        let triangle = Shown {
            shape: &triangle,
            words,
        };
        let (ahead, n) = (Vector3::new(0.0, 0.0, -1.0), Normal3::new(0.0, 0.0, 1.0));
        let mut at = |kind: &str, x: f64, y: f64, exact| {
            let ray = Ray::derived(Point3::new(x, y, 0.0), ahead);
            triangle.expect(check, kind, &ray, Interval::AHEAD, exact);
        };
        at("straight ahead", 1.0, 1.0, Some((2.0, n)));
        at("on edge ab", 1.0, 0.0, Some((2.0, n)));
        at("on edge ca", 0.0, 1.0, Some((2.0, n)));
        at("on corner a", 0.0, 0.0, Some((2.0, n)));
        at("beyond edge bc", 3.0, 3.0, None);
        let origin = Point3::new(1.0, 1.0, -2.0);
        triangle.expect_none(
            check,
            "along the triangle, in its plane",
            origin,
            Vector3::new(1.0, 0.5, 0.0),
        );
    }
    let mut random = Random::new(44);
    for _ in 0..20 {
        let (a, [n, side, other]) = (point(&mut random, 5.0), frame(&mut random));
        // Counterclockwise around n, because side, other and n are right-handed.
        let b = a + side * random.between(0.5, 4.0);
        let c = a + side * random.between(-2.0, 2.0) + other * random.between(0.5, 4.0);
        let Ok(triangle) = new(a, b, c) else { continue };
        let words = [a, b, c]
            .map(|corner| format!("{:.2}", corner.to_glam()))
            .join(", ");
        let triangle = Shown {
            shape: &triangle,
            words: format!("triangle {words}"),
        };
        for (kind, beta, gamma, is_inside) in PLACES {
            let at = a + (b - a) * beta + (c - a) * gamma;
            let aside = side * random.between(-2.0, 2.0) + other * random.between(-2.0, 2.0);
            for (from, height) in [("from the front", 1.0), ("from the back", -1.0)] {
                let from = (
                    format!("{kind}, {from}"),
                    at + n * (height * random.between(0.5, 4.0)) + aside,
                );
                if is_inside {
                    triangle.expect_nearest(check, &from.0, from.1, at, n.as_normal());
                } else {
                    triangle.expect_none(check, &from.0, from.1, at - from.1);
                }
            }
        }
        let at = a + (b - a) * 0.3 + (c - a) * 0.3;
        triangle.expect_none(check, "the triangle lies behind", at + n, n);
    }
    expect_scene(check, "scene-4", || {
        let corners = [(-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)];
        let [a, b, c] = corners.map(|(x, y)| Point3::new(x, y, -3.0));
        alone(new(a, b, c)?, Color::MAGENTA)
    });
}
