//! Colours in fog, thick and thin, compared with the solution.

use crate::prelude::*;
use crate::solutions::fogged::fogged as right;

yours! { fogged }

/// The colour behind fog: of a colour, that of the fog, its density, and the distance.
type Code = fn(Color, Color, f64, f64) -> Color;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let inf = f64::INFINITY;
    let amounts = [(1.0, 0.0), (0.0, 2.0), (1.0, 1.0), (1.0, inf), (0.0, inf)];
    let colors = Questions {
        words: "colour {}, fog {}, density {}, distance {}",
        simple: amounts
            .map(|(density, distance)| (Color::RED, Color::BLUE, density, distance))
            .to_vec(),
        others: random(|r| {
            (
                r.color(),
                r.color(),
                r.between(0.0, 0.5),
                r.between(0.0, 9.0),
            )
        }),
        answer: |fogged: &Code, (own, fog, density, distance)| fogged(own, fog, density, distance),
    };
    Exercise {
        questions: colors.into(),
        picture: Picture::own(|fogged: &Code, settings| {
            rendered(&scenes::sphere()?, settings, |world, ray, depth| {
                let clear = RecursiveTracer::new(world).trace(ray, depth);
                let nearest = world.objects().hit(ray, Interval::AHEAD);
                let distance = nearest.map_or(f64::INFINITY, |(hit, _)| hit.t);
                fogged(clear, Color::new(0.7, 0.75, 0.8), 0.08, distance)
            })
        }),
        wrong: vec![
            Other::new(
                "0 times infinity is not a number",
                |own, fog, density, distance| mixed(own, fog, libm::exp(-density * distance)),
            ),
            Other::new(
                "each metre takes a fraction of what is left",
                |own, fog, density, distance| mixed(own, fog, 1.0 - (density * distance).min(1.0)),
            ),
            Other::new(
                "the fog adds its own colour",
                |own, _, density, distance| right(own, Color::BLACK, density, distance),
            ),
        ],
        ..Exercise::default()
    }
}

/// The mixture by the fraction that is left of the colour.
fn mixed(own: Color, fog: Color, left: f64) -> Color {
    own * left + fog * (1.0 - left)
}
