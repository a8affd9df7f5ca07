//! Colours in fog, thick and thin, compared with the solution.

use crate::prelude::*;

yours! { fogged }

/// The colour behind fog: of a colour, that of the fog, its density, and the distance.
type Code = fn(Color, Color, f64, f64) -> Color;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|fogged: &Code, settings| {
            rendered(&scenes::sphere()?, settings, |world, ray, depth| {
                let clear = RecursiveTracer::new(world).trace(ray, depth);
                let nearest = world.objects().hit(ray, Interval::AHEAD);
                let distance = nearest.map_or(f64::INFINITY, |(hit, _)| hit.t);
                fogged(clear, Color::new(0.7, 0.75, 0.8), 0.08, distance)
            })
        }),
        ..Exercise::asked(|fogged: &Code, (own, fog, density, distance)| {
            fogged(own, fog, density, distance)
        })
    }
}
