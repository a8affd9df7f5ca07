//! Asks cameras, ray by ray.

use std::sync::Arc;

use a02_math::arrays::array;
use a03_rays_cameras::{Camera, Ray};
use common::Size;
use testing::exercises::{Answer, Exercise, Input, Made, Questions, Random, random};

/// Makes a camera of some parameters.
pub type NewCamera<P> = Arc<dyn Fn(P) -> Made<Box<dyn Camera>> + Send + Sync>;

/// The code that makes cameras by this function.
pub fn new_camera<P, C: Camera + 'static>(
    new: impl Fn(P) -> Made<C> + Send + Sync + 'static,
) -> NewCamera<P> {
    Arc::new(move |parameters| Ok(Box::new(new(parameters)?)))
}

/// A camera whose rays a function of width, height and position finds.
pub struct OwnCamera<F>(pub F);

impl<F: Fn([f64; 2], [f64; 2]) -> Ray + Send + Sync + 'static> Camera for OwnCamera<F> {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        (self.0)([size.width(), size.height()].map(f64::from), [x, y])
    }
}

/// Cameras of some parameters.
pub struct Cameras<P> {
    /// The parameters in words, with `{}` instead of each.
    pub words: &'static str,
    /// Parameters of round numbers.
    pub first: P,
    /// Further parameters of round numbers, such as directions that are very short or long.
    pub further: Vec<P>,
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

/// Asks the first camera at simple positions of a picture of 5 by 3 pixels, of pictures with even
/// sides, and of pictures that have a single row or column; the further ones; and then any one.
pub fn cameras<P: Input + Send + Sync + 'static>(cameras: Cameras<P>) -> Exercise<NewCamera<P>> {
    let Cameras {
        words,
        first,
        further,
        any,
    } = cameras;
    let mut simple = Vec::new();
    for position in [[2.0, 1.0], [0.0, 1.0], [2.0, 0.0], [4.0, 2.0], [2.5, 0.5]] {
        simple.push((first.clone(), [5, 3], position));
    }
    for (size, position) in [
        ([4, 2], [1.5, 0.5]),
        ([4, 2], [3.0, 0.0]),
        ([2, 4], [0.0, 3.0]),
        ([5, 1], [2.0, 0.0]),
        ([5, 1], [4.0, 0.0]),
        ([1, 3], [0.0, 1.0]),
        ([1, 3], [0.0, 2.0]),
        ([1, 1], [0.0, 0.0]),
    ] {
        simple.push((first.clone(), size, position));
    }
    for parameters in further {
        for position in [[2.0, 1.0], [4.0, 2.0]] {
            simple.push((parameters.clone(), [5, 3], position));
        }
    }
    let rays = Questions {
        words: format!("{words}, picture of {{}} pixels, place {{}}").leak(),
        simple,
        others: random(|r| {
            let size = [(); 2].map(|()| 2 + r.below(99));
            let position = size.map(|n| r.between(-0.5, f64::from(n) - 0.5));
            (any(r), size, position)
        }),
        answer: |new: &NewCamera<P>, (parameters, [width, height], [x, y])| {
            let size = Size::new(width, height).ok()?;
            Some(ray_answer(&new(parameters).ok()?.ray_for(size, x, y)))
        },
    };
    Exercise {
        questions: rays.into(),
        ..Exercise::default()
    }
}

/// A ray as an answer.
#[must_use]
pub fn ray_answer(ray: &Ray) -> Answer {
    Answer::named("origin", array(ray.origin())).and("direction", array(ray.direction()))
}
