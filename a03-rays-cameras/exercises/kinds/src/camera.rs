//! Asks cameras, ray by ray.

use std::sync::Arc;

use a03_rays_cameras::{Camera, Ray};
use common::Size;
use testing::exercises::{Answer, Exercise, Input, Made, Questions, Random, Variant, random};

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

/// A camera whose rays a function finds with those of another camera.
struct Flawed {
    camera: Box<dyn Camera>,
    rays: Rays,
}

type Rays = fn(&dyn Camera, Size, f64, f64) -> Ray;

impl Camera for Flawed {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        (self.rays)(&*self.camera, size, x, y)
    }
}

/// Cameras of some parameters.
pub struct Cameras<P> {
    /// The parameters in words, with `{}` instead of each.
    pub words: &'static str,
    /// Parameters of round numbers.
    pub first: P,
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

/// Asks the first camera at simple positions of a picture of 5 by 3 pixels, and then any one; and
/// the mistakes that all cameras may have.
pub fn cameras<P: Input + Send + Sync + 'static>(cameras: Cameras<P>) -> Exercise<NewCamera<P>> {
    let Cameras { words, first, any } = cameras;
    let positions = [[2.0, 1.0], [0.0, 1.0], [2.0, 0.0], [4.0, 2.0], [2.5, 0.5]];
    let rays = Questions {
        words: format!("{words}, picture of {{}} pixels, place {{}}"),
        simple: positions
            .map(|position| (first.clone(), [5, 3], position))
            .to_vec(),
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
        questions: vec![rays.into()],
        usual: vec![
            mistake("y of a camera counts upwards", |camera, size, x, y| {
                camera.ray_for(size, x, f64::from(size.height() - 1) - y)
            }),
            mistake(
                "whole numbers are middles of pixels",
                |camera, size, x, y| camera.ray_for(size, x - 0.5, y - 0.5),
            ),
            mistake("the gaze is along -w", |camera, size, x, y| {
                let ray = camera.ray_for(size, x, y);
                Ray::derived(ray.origin(), -ray.direction())
            }),
        ],
        ..Exercise::default()
    }
}

fn mistake<P: 'static>(about: &'static str, rays: Rays) -> Variant<NewCamera<P>> {
    Variant::from_right(about, move |right: NewCamera<P>| {
        new_camera(move |parameters| {
            let camera = right(parameters)?;
            Ok(Flawed { camera, rays })
        })
    })
}

/// A ray as an answer.
#[must_use]
pub fn ray_answer(ray: &Ray) -> Answer {
    Answer::named("origin", ray.origin().to_glam().to_array())
        .and("direction", ray.direction().to_glam().to_array())
}
