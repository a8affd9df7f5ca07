//! Tori of many sizes, compared with the solution.

use crate::prelude::*;
use crate::solutions::torus::Torus;

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(f64, f64) -> Result<G, ArgumentError>) {
    for (ring, r) in [(2.0, 0.5), (1.0, 0.75), (3.0, 0.1), (0.4, 0.3), (7.0, 3.5)] {
        let (Ok(solution), Ok(yours)) = (Torus::new(ring, r), new(ring, r)) else {
            continue;
        };
        let words = format!("circle of radius {ring}, tube of radius {r}; {RAY}");
        // From above, from the side, from inside, through the hole, and beside it.
        let xs = [ring, 0.0, 2.0 * ring + r];
        let simple = xs.map(|x| ([x, 8.0, 0.0], [0.0, -1.0, 0.0], 0.0, f64::INFINITY));
        let inside = ([ring, 0.0, 0.0], [-1.0, 0.0, 0.0], 0.0, f64::INFINITY);
        // An interval may begin anywhere, but not as near to a surface as a smallest step.
        let rays = rays(&solution)
            .into_iter()
            .filter(|(_, _, min, _)| *min == 0.0);
        let simple = simple.into_iter().chain([inside]);
        check.compare(
            &words,
            simple,
            rays,
            |i| hit(&solution, i),
            |i| hit(&yours, i),
        );
    }
    show(
        check,
        new(2.0, 0.5),
        Point3::new(2.0, 5.0, 7.0),
        Point3::new(0.0, -0.2, 0.0),
    );
}

/// How far a point of a ray is from the surface.
fn distance([ring, r]: [f64; 2], p: Point3) -> f64 {
    libm::hypot(libm::hypot(p.x(), p.z()) - ring, p.y()) - r
}

/// A walk in steps that follow from the distance, in lengths, until the distance changes its
/// sign, and then halving.
fn walk(c: &mut Check, step: fn(f64, f64) -> f64) {
    check(c, move |ring, r| {
        own(move |ray: &Ray, within: Interval| {
            let at = |t| distance([ring, r], ray.at(t));
            let length = ray.direction().magnitude();
            let reach = (ring + 2.0 * r) / length;
            let middle = ray.t_of(Point3::ORIGIN);
            let mut near = within.min.max(middle - reach) + 1e-4 * r / length;
            let mut far = near;
            while (at(far) < 0.0) == (at(near) < 0.0) {
                (far <= middle + reach).then_some(near = far)?;
                far += step(at(far).abs(), r) / length;
            }
            for _ in 0..100 {
                let t = f64::midpoint(near, far);
                *(if (at(t) < 0.0) == (at(near) < 0.0) {
                    &mut near
                } else {
                    &mut far
                }) = t;
            }
            let p = ray.at(far);
            let scale = 1.0 - ring / libm::hypot(p.x(), p.z());
            let n = vector([p.x() * scale / r, p.y() / r, p.z() * scale / r]);
            within.contains(far).then(|| Hit::new(far, n.as_normal()))
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("half of the distance", |c| {
        walk(c, |d, r| (d / 2.0).max(1e-4 * r))
    }),
    wrong("fixed steps pass over what is thinner than a step", |c| {
        walk(c, |_, r| r / 16.0)
    }),
    wrong(
        "a step longer than the distance passes through the tube",
        |c| {
            walk(c, |d, r| (2.0 * d).max(0.01 * r));
        },
    ),
    wrong("the interval says where the walk ends, too", |c| {
        check(c, |ring, r| {
            let torus = Torus::new(ring, r)?;
            own(move |ray: &Ray, _| torus.hit(ray, Interval::AHEAD))
        });
    }),
];
