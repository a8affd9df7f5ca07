//! Rays aimed at points of the walls of many tubes, whose distance and normal are
//! known.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use testing::exercise::{Check, Random};

use crate::shape::{TURNS, expect_hit, show, turned};

/// Some roundings of coordinates up to 100, a little more along the rim.
const BOUND: f64 = 1e-12;

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(f64, f64) -> Result<G, ArgumentError>,
) {
    let Ok(tube) = new(1.0, 2.0) else { return };
    expect_tube(check, &tube, 1.0, 2.0);
    let mut random = Random::new(5);
    let wide_and_slim = [(3.0, 0.5), (0.25, 8.0)];
    let more = std::iter::repeat_with(|| (random.between(0.1, 9.0), random.between(0.1, 9.0)));
    for (r, height) in wide_and_slim.into_iter().chain(more.take(6)) {
        if let Ok(tube) = new(r, height) {
            expect_tube(check, &tube, r, height);
        }
    }
    show(
        check,
        tube,
        Point3::new(1.5, 4.5, 4.5),
        Point3::new(0.0, 0.9, 0.0),
    );
}

fn expect_tube(check: &mut Check, tube: &impl Geometry, r: f64, height: f64) {
    let name = format!("radius {r}, height {height}");
    let hit = |ray: &Ray| tube.hit(ray, Interval::AHEAD);
    // In radii to the side, and in halves of the height up.
    let scaled = |p: Vector3| Vector3::new(p.x() * r, p.y() * height / 2.0, p.z() * r);
    let point = |x, y, z| Point3::ORIGIN + scaled(Vector3::new(x, y, z));

    let mut aimed = |from: Vector3, at: Vector3, place: &str| {
        let normal = Normal3::new(at.x(), 0.0, at.z());
        let (from, at) = (Point3::ORIGIN + scaled(from), Point3::ORIGIN + scaled(at));
        // One step of this ray leads to the wall.
        let ray = Ray::derived(from, at - from);
        let (from, at) = (from.to_glam(), at.to_glam());
        let what = format!("{place}, from {from:.3} to {at:.3}, {name}");
        expect_hit(check, &what, Some((1.0, normal)), BOUND, hit(&ray));
    };
    for turn in TURNS {
        let at = |x, y, z| turned(turn, x, y, z);
        for y in [0.5, 1.0, 1.5] {
            aimed(at(4.0, 1.0, 0.5), at(1.0, y, 0.0), "at the near wall");
            aimed(at(0.2, 1.0, 0.1), at(1.0, y, 0.0), "from inside");
            // Half way, above x = 1, the ray is at least at height 3.
            aimed(at(3.0, 6.0, 0.0), at(-1.0, y, 0.0), "over the rim");
            aimed(at(3.0, -4.0, 0.0), at(-1.0, y, 0.0), "from below");
        }
    }

    let mut ahead = |x: f64, y: f64, exact: Option<(f64, Normal3)>, place: &str| {
        let ray = Ray::derived(point(x, y, 5.0), Vector3::new(0.0, 0.0, -1.0));
        expect_hit(check, &format!("{place}, {name}"), exact, BOUND, hit(&ray));
    };
    let front = Some((4.0 * r, Normal3::new(0.0, 0.0, 1.0)));
    ahead(0.0, 2.0, front, "at the rim, which belongs to it");
    ahead(0.0, 0.0, front, "at the bottom, which belongs to it");
    ahead(0.0, 2.0 - 1e-9, front, "just below the rim");
    ahead(0.0, 2.0 + 1e-9, None, "just above the rim");
    ahead(0.0, 1e-9, front, "just above the bottom");
    ahead(0.0, -1e-9, None, "just below the bottom");
    ahead(1.0 + 1e-9, 1.0, None, "just beside the wall");
    if [0.25, 1.0, 3.0].contains(&r) {
        // The discriminant of these is 0 without rounding.
        let side = Some((5.0 * r, Normal3::new(1.0, 0.0, 0.0)));
        ahead(1.0, 1.0, side, "touching the wall");
    }
    let aslant = Some((4.2 * r, Normal3::new(0.6, 0.0, 0.8)));
    ahead(0.6, 1.0, aslant, "at the near wall, beside its middle");

    let mut missed = |from: Point3, way: Vector3, place: &str| {
        let ray = Ray::derived(from, scaled(way));
        expect_hit(check, &format!("{place}, {name}"), None, BOUND, hit(&ray));
    };
    let back = Vector3::new(0.0, 0.0, -1.0);
    missed(point(0.0, 1.0, -5.0), back, "away from the tube");
    let up = Vector3::new(0.0, 1.0, 0.0);
    missed(point(0.5, -5.0, 0.0), up, "up through the tube");
    missed(point(1.5, -5.0, 0.0), up, "up beside the tube");
    let down = Vector3::new(0.0, -4.0, -1.0);
    missed(point(0.0, 5.0, 0.5), down, "in above and out below");

    let through = Ray::derived(point(0.0, 1.0, 5.0), scaled(back));
    let behind_near = Interval { min: 4.5, max: 9.0 };
    let exact = Some((6.0, Normal3::new(0.0, 0.0, -1.0)));
    let what = format!("at the far wall, the near one not being in the interval, {name}");
    expect_hit(check, &what, exact, BOUND, tube.hit(&through, behind_near));
    let what = format!("as the interval ends before the wall, {name}");
    let before = Interval::before(3.9);
    expect_hit(check, &what, None, BOUND, tube.hit(&through, before));
}
