//! Rays aimed at points of all six faces of many boxes, from outside and from inside,
//! and past their edges.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use testing::exercise::{Check, Random};

use crate::shape::{expect_hit, show};

/// Some roundings of coordinates up to 20.
const BOUND: f64 = 1e-12;

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(Point3, Point3) -> Result<G, ArgumentError>,
) {
    // No number of these is exact in binary.
    let (lbf, run) = ([-0.3, 0.1, -0.7], [0.4, 1.2, 0.6]);
    let Ok(shape) = new(point(lbf), point(run)) else {
        return;
    };
    let mut random = Random::new(3);
    expect_faces(check, &shape, lbf, run, &mut random);
    for _ in 0..8 {
        let lbf = [(); 3].map(|()| random.between(-5.0, 4.0));
        let run = lbf.map(|low| low + random.between(0.1, 6.0));
        if let Ok(shape) = new(point(lbf), point(run)) {
            expect_faces(check, &shape, lbf, run, &mut random);
        }
    }
    show(
        check,
        shape,
        Point3::new(2.0, 2.2, 2.9),
        Point3::new(0.05, 0.6, 0.0),
    );
}

fn expect_faces(
    check: &mut Check,
    shape: &impl Geometry,
    lbf: [f64; 3],
    run: [f64; 3],
    random: &mut Random,
) {
    let name = format!("box from {lbf:?} to {run:?}");
    let mut expect = |from: [f64; 3], way: Vector3, within, exact, place: &str| {
        let ray = Ray::derived(point(from), way);
        let what = format!(
            "{place}, from {from:.3?} along {:.3}, {name}",
            way.to_glam()
        );
        expect_hit(check, &what, exact, BOUND, shape.hit(&ray, within));
    };
    for axis in 0..3 {
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        for (side, near, far) in [(-1.0, lbf, run), (1.0, run, lbf)] {
            let normal = |side: f64| {
                let mut normal = [0.0; 3];
                normal[axis] = side;
                Normal3::from_glam(normal.into())
            };
            for (i, j) in (1..10).flat_map(|i| (1..10).map(move |j| (i, j))) {
                let mut at = near;
                for (other, share) in others.into_iter().zip([i, j]) {
                    at[other] += (far[other] - near[other]) * (f64::from(share) / 10.0);
                }
                let (mut outside, mut inside) = (at, at);
                for k in 0..3 {
                    outside[k] += random.between(-3.0, 3.0);
                    inside[k] = lbf[k] + (run[k] - lbf[k]) * random.between(0.05, 0.95);
                }
                outside[axis] = near[axis] + side * random.between(0.2, 5.0);
                for (from, place) in [(outside, "from outside"), (inside, "from inside")] {
                    // One step of this ray leads to the face.
                    let way = point(at) - point(from);
                    expect(from, way, Interval::AHEAD, Some((1.0, normal(side))), place);
                }
            }

            // Straight through, one away from the near face.
            let way = Vector3::from(normal(-side));
            let mut from = [0, 1, 2].map(|k| lbf[k] + (run[k] - lbf[k]) * 0.3);
            from[axis] = near[axis] + side;
            let to_far = 1.0 + (run[axis] - lbf[axis]);
            let front = Some((1.0, normal(side)));
            let back = Some((to_far, normal(-side)));
            let behind = Interval {
                min: 1.01,
                max: 99.0,
            };
            expect(from, way, behind, back, "the near face not in the interval");
            let before = Interval::before(0.99);
            expect(from, way, before, None, "the interval ends before it");
            expect(from, -way, Interval::AHEAD, None, "away from it");
            for other in others {
                for (border, out) in [(lbf[other], -1.0), (run[other], 1.0)] {
                    from[other] = border;
                    expect(from, way, Interval::AHEAD, front, "just on its edge");
                    from[other] = border + out * 1e-7;
                    expect(from, way, Interval::AHEAD, None, "just beside it");
                    from[other] = border - out * 1e-7;
                    expect(from, way, Interval::AHEAD, front, "just inside its edge");
                }
                from[other] = lbf[other] + (run[other] - lbf[other]) * 0.3;
            }
        }
    }
}

fn point(xyz: [f64; 3]) -> Point3 {
    Point3::from_glam(xyz.into())
}
