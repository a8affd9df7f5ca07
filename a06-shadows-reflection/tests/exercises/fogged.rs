//! Colours in fog, thick and thin, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &(dyn Fn(Color, Color, f64, f64) -> Color + Sync)) {
    let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let inf = f64::INFINITY;
    let amounts = [(1.0, 0.0), (0.0, 2.0), (1.0, 1.0), (1.0, inf), (0.0, inf)];
    check.compare(
        "colour {}, fog {}, density {}, distance {}",
        amounts.map(|(density, distance)| (red, blue, density, distance)),
        random(|r| {
            let [c, fog] = [(); 2].map(|()| channels(r));
            (c, fog, r.between(0.0, 0.5), r.between(0.0, 9.0))
        }),
        [&fogged as _, yours],
        |fogged, (c, fog, density, t)| fogged(color(c), color(fog), density, t).channels(),
    );
    check.picture(rendered(scenes::sphere(), |world, ray, depth| {
        let clear = RecursiveTracer::new(world).trace(ray, depth);
        let nearest = world.objects().hit(ray, Interval::AHEAD);
        let distance = nearest.map_or(f64::INFINITY, |(hit, _)| hit.t);
        yours(clear, Color::new(0.7, 0.75, 0.8), 0.08, distance)
    }));
}

variants! { check:
    yours => &fogged;
    wrong "0 times infinity is not a number" => &mixed(|density, t| libm::exp(-density * t));
    wrong "each metre takes a share of what is left" => &mixed(|density, t| {
        1.0 - (density * t).min(1.0)
    });
    wrong "the fog adds its own colour" => &|color, _, density, t| {
        fogged(color, Color::BLACK, density, t)
    };
}

/// The mixture by the share that is left of the colour.
fn mixed(left: fn(f64, f64) -> f64) -> impl Fn(Color, Color, f64, f64) -> Color {
    move |color, fog, density, distance| {
        let left = left(density, distance);
        color * left + fog * (1.0 - left)
    }
}
