//! Rays aimed at points of the wall, whose distance and normal are known.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use common::exercise::Check;

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
            aimed(at(4.0, 1.0, 0.5), at(1.0, y, 0.0), "of the near wall");
            aimed(at(0.2, 1.0, 0.1), at(1.0, y, 0.0), "from inside");
            // Half way, above x = 1, the ray is at least at height 3.
            aimed(at(3.0, 6.0, 0.0), at(-1.0, y, 0.0), "over the rim");
            aimed(at(3.0, -4.0, 0.0), at(-1.0, y, 0.0), "from below");
        }
    }

    let mut missed = |from: Point3, direction: Vector3, place: &str| {
        let ray = Ray::derived(from, direction);
        expect_hit(check, place, None, BOUND, hit(&ray));
    };
    let ahead = Vector3::new(0.0, 0.0, -1.0);
    missed(
        Point3::new(0.0, 2.1, 5.0),
        ahead,
        "of nothing, above the tube",
    );
    missed(
        Point3::new(0.0, -0.1, 5.0),
        ahead,
        "of nothing, below the tube",
    );
    missed(
        Point3::new(1.001, 1.0, 5.0),
        ahead,
        "of nothing, beside the tube",
    );
    missed(
        Point3::new(0.0, 1.0, -5.0),
        ahead,
        "of nothing, away from the tube",
    );
    missed(
        Point3::new(0.5, -5.0, 0.0),
        Vector3::new(0.0, 1.0, 0.0),
        "of nothing, through it",
    );
    let steep = Vector3::new(0.0, -4.0, -1.0);
    missed(
        Point3::new(0.0, 5.0, 0.5),
        steep,
        "of nothing, in above and out below",
    );

    let through = Ray::derived(Point3::new(0.0, 1.0, 5.0), ahead);
    let behind_near = Interval { min: 4.5, max: 9.0 };
    let exact = Some((6.0, Normal3::new(0.0, 0.0, -1.0)));
    let what = "of the far wall, the near one not being in the interval";
    expect_hit(check, what, exact, BOUND, tube.hit(&through, behind_near));
    let what = "of nothing, as the interval ends before the wall";
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
