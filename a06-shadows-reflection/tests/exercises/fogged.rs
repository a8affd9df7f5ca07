//! Colours in fog, thick and thin, compared with the solution.

use std::sync::Arc;

use crate::prelude::*;

yours! { fogged => std::sync::Arc::new(fogged) }

/// The colour behind fog: of a colour, that of the fog, its density, and the distance.
type Code = Arc<dyn Fn(Color, Color, f64, f64) -> Color + Send + Sync>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let inf = f64::INFINITY;
    let amounts = [(1.0, 0.0), (0.0, 2.0), (1.0, 1.0), (1.0, inf), (0.0, inf)];
    let colors = Questions {
        words: "colour {}, fog {}, density {}, distance {}".into(),
        simple: amounts
            .map(|(density, distance)| (red, blue, density, distance))
            .to_vec(),
        others: random(|r| {
            let [own, fog] = [(); 2].map(|()| channels(r));
            (own, fog, r.between(0.0, 0.5), r.between(0.0, 9.0))
        }),
        answer: |fogged: &Code, (own, fog, density, distance)| {
            fogged(color(own), color(fog), density, distance).channels()
        },
    };
    Exercise {
        questions: vec![colors.into()],
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
                mixed(|density, distance| libm::exp(-density * distance)),
            ),
            Other::new(
                "each metre takes a fraction of what is left",
                mixed(|density, distance| 1.0 - (density * distance).min(1.0)),
            ),
            Other::from_right("the fog adds its own colour", |right| {
                Arc::new(move |color, _, density, distance| {
                    right(color, Color::BLACK, density, distance)
                })
            }),
        ],
        ..Exercise::default()
    }
}

/// The mixture by the fraction that is left of the colour, which follows from density and
/// distance.
fn mixed(left: fn(f64, f64) -> f64) -> Code {
    Arc::new(move |color, fog, density, distance| {
        let left = left(density, distance);
        color * left + fog * (1.0 - left)
    })
}
