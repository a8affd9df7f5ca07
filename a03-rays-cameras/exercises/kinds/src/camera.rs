//! Asks cameras, ray by ray.

use std::sync::Arc;

use a02_math::arrays::array;
use a03_rays_cameras::{Basis, Camera, Ray};
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
    /// Further parameters of round numbers, such as directions that are very short or long.
    pub further: Vec<P>,
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

/// Asks the first camera at simple positions of a picture of 5 by 3 pixels, of pictures with even
/// sides, and of pictures that have a single row or column; the further ones; and then any one; and the mistakes that all
/// cameras may have.
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
        usual: vec![
            mistake("y of a camera counts upwards", |camera, size, x, y| {
                camera.ray_for(size, x, f64::from(size.height() - 1) - y)
            }),
            mistake(
                "whole numbers are middles of pixels",
                |camera, size, x, y| camera.ray_for(size, x - 0.5, y - 0.5),
            ),
            mistake(
                "(0, 0) is the middle of a pixel, not its corner",
                |camera, size, x, y| camera.ray_for(size, x + 0.5, y + 0.5),
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

/// The axes of a camera and its vertical field of view.
pub type WithAngle<P> = fn(P) -> Made<(Basis, f64)>;

/// Width and height of a pixel at the distance 1 before a camera: by the angle, and by width and
/// height of the picture in pixels.
pub type PixelSize = fn(f64, [f64; 2]) -> [f64; 2];

/// Mistakes of cameras with a field of view, by the axes and the angle of their parameters.
#[must_use]
pub fn mistakes_with_angle<P: 'static>(parts: WithAngle<P>) -> Vec<Variant<NewCamera<P>>> {
    let mistakes: [(&str, PixelSize); 4] = [
        (
            "the angle is vertical: it belongs to the height of the picture",
            |angle, [width, _]| [2.0 * libm::tan(angle / 2.0) / width; 2],
        ),
        (
            "a pixel is as wide as it is high",
            |angle, [width, height]| [width, height].map(|n| 2.0 * libm::tan(angle / 2.0) / n),
        ),
        (
            "half of the angle is above the middle",
            |angle, [_, height]| [2.0 * libm::tan(angle) / height; 2],
        ),
        (
            "the angle is in radians, not in degrees",
            |angle, [_, height]| [2.0 * libm::tan(angle.to_radians() / 2.0) / height; 2],
        ),
    ];
    let variants = mistakes.map(|(about, size)| Variant::new(about, with_pixels(parts, size)));
    let mut variants = Vec::from(variants);
    variants.push(Variant::new(
        "half of the angle is above the middle",
        with_tangent_of_angle(parts),
    ));
    variants
}

/// A camera with the tangent of the whole angle in the formula of the book. Beyond a right angle
/// the tangent is negative, and the rays go backwards.
fn with_tangent_of_angle<P: 'static>(parts: WithAngle<P>) -> NewCamera<P> {
    new_camera(move |parameters| {
        let (Basis { e, u, v, w }, angle) = parts(parameters)?;
        Ok(OwnCamera(
            move |[width, height]: [f64; 2], [x, y]: [f64; 2]| {
                let right = x - (width - 1.0) / 2.0;
                let up = y - (height - 1.0) / 2.0;
                let distance = height / 2.0 / libm::tan(angle);
                let direction = (u * right + v * up - w * distance).normalized();
                Ray::derived(e, direction.unwrap_or_default())
            },
        ))
    })
}

/// A camera with pixels of this size.
pub fn with_pixels<P: 'static>(parts: WithAngle<P>, pixel_size: PixelSize) -> NewCamera<P> {
    new_camera(move |parameters| {
        let (Basis { e, u, v, w }, angle) = parts(parameters)?;
        Ok(OwnCamera(move |size: [f64; 2], [x, y]: [f64; 2]| {
            let [pixel_width, pixel_height] = pixel_size(angle, size);
            let right = pixel_width * (x - (size[0] - 1.0) / 2.0);
            let up = pixel_height * (y - (size[1] - 1.0) / 2.0);
            let direction = (u * right + v * up - w).normalized();
            Ray::derived(e, direction.unwrap_or_default())
        }))
    })
}

/// A ray as an answer.
#[must_use]
pub fn ray_answer(ray: &Ray) -> Answer {
    Answer::named("origin", array(ray.origin())).and("direction", array(ray.direction()))
}
