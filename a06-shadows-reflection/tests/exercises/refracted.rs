//! Rays into glass and out of it, also just before and beyond total reflection, compared with
//! the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Vector3, Normal3, f64) -> Option<Vector3>) {
    // Straight in and out, aslant in, and mirrored.
    let ends = [(0.0, -1.0), (0.0, 1.0), (4.0, -3.0), (4.0, 3.0)];
    check.compare(
        "direction {}, normal {}, index {}",
        ends.map(|(x, y)| ([x, y, 0.0], [0.0, 1.0, 0.0], 2.0)),
        random(|r| {
            let (d, n, index) = (r.triple(1.0), unit(r.triple(1.0)), r.between(1.1, 2.5));
            let aside = unit(array(n.cross(vector(d))));
            // Just before and beyond the angle from which on all light is mirrored.
            let sin = (1.0 + [1e-6, -1e-6][r.below(2) as usize]) / index;
            let limit = array(aside * sin + n * (1.0 - sin * sin).sqrt());
            ([d, limit][r.below(2) as usize], array(n), index)
        }),
        [refracted, yours],
        |refracted, (d, n, index)| refracted(unit(d), unit(n).as_normal(), index).map(array),
    );
    // Objects below the surface of a water, seen from above.
    let (surface, up) = (2.5, Normal3::new(0.0, 1.0, 0.0));
    check.picture(rendered(scenes::sphere(), |world, ray, depth| {
        let at = ray.at((surface - ray.origin().y()) / ray.direction().y());
        let below = yours(ray.direction(), up, 4.0 / 3.0);
        below.map_or(Color::BLACK, |below| {
            RecursiveTracer::new(world).trace(&Ray::derived(at, below), depth)
        })
    }));
}

variants! { check:
    yours => refracted;
    wrong "the way out bends away from the normal" => |d, n, index| {
        snell(d, if d.dot(n) > 0.0 { -n } else { n }, 1.0 / index)
    };
    wrong "from inside, the normal points along the light" => |d, n, index| {
        snell(d, n, if d.dot(n) > 0.0 { index } else { 1.0 / index })
    };
    wrong "no sine is more than 1" => |d, n, index| {
        refracted(d, n, index).or(Some((-d).reflected_on(n)))
    };
}

/// Snell's law with the normal on the side of the light, and the ratio of the indices.
fn snell(d: Vector3, n: Normal3, ratio: f64) -> Option<Vector3> {
    let cos = -d.dot(n);
    let squared = 1.0 - ratio * ratio * (1.0 - cos * cos);
    (squared >= 0.0).then(|| d * ratio + n * (ratio * cos - squared.sqrt()))
}
