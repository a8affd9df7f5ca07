//! Compares cameras, ray by ray.

use crate::prelude::*;

/// A camera whose rays a function of width, height and place finds.
pub struct Own<F>(pub F);

impl<F: Fn([f64; 2], [f64; 2]) -> Ray + Send + Sync + 'static> Camera for Own<F> {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        (self.0)([size.width(), size.height()].map(f64::from), [x, y])
    }
}

type Rays = fn(&dyn Camera, Size, f64, f64) -> Ray;

/// Mistakes that any camera may have.
const USUAL: [(&str, Rays); 3] = [
    ("y of a camera counts upwards", |camera, size, x, y| {
        camera.ray_for(size, x, f64::from(size.height() - 1) - y)
    }),
    (
        "whole numbers are middles of pixels",
        |camera, size, x, y| camera.ray_for(size, x - 0.5, y - 0.5),
    ),
    ("the gaze is along -w", |camera, size, x, y| {
        let ray = camera.ray_for(size, x, y);
        Ray::derived(ray.origin(), -ray.direction())
    }),
];

/// Compares cameras with the lesson's, whose words have `{}` in the place of each parameter:
/// the `first` one at simple places of a picture of 5 by 3 pixels, and then `any` one.
pub fn compare<P: Input, L: Camera, Y: Camera>(
    check: &mut Check,
    words: &str,
    first: P,
    any: fn(&mut Random) -> P,
    lesson: impl Fn(P) -> Made<L>,
    yours: impl Fn(P) -> Made<Y>,
) {
    type New<'a, P> = &'a dyn Fn(P) -> Made<Box<dyn Camera>>;
    let lesson: New<P> = &|parameters| Ok(Box::new(lesson(parameters)?));
    let yours: New<P> = &|parameters| Ok(Box::new(yours(parameters)?));
    let mistake = check.usual(&USUAL).unwrap_or(Camera::ray_for);
    let places = [[2.0, 1.0], [0.0, 1.0], [2.0, 0.0], [4.0, 2.0], [2.5, 0.5]];
    check.compare(
        &format!("{words}, picture of {{}} pixels, place {{}}"),
        places.map(move |place| (first.clone(), [5, 3], place)),
        random(|r| {
            let size = [(); 2].map(|()| 2 + r.below(99));
            let place = size.map(|n| r.between(-0.5, f64::from(n) - 0.5));
            (any(r), size, place)
        }),
        [(lesson, Camera::ray_for as Rays), (yours, mistake)],
        |(new, ray), (camera, [width, height], [x, y])| {
            let size = Size::new(width, height).ok()?;
            Some(answer(&ray(&*new(camera).ok()?, size, x, y)))
        },
    );
}

/// A ray as an answer.
pub fn answer(ray: &Ray) -> Answer {
    Answer::named("origin", ray.origin().to_glam().to_array())
        .and("direction", ray.direction().to_glam().to_array())
}
