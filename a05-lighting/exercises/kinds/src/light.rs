//! Asks lights, point by point: from before and from behind, in them, far away, and just inside
//! and outside of a border.

use std::array;
use std::sync::Arc;

use a02_math::Point3;
use a02_math::arrays::{array, point};
use a05_lighting::Illumination;
use testing::exercises::{
    Answer, CodeQuestion, Exercise, Group, Input, Questions, Random, Variant, random, searched,
};

use crate::numbers::unit;

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

/// Below the lamp, aslant, and in it.
const POINTS: [[f64; 3]; 3] = [[0.0, 2.0, 0.0], [3.0, 0.0, 0.0], LAMP];

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
/// one; and the mistakes that all lights may have.
pub fn lights<P: Input + 'static>(
    lights: impl IntoIterator<Item = Lights<P>>,
) -> Exercise<LightAt<P>> {
    Exercise {
        questions: lights.into_iter().map(Lights::questions).collect(),
        usual: vec![
            mistake("the direction leads to the light", |light| Illumination {
                direction: -light.direction,
                ..light
            }),
            mistake("the direction has length 1", |light| Illumination {
                direction: light.direction * light.distance.min(9.0),
                ..light
            }),
            mistake("the distance says which objects cast shadows", |light| {
                Illumination {
                    distance: 1.0,
                    ..light
                }
            }),
        ],
        ..Exercise::default()
    }
}

fn mistake<P: 'static>(
    about: &'static str,
    flawed: fn(Illumination) -> Illumination,
) -> Variant<LightAt<P>> {
    Variant::from_right(about, move |right: LightAt<P>| {
        light_at(move |parameters, p| right(parameters, p).map(flawed))
    })
}

impl<P: Input + 'static> Lights<P> {
    fn questions(self) -> Group<LightAt<P>> {
        let any = self.any;
        searched(
            move |light| find_borders(light, any),
            move |found| self.ask(found),
        )
    }

    fn ask(&self, borders: &[f64]) -> Vec<CodeQuestion<LightAt<P>>> {
        let (points, _) = borders.as_chunks::<3>();
        let (borders, _) = points.as_chunks::<3>();
        let mut simple = Vec::new();
        for p in POINTS {
            simple.push((self.first.clone(), p));
        }
        simple.extend(self.simple.clone());
        let mut others = Vec::new();
        for (light, [p, near_side, far_side]) in random(self.any).iter().zip(borders) {
            let far_away = p.map(|x| 1e6 * x);
            for p in [*p, far_away, *near_side, *far_side] {
                others.push((light.clone(), p));
            }
        }
        others.extend(self.others.clone());
        let questions = Questions {
            words: format!("{}, seen from {{}}", self.words),
            simple,
            others,
            answer: |light: &LightAt<P>, (parameters, p): (P, [f64; 3])| {
                light_answer(light(parameters, point(p)))
            },
        };
        questions.asked()
    }
}

/// Finds, for each random light, three points: a random one, and both sides of a border between
/// light and darkness. Where there is none between two random points, both sides are at the
/// second one.
fn find_borders<P: Input>(light: &LightAt<P>, any: fn(&mut Random) -> P) -> Vec<f64> {
    let mut places = Random::new(2);
    let mut numbers = Vec::new();
    for parameters in random(any) {
        let is_lit = |p: [f64; 3]| light(parameters.clone(), point(p)).is_some();
        let [p, other] = [places.triple(9.0), places.triple(9.0)];
        let (mut near_side, mut far_side) = (p, other);
        for _ in 0..20 {
            let middle = array::from_fn(|i| f64::midpoint(near_side[i], far_side[i]));
            if is_lit(middle) == is_lit(p) {
                near_side = middle;
            } else {
                far_side = middle;
            }
        }
        numbers.extend([p, near_side, far_side].as_flattened());
    }
    numbers
}

/// A random point on the axis of a spot.
pub fn on_axis(random: &mut Random, lamp: [f64; 3], axis: [f64; 3]) -> [f64; 3] {
    array(point(lamp) + unit(axis) * random.between(0.1, 9.0))
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
