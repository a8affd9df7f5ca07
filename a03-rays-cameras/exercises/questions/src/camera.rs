//! Asks cameras, ray by ray.

use std::sync::Arc;

use a02_math::arrays::array;
use a03_rays_cameras::{Camera, Ray};
use common::Size;
use testing::exercises::{Answer, Exercise, Input, Made};

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

/// An exercise whose file asks cameras of some parameters for their rays: through places in pictures.
#[must_use]
pub fn cameras<P: Input + Default + 'static>() -> Exercise<NewCamera<P>> {
    Exercise::asked(
        |new: &NewCamera<P>, (parameters, [width, height], [x, y]): (P, [u32; 2], [_; 2])| {
            let size = Size::new(width, height).ok()?;
            Some(ray_answer(&new(parameters).ok()?.ray_for(size, x, y)))
        },
    )
}

/// A ray as an answer.
#[must_use]
pub fn ray_answer(ray: &Ray) -> Answer {
    Answer::named("origin", array(ray.origin())).and("direction", array(ray.direction()))
}
