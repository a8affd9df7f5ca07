//! Rays aimed at points of the wall, whose distance and normal are known.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use testing::exercise::Check;

use crate::shape::{TURNS, expect_hit, show, turned};

/// Some roundings of coordinates up to 10, a little more along the rim.
const BOUND: f64 = 1e-13;

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(f64, f64) -> Result<G, ArgumentError>,
) {
    let Ok(tube) = new(1.0, 2.0) else { return };
    let hit = |ray: &Ray| tube.hit(ray, Interval::AHEAD);

    let mut aimed = |from: Point3, at: Point3, place: &str| {
        let way = at - from;
        // One step of this ray leads to the wall.
        let ray = Ray::derived(from, way);
        let exact = Some((1.0, Normal3::new(at.x(), 0.0, at.z())));
        let what = format!("{place}, from {} to {}", from.to_glam(), at.to_glam());
        expect_hit(check, &what, exact, BOUND, hit(&ray));
    };
    for turn in TURNS {
        let at = |x, y, z| Point3::ORIGIN + turned(turn, x, y, z);
        for y in [0.5, 1.0, 1.5] {
            aimed(at(4.0, 1.0, 0.5), at(1.0, y, 0.0), "at the near wall");
            aimed(at(0.2, 1.0, 0.1), at(1.0, y, 0.0), "from inside");
            // Half way, above x = 1, the ray is at least at height 3.
            aimed(at(3.0, 6.0, 0.0), at(-1.0, y, 0.0), "over the rim");
            aimed(at(3.0, -4.0, 0.0), at(-1.0, y, 0.0), "from below");
        }
    }

    let mut ahead = |x: f64, y: f64, exact: Option<(f64, Normal3)>, place: &str| {
        let ray = Ray::derived(Point3::new(x, y, 5.0), Vector3::new(0.0, 0.0, -1.0));
        expect_hit(check, place, exact, BOUND, hit(&ray));
    };
    let front = Some((4.0, Normal3::new(0.0, 0.0, 1.0)));
    ahead(0.0, 2.0 - 1e-9, front, "just below the rim");
    ahead(0.0, 2.0 + 1e-9, None, "just above the rim");
    ahead(0.0, 1e-9, front, "just above the bottom");
    ahead(0.0, -1e-9, None, "just below the bottom");
    ahead(1.0 + 1e-9, 1.0, None, "just beside the wall");

    let mut missed = |from: Point3, x: f64, y: f64, z: f64, place: &str| {
        let ray = Ray::derived(from, Vector3::new(x, y, z));
        expect_hit(check, place, None, BOUND, hit(&ray));
    };
    let behind = Point3::new(0.0, 1.0, -5.0);
    missed(behind, 0.0, 0.0, -1.0, "away from the tube");
    let below = Point3::new(0.5, -5.0, 0.0);
    missed(below, 0.0, 1.0, 0.0, "up through the tube");
    let above = Point3::new(0.0, 5.0, 0.5);
    missed(above, 0.0, -4.0, -1.0, "in above and out below");

    let through = Ray::derived(Point3::new(0.0, 1.0, 5.0), Vector3::new(0.0, 0.0, -1.0));
    let behind_near = Interval { min: 4.5, max: 9.0 };
    let exact = Some((6.0, Normal3::new(0.0, 0.0, -1.0)));
    let what = "at the far wall, the near one not being in the interval";
    expect_hit(check, what, exact, BOUND, tube.hit(&through, behind_near));
    let what = "as the interval ends before the wall";
    expect_hit(
        check,
        what,
        None,
        BOUND,
        tube.hit(&through, Interval::before(3.9)),
    );

    show(
        check,
        tube,
        Point3::new(1.5, 4.5, 4.5),
        Point3::new(0.0, 0.9, 0.0),
    );
}
