//! Surfaces that face all directions, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &(dyn Fn([Color; 3], Normal3) -> Color + Sync)) {
    let day = [[1.0, 0.5, 0.25], [0.0, 0.5, 1.0], [0.5, 0.25, 0.0]];
    let normals = [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]];
    check.compare(
        "diffuse, sky and ground {}, normal {}",
        normals.map(|n| (day, n)),
        random(|r| ([(); 3].map(|()| channels(r)), r.triple(1.0))),
        [&hemisphere as _, yours],
        |hemisphere, (colors, n)| hemisphere(colors.map(color), unit(n).as_normal()).channels(),
    );
    let [sky, ground] = [[0.8, 0.95, 1.2], [0.3, 0.22, 0.1]].map(color);
    check.picture(shaded(scenes::lambert(), |diffuse, _, hit, _| {
        yours([diffuse, sky, ground], hit.normal)
    }));
}

variants! { mixed:
    yours => &hemisphere;
    wrong "walls see half the sky" => |cos| cos.max(0.0);
    wrong "a share is between 0 and 1" => |cosine| cosine;
    wrong "the share follows from the cosine, not the angle" => |cosine| {
        1.0 - libm::acos(cosine) / std::f64::consts::PI
    };
}

/// Sky and ground with another share of the sky, from the cosine of the angle to up.
fn mixed(c: &mut Check, share: fn(f64) -> f64) {
    check(c, &|[diffuse, sky, ground], n| {
        diffuse * (sky * share(n.y()) + ground * (1.0 - share(n.y())))
    });
}
