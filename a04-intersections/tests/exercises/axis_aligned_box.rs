//! Boxes anywhere, met on each face from outside and from inside, missed beside the edges,
//! and by rays parallel to faces.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, World};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::aimed::{Shown, expect_scene, perspective, point};

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Point3) -> Result<G, ArgumentError>,
) {
    let mut random = Random::new(43);
    for _ in 0..10 {
        let lbf = point(&mut random, 5.0);
        let extent = [(); 3].map(|()| random.between(0.5, 5.0));
        let run = lbf + Vector3::from_glam(extent.into());
        let Ok(aab) = new(lbf, run) else { continue };
        let words = format!("box from {} to {:.2}", lbf.to_glam(), run.to_glam());
        let aab = Shown { shape: &aab, words };
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                expect_face(check, &mut random, &aab, lbf, extent, axis, sign);
            }
        }
    }
    expect_scene(check, "scene-3", || {
        let camera = perspective(Point3::new(3.0, 3.0, 3.0), Vector3::new(-3.0, -3.0, -3.0))?;
        let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
        Ok((
            camera,
            World::new(Color::BLACK)?.with(new(lbf, run)?, Color::BLUE),
        ))
    });
}

/// Rays to the face of an axis on the side of a sign.
fn expect_face(
    check: &mut Check,
    random: &mut Random,
    aab: &Shown,
    lbf: Point3,
    extent: [f64; 3],
    axis: usize,
    sign: f64,
) {
    // The point at these shares of the edges from `lbf`; the axis of the face comes first.
    let place = |share: [f64; 3]| {
        let mut step = [0.0; 3];
        for (i, share) in share.into_iter().enumerate() {
            let axis = (axis + i) % 3;
            step[axis] = share * extent[axis];
        }
        lbf + Vector3::from_glam(step.into())
    };
    let [outside, face, inside] = [1.5, 0.5, -0.3].map(|height| 0.5 + sign * height);
    let mut normal = [0.0; 3];
    normal[axis] = sign;
    let n = Normal3::from_glam(normal.into());
    let mut share = || random.between(0.1, 0.9);
    let at = place([face, share(), share()]);
    let from = place([outside, share(), share()]);
    aab.expect_nearest(check, "from outside", from, at, n);
    aab.expect_nearest(
        check,
        "from inside",
        place([inside, share(), share()]),
        at,
        n,
    );
    aab.expect_none(check, "the box lies behind", from, from - at);

    let (v, w) = (share(), share());
    let (before, at) = (place([outside, v, w]), place([face, v, w]));
    aab.expect_nearest(check, "parallel to four faces", before, at, n);
    // Through the box, from face to face: twice the way as far as to the first.
    let second = Interval {
        min: 1.0 + 1e-6,
        max: f64::INFINITY,
    };
    let ray = Ray::derived(before, at - before);
    let what = "the far face, as the interval begins after the near one";
    aab.expect(check, what, &ray, second, Some((2.0, -n)));
    for (what, beside) in [("just beside an edge", 1e-6), ("beside the box", 0.3)] {
        for share in [-beside, 1.0 + beside] {
            let (from, to) = (place([outside, share, w]), place([face, share, w]));
            aab.expect_none(check, &format!("{what}, parallel to it"), from, to - from);
        }
        let (from, to) = (
            place([face + sign * beside, -2.0, w]),
            place([face + sign * beside, 3.0, w]),
        );
        aab.expect_none(check, &format!("{what}, over the face"), from, to - from);
    }
}
