//! Asks materials for the colours of surfaces that an eye sees.

use std::sync::Arc;

use crate::prelude::*;

/// The colour of a surface of some parameters, by the ray, its hit, and the light there.
pub type Shading<P> = Arc<dyn Fn(P, &Ray, &Hit, &dyn Lighting) -> Color + Send + Sync>;

/// The code that shades surfaces by this function.
pub fn shading<P>(
    color: impl Fn(P, &Ray, &Hit, &dyn Lighting) -> Color + Send + Sync + 'static,
) -> Shading<P> {
    Arc::new(color)
}

/// Materials of some parameters.
pub struct Materials<P> {
    /// The parameters in words, with `{}` instead of each.
    pub words: &'static str,
    /// Parameters of round numbers.
    pub first: P,
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

/// Asks materials of one kind after the other: the first of each kind on simple surfaces, and then
/// any one.
pub fn materials<P: Input + 'static>(
    materials: impl IntoIterator<Item = Materials<P>>,
) -> Exercise<Shading<P>> {
    Exercise {
        questions: materials
            .into_iter()
            .flat_map(Materials::questions)
            .collect(),
        ..Exercise::default()
    }
}

impl<P: Input + 'static> Materials<P> {
    fn questions(self) -> Vec<CodeQuestion<Shading<P>>> {
        let Self { words, first, any } = self;
        let questions = Questions {
            words: format!("{words}, {SEEN}").leak(),
            simple: Seen::simple().map(|seen| (first.clone(), seen)).to_vec(),
            others: random(|r| (any(r), Seen::any(r))),
            answer: |shading: &Shading<P>, (parameters, seen): (P, Seen)| {
                shading(parameters, &seen.ray(), &seen.hit(), &seen.light()).channels()
            },
        };
        questions.into()
    }
}

/// The ambient light that a surface reflects, and the part that it reflects of each light.
pub fn sum(
    diffuse: Color,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
    reflected: impl Fn(&Illumination) -> Color,
) -> Color {
    let mut sum = diffuse * lighting.ambient();
    lighting.for_each_light(ray, hit, &mut |light| sum += reflected(light));
    sum
}
