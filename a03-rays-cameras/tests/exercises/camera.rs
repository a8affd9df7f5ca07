//! Compares cameras, ray by ray.

use a03_rays_cameras::{Camera, Ray};
use common::{ArgumentError, Size};
use testing::exercise::{Answer, Check, Input, Random, random};

/// Compares cameras with the lesson's, whose words have `{}` in the place of each parameter:
/// the `first` one at simple places of a picture of 5 by 3 pixels, and then `any` one.
pub fn compare<P: Input, L: Camera, Y: Camera>(
    check: &mut Check,
    words: &str,
    first: P,
    mut any: impl FnMut(&mut Random) -> P,
    lesson: impl Fn(P) -> Result<L, ArgumentError>,
    yours: impl Fn(P) -> Result<Y, ArgumentError>,
) {
    let places = [[2.0, 1.0], [0.0, 1.0], [2.0, 0.0], [4.0, 2.0], [2.5, 0.5]];
    check.compare(
        &format!("{words}, picture of {{}} pixels, place {{}}"),
        places.map(|place| (first.clone(), [5, 3], place)),
        random(|r| {
            let size = [(); 2].map(|()| 2 + r.below(99));
            let place = size.map(|n| r.between(-0.5, f64::from(n) - 0.5));
            (any(r), size, place)
        }),
        |(camera, size, place)| ray(lesson(camera), size, place),
        |(camera, size, place)| ray(yours(camera), size, place),
    );
}

fn ray(
    camera: Result<impl Camera, ArgumentError>,
    [width, height]: [u32; 2],
    [x, y]: [f64; 2],
) -> Option<Answer> {
    let size = Size::new(width, height).ok()?;
    Some(answer(&camera.ok()?.ray_for(size, x, y)))
}

/// A ray as an answer.
pub fn answer(ray: &Ray) -> Answer {
    Answer::named("origin", ray.origin().to_glam().to_array())
        .and("direction", ray.direction().to_glam().to_array())
}
