//! Asks lights, point by point: from before and from behind, in them, very near and far away.

use std::sync::Arc;

use crate::prelude::*;

/// The light that arrives at a point.
pub type Arriving = Option<Illumination>;

/// The light of some parameters that arrives at a point.
pub type LightAt<P> = Arc<dyn Fn(P, Point3) -> Arriving + Send + Sync>;

/// The code that computes light by this function.
pub fn light_at<P>(light: impl Fn(P, Point3) -> Arriving + Send + Sync + 'static) -> LightAt<P> {
    Arc::new(light)
}

/// Where the lights are whose parameters are simple.
pub const LAMP: [f64; 3] = [0.0, 4.0, 0.0];

/// Below the lamp, aslant, in it, above it, and very near to it, below and beside it.
const POINTS: [[f64; 3]; 6] = [
    [0.0, 2.0, 0.0],
    [3.0, 0.0, 0.0],
    LAMP,
    [0.0, 6.0, 0.0],
    [0.0, 4.0 - 1.0 / 65_536.0, 0.0],
    [1e-9, 4.0, 0.0],
];

/// Lights of some parameters.
pub struct Lights<P> {
    /// The parameters in words, with `{}` instead of each.
    pub words: &'static str,
    /// Parameters of round numbers.
    pub first: P,
    /// Further parameters and points of round numbers, such as of light without a direction.
    pub simple: Vec<(P, [f64; 3])>,
    /// Further parameters and points, such as on the axis of a spot.
    pub others: Vec<(P, [f64; 3])>,
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

/// Asks lights of one kind after the other: the first of each kind at simple places, and then any
/// one.
pub fn lights<P: Input + 'static>(
    lights: impl IntoIterator<Item = Lights<P>>,
) -> Exercise<LightAt<P>> {
    Exercise {
        questions: lights.into_iter().flat_map(Lights::questions).collect(),
        ..Exercise::default()
    }
}

impl<P: Input + 'static> Lights<P> {
    fn questions(self) -> Vec<CodeQuestion<LightAt<P>>> {
        let mut simple = Vec::new();
        for p in POINTS {
            simple.push((self.first.clone(), p));
        }
        simple.extend(self.simple);
        let mut others = self.others;
        let mut places = Random::new(2);
        for light in random(self.any) {
            let scale = [1.0, 1.0, 1e-6, 1e6][places.below(4) as usize];
            others.push((light, places.triple(9.0).map(|x| x * scale)));
        }
        let questions = Questions {
            words: format!("{}, seen from {{}}", self.words).leak(),
            simple,
            others,
            answer: |light: &LightAt<P>, (parameters, p): (P, [f64; 3])| {
                light_answer(light(parameters, point(p)))
            },
        };
        questions.into()
    }
}

/// A random point that a lamp sees at this angle from its axis.
pub fn at_angle(random: &mut Random, lamp: [f64; 3], axis: [f64; 3], angle: f64) -> [f64; 3] {
    let axis = unit(axis);
    let side = unit(array(axis.cross(vector(random.triple(1.0)))));
    let (sine, cosine) = libm::sincos(angle);
    let way = (axis * cosine + side * sine) * random.between(0.1, 9.0);
    array(point(lamp) + way)
}

/// Light as an answer.
#[must_use]
pub fn light_answer(light: Arriving) -> Answer {
    light.map_or(Answer::words("no light"), |light| {
        Answer::named("colour", light.color.channels())
            .and("direction", array(light.direction))
            .and("distance", light.distance)
    })
}
