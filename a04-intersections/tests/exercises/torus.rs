//! Rays that cross the torus where a line crosses a circle.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use testing::exercise::Check;

use crate::shape::{TURNS, expect_hit, show, turned};

/// The error that both ways keep: steps and halving, or the quartic equation.
const BOUND: f64 = 1e-9;

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(f64, f64) -> Result<G, ArgumentError>,
) {
    let Ok(torus) = new(2.0, 0.5) else { return };
    expect_torus(check, &torus, 2.0, 0.5);
    for (ring, r) in [(1.0, 0.75), (3.0, 0.1), (0.4, 0.3), (7.0, 3.5)] {
        if let Ok(torus) = new(ring, r) {
            expect_torus(check, &torus, ring, r);
        }
    }
    show(
        check,
        torus,
        Point3::new(2.0, 5.0, 7.0),
        Point3::new(0.0, -0.2, 0.0),
    );
}

fn expect_torus(check: &mut Check, torus: &impl Geometry, ring: f64, r: f64) {
    let name = format!("ring {ring}, tube {r}");
    let mut hit = |what: &str, ray: &Ray, exact: Option<(f64, Normal3)>| {
        let what = format!("{what}, {name}");
        expect_hit(check, &what, exact, BOUND, torus.hit(ray, Interval::AHEAD));
    };
    // Beyond all of it.
    let far = 2.0 * (ring + r);
    for turn in TURNS {
        let at = |x, y, z| Point3::ORIGIN + turned(turn, x, y, z);
        let way = |x, y, z| turned(turn, x, y, z);
        let facing = |x, y, z| turned(turn, x, y, z).as_normal();

        // Towards the tube along its normal, which does not cross the hole.
        for (sin, cos) in TURNS {
            let normal = way(cos, sin, 0.0);
            let to = at(ring + r * cos, r * sin, 0.0);
            for (from, place) in [
                (to + normal * (0.2 * ring), "along the normal"),
                (to - normal * (0.6 * r), "from within the tube"),
            ] {
                // To the inner side only from nearer than the other one.
                if cos < 0.0 && from.x() * to.x() + from.z() * to.z() < 0.0 {
                    continue;
                }
                let what = format!("{place}, from {:.3} to {:.3}", from.to_glam(), to.to_glam());
                let ray = Ray::derived(from, to - from);
                hit(&what, &ray, Some((1.0, normal.as_normal())));
            }
        }

        // 0.6² + 0.8² = 1.
        let exact = Some((far - 0.8 * r, facing(0.6, 0.8, 0.0)));
        let ray = Ray::derived(at(ring + 0.6 * r, far, 0.0), way(0.0, -1.0, 0.0));
        hit("from above, beside the ring", &ray, exact);
        let exact = Some((far - (ring + 0.8 * r), facing(0.8, 0.6, 0.0)));
        let ray = Ray::derived(at(far, 0.6 * r, 0.0), way(-1.0, 0.0, 0.0));
        hit("from the side, above the middle", &ray, exact);
        let side = far - (ring + 9.0 / 41.0 * r);
        let exact = Some((side / 4.0, facing(9.0 / 41.0, 40.0 / 41.0, 0.0)));
        let ray = Ray::derived(at(far, 40.0 / 41.0 * r, 0.0), way(-4.0, 0.0, 0.0));
        hit(
            "from the side, near the top, direction of length 4",
            &ray,
            exact,
        );
        // On the outermost circle.
        let outer = ring + r;
        let exact = Some((far - 0.8 * outer, facing(0.6, 0.0, 0.8)));
        let ray = Ray::derived(at(0.6 * outer, 0.0, far), way(0.0, 0.0, -1.0));
        hit("aslant, at the height 0", &ray, exact);

        let ray = Ray::derived(at(0.9 * (ring - r), far, 0.0), way(0.0, -1.0, 0.0));
        hit("through the hole", &ray, None);
        let ray = Ray::derived(at(far, 1.002 * r, 0.0), way(-1.0, 0.0, 0.0));
        hit("over the top", &ray, None);
        let ray = Ray::derived(at(1.001 * outer, 0.0, far), way(0.0, 0.0, -1.0));
        hit("past the side", &ray, None);
        let ray = Ray::derived(at(far, 0.0, 0.0), way(1.0, 0.0, 0.0));
        hit("away from it", &ray, None);
    }

    // Four crossings on one ray, of which the interval chooses; direction of
    // length 2.
    let through = Ray::derived(Point3::new(far, 0.0, 0.0), Vector3::new(-2.0, 0.0, 0.0));
    let crossings = [ring + r, ring - r, r - ring, -ring - r].map(|x| (far - x) / 2.0);
    let mut min = 0.0;
    for (t, side) in crossings.into_iter().zip([1.0, -1.0, 1.0, -1.0]) {
        let within = Interval { min, max: 99.0 };
        let exact = Some((t, Normal3::new(side, 0.0, 0.0)));
        let what = format!("straight through, after t = {min}, {name}");
        expect_hit(check, &what, exact, BOUND, torus.hit(&through, within));
        min = t + 0.01 * r;
    }
    let before = crossings[0] - 0.01 * r;
    let got = torus.hit(&through, Interval::before(before));
    let what = format!("straight through, before t = {before}, {name}");
    expect_hit(check, &what, None, BOUND, got);
}
