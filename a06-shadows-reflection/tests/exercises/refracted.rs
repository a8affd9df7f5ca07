//! Rays into glass and out of it, also just before and beyond total reflection, compared with
//! the solution.

use crate::prelude::*;
use crate::solutions::refracted::refracted as solution;

pub fn check(
    check: &mut Check,
    refracted: impl Fn(Vector3, Normal3, f64) -> Option<Vector3> + Sync,
) {
    let bent = |(d, n, index): ([f64; 3], [f64; 3], f64), refracted: Refracted| {
        refracted(unit(d), unit(n).as_normal(), index).map(array)
    };
    // Straight in and out, aslant in, mirrored, and into air.
    let simple = [
        ([0.0, -1.0, 0.0], 2.0),
        ([0.0, 1.0, 0.0], 2.0),
        ([4.0, -3.0, 0.0], 2.0),
        ([4.0, 3.0, 0.0], 2.0),
        ([4.0, -3.0, 0.0], 1.0),
    ];
    check.compare(
        "direction {}, normal {}, index {}",
        simple.map(|(d, index)| (d, [0.0, 1.0, 0.0], index)),
        random(|r| {
            let (d, n, index) = (r.triple(1.0), unit(r.triple(1.0)), r.between(1.1, 2.5));
            let aside = unit(array(n.cross(vector(d))));
            // Just before and beyond the angle from which on all light is mirrored.
            let sin = (1.0 + [1e-6, -1e-6][r.below(2) as usize]) / index;
            let limit = array(aside * sin + n * (1.0 - sin * sin).sqrt());
            ([d, limit][r.below(2) as usize], array(n), index)
        }),
        |input| bent(input, &solution),
        |input| bent(input, &refracted),
    );
    let ball = Sphere::new(Point3::ORIGIN, 1.0);
    show(check, [[0.4, 0.3, 3.6], [0.0; 3]], ball, |ball, ray| {
        through(ball, ray, &refracted).unwrap_or(Color::new(0.8, 0.1, 0.1))
    });
}

type Refracted<'a> = &'a dyn Fn(Vector3, Normal3, f64) -> Option<Vector3>;

/// The colour seen through a ball of glass; none where no light gets out.
fn through(ball: &Sphere, ray: &Ray, refracted: Refracted) -> Option<Color> {
    let Some(hit) = ball.hit(ray, Interval::AHEAD) else {
        return Some(checkered(ray.direction()));
    };
    let inside = Ray::derived(ray.at(hit.t), refracted(ray.direction(), hit.normal, 1.5)?);
    // The far end of the chord of a ball around the origin.
    let end = inside.at(2.0 * inside.t_of(Point3::ORIGIN)) - Point3::ORIGIN;
    let normal = end.normalized()?.as_normal();
    Some(checkered(refracted(inside.direction(), normal, 1.5)?))
}

/// Snell's law with the normal on the side of the light, and the ratio of the indices.
fn snell(d: Vector3, n: Normal3, ratio: f64) -> Option<Vector3> {
    let cos = -d.dot(n);
    let squared = 1.0 - ratio * ratio * (1.0 - cos * cos);
    (squared >= 0.0).then(|| d * ratio + n * (ratio * cos - squared.sqrt()))
}

pub const VARIANTS: &[Variant] = &[
    wrong("the way out bends away from the normal", |c| {
        check(c, |d, n, index| {
            snell(d, if d.dot(n) > 0.0 { -n } else { n }, 1.0 / index)
        });
    }),
    wrong("from inside, the normal points along the light", |c| {
        check(c, |d, n, index| {
            snell(d, n, if d.dot(n) > 0.0 { index } else { 1.0 / index })
        });
    }),
    wrong("where the sine is more than 1, nothing gets out", |c| {
        check(c, |d, n, index| {
            solution(d, n, index).or(Some((-d).reflected_on(n)))
        });
    }),
];
