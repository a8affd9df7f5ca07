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

/// A walk in steps of a sixteenth of the tube until the distance changes its sign.
fn fixed_steps(torus: &Torus, [ring, r]: [f64; 2], ray: &Ray, within: Interval) -> Option<Hit> {
    let at = |t: f64| {
        let p = ray.at(t);
        libm::hypot(libm::hypot(p.x(), p.z()) - ring, p.y()) - r
    };
    let step = r / 16.0 / ray.direction().magnitude();
    let middle = ray.t_of(Point3::ORIGIN);
    let start = within.min.max(middle - 1000.0 * step);
    let walk = (1..10_000).map(|n| start + step * f64::from(n));
    let crossed = walk
        .take_while(|t| (at(*t) < 0.0) == (at(start + step) < 0.0))
        .last()?;
    torus.hit(
        ray,
        Interval {
            min: crossed,
            max: within.max.min(crossed + 2.0 * step),
        },
    )
}

pub const VARIANTS: &[Variant] = &[
    wrong("fixed steps pass over what is thinner than a step", |c| {
        check(c, |ring, r| {
            let torus = Torus::new(ring, r)?;
            own(move |ray: &Ray, i| fixed_steps(&torus, [ring, r], ray, i))
        });
    }),
    wrong(
        "within the tube the distance is negative, and the walk goes on",
        |c| {
            check(c, |ring, r| {
                let torus = Torus::new(ring, r)?;
                own(move |ray: &Ray, i| {
                    torus
                        .hit(ray, i)
                        .filter(|hit| hit.normal.dot(ray.direction()) < 0.0)
                })
            });
        },
    ),
    wrong("the interval says where the walk ends, too", |c| {
        check(c, |ring, r| {
            let torus = Torus::new(ring, r)?;
            own(move |ray: &Ray, i: Interval| {
                torus.hit(
                    ray,
                    Interval {
                        max: f64::INFINITY,
                        ..i
                    },
                )
            })
        });
    }),
];
