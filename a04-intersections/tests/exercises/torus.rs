//! Rays whose crossings with the torus are those of a line with a circle.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use testing::exercise::Check;

use crate::shape::{TURNS, expect_hit, show, turned};

/// What either way can reach: steps and halving, or the quartic equation.
const BOUND: f64 = 1e-9;

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(f64, f64) -> Result<G, ArgumentError>,
) {
    let Ok(torus) = new(2.0, 0.5) else { return };
    let mut hit = |what: &str, ray: &Ray, exact: Option<(f64, Normal3)>| {
        expect_hit(check, what, exact, BOUND, torus.hit(ray, Interval::AHEAD));
    };

    for turn in TURNS {
        let at = |x, y, z| Point3::ORIGIN + turned(turn, x, y, z);
        let way = |x, y, z| turned(turn, x, y, z);
        let facing = |x, y, z| turned(turn, x, y, z).as_normal();

        // Towards the tube along its normal, which does not cross the hole.
        for (sin, cos) in TURNS {
            let normal = way(cos, sin, 0.0);
            let place = at(2.0 + 0.5 * cos, 0.5 * sin, 0.0);
            for (from, place) in [
                (place + normal * 0.7, "along the normal"),
                (place - normal * 0.3, "from within the tube"),
            ] {
                let to = at(2.0 + 0.5 * cos, 0.5 * sin, 0.0);
                let what = format!("{place}, from {} to {}", from.to_glam(), to.to_glam());
                let ray = Ray::derived(from, to - from);
                hit(&what, &ray, Some((1.0, normal.as_normal())));
            }
        }

        // 0.3² + 0.4² = 0.5².
        let exact = Some((4.6, facing(0.6, 0.8, 0.0)));
        let ray = Ray::derived(at(2.3, 5.0, 0.0), way(0.0, -1.0, 0.0));
        hit("from above, beside the ring", &ray, exact);
        let exact = Some((2.6, facing(0.8, 0.6, 0.0)));
        let ray = Ray::derived(at(5.0, 0.3, 0.0), way(-1.0, 0.0, 0.0));
        hit("from the side, at the height 0.3", &ray, exact);
        // The outermost circle has the radius 2.5: 1.5² + 2² = 2.5².
        let exact = Some((3.0, facing(0.6, 0.0, 0.8)));
        let ray = Ray::derived(at(1.5, 0.0, 5.0), way(0.0, 0.0, -1.0));
        hit("aslant, at the height 0", &ray, exact);

        let ray = Ray::derived(at(1.4, 5.0, 0.0), way(0.0, -1.0, 0.0));
        hit("through the hole", &ray, None);
        let ray = Ray::derived(at(5.0, 0.501, 0.0), way(-1.0, 0.0, 0.0));
        hit("over the top", &ray, None);
        let ray = Ray::derived(at(2.501, 0.0, 5.0), way(0.0, 0.0, -1.0));
        hit("past the side", &ray, None);
        let ray = Ray::derived(at(5.0, 0.0, 0.0), way(1.0, 0.0, 0.0));
        hit("away from it", &ray, None);
    }

    // Four crossings on one ray, of which the interval chooses; direction of
    // length 2.
    let through = Ray::derived(Point3::new(5.0, 0.0, 0.0), Vector3::new(-2.0, 0.0, 0.0));
    for (min, t, side) in [
        (0.0, 1.25, 1.0),
        (1.3, 1.75, -1.0),
        (2.0, 3.25, 1.0),
        (3.3, 3.75, -1.0),
    ] {
        let within = Interval { min, max: 9.0 };
        let exact = Some((t, Normal3::new(side, 0.0, 0.0)));
        let what = format!("straight through, after t = {min}");
        expect_hit(check, &what, exact, BOUND, torus.hit(&through, within));
    }
    let got = torus.hit(&through, Interval::before(1.2));
    expect_hit(check, "straight through, before t = 1.2", None, BOUND, got);

    show(
        check,
        torus,
        Point3::new(2.0, 5.0, 7.0),
        Point3::new(0.0, -0.2, 0.0),
    );
}
