//! Rays that leave shapes of all sizes, near the origin and far away, steep and grazing, to
//! both sides, compared with the solution.

use crate::departure::{Departure, Numbers, SHAPES};
use crate::prelude::*;

yours! { secondary_ray }

type Code = fn(&Ray, &Hit, Vector3) -> Ray;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let (up, down) = ([0.8, 0.6, 0.0], [0.8, -0.6, 0.0]);
    let mut simple = Vec::new();
    for (direction, size) in [(up, 1.0), (down, 1.0), (up, 1e-9)] {
        for shape in SHAPES {
            simple.push(Departure {
                shape,
                normal: [0.0, 1.0, 0.0],
                size,
                point: [0.0; 3],
                to_eye: [0.0, 2.0, 1.0],
                direction,
            });
        }
    }
    let mut others = random(Departure::any);
    others.extend(random(Departure::grazing));
    let departures = Questions {
        words: "{} with normal {}, of size {}, at {} sizes, the eye {} sizes away, left along {}",
        simple,
        others,
        answer: |secondary_ray: &Code, departure: Departure| departure.answer(secondary_ray),
    };
    Exercise {
        questions: departures.into(),
        picture: Picture::own(two_sizes),
        wrong: vec![
            Other::new("no length is fixed", |ray, hit, direction| {
                offset(ray, hit, direction, hit.geometric_normal.into(), 1e-9)
            }),
            Other::new(
                "the errors of the coordinates count, too",
                |ray, hit, direction| {
                    let length = 1e-12 * hit.t;
                    offset(ray, hit, direction, hit.geometric_normal.into(), length)
                },
            ),
            Other::new("the error of t counts, too", |ray, hit, direction| {
                let length = 1e-12 * Numbers::of(ray, hit).point;
                offset(ray, hit, direction, hit.geometric_normal.into(), length)
            }),
            Other::new(
                "a grazing ray does not leave along itself",
                |ray, hit, direction| offset(ray, hit, direction, direction, largest(ray, hit)),
            ),
            Other::new(
                "along itself, a grazing ray would have to go far",
                |ray, hit, direction| {
                    let length = 1e-12 * Numbers::of(ray, hit).sum();
                    offset(ray, hit, direction, direction, length)
                },
            ),
            Other::new(
                "the face says where the surface is",
                |ray, hit, direction| {
                    offset(ray, hit, direction, hit.normal.into(), largest(ray, hit))
                },
            ),
        ],
        ..Exercise::default()
    }
}

/// The ray that is offset along this vector by this length.
fn offset(ray: &Ray, hit: &Hit, direction: Vector3, along: Vector3, length: f64) -> Ray {
    let length = length.copysign(along.dot(direction));
    Ray::derived(ray.at(hit.t) + along * length, direction)
}

fn largest(ray: &Ray, hit: &Hit) -> f64 {
    let at = Numbers::of(ray, hit);
    1e-14 * at.origin.max(at.point).max(at.t)
}

/// The same ball on the same floor in grazing light twice: on the left larger than the solar system,
/// on the right smaller than a cell. Both have a shadow, and no specks.
fn two_sizes(secondary_ray: &Code, settings: &Settings) -> Result<Image, Error> {
    let mut image = Image::black(settings.size)?;
    let width = settings.size.width() / 2;
    let half = Settings {
        size: Size::new(width - 2, settings.size.height())?,
        ..settings.clone()
    };
    for (left, size) in [(0, 1e14), (width + 2, 1e-6)] {
        image.paste(left, 0, &in_grazing_light(secondary_ray, size, &half)?);
    }
    Ok(image)
}

/// A ball of this radius on a floor.
fn in_grazing_light(secondary_ray: &Code, size: f64, settings: &Settings) -> Result<Image, Error> {
    let at = |p: [f64; 3]| point(p.map(|x| x * size));
    let world = World::new(Color::new(0.2, 0.25, 0.35))?
        .with(
            Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?,
            Color::gray(0.8),
        )
        .with(
            Sphere::new(at([0.0, 1.0, 0.0]), size)?,
            Color::new(0.9, 0.3, 0.1),
        );
    let (eye, lamp) = (at([0.7, 3.0, 6.5]), at([4.0, 2.5, 2.5]));
    let (gaze, up) = (at([0.0, 0.6, 0.0]) - eye, Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, gaze, up, 0.75)?;
    let seen = |ray: &Ray| {
        let Some((hit, color)) = world.hit(ray, Interval::AHEAD) else {
            return world.background();
        };
        let to_lamp = lamp - ray.at(hit.t);
        let direction = to_lamp.normalized().unwrap_or_default();
        let to_light = secondary_ray(ray, &hit, direction);
        let is_dark = world.is_hit(&to_light, Interval::before(to_lamp.magnitude()));
        let cosine = hit.normal.dot(direction).max(0.0);
        *color * (0.15 + if is_dark { 0.0 } else { 0.85 * cosine })
    };
    paint(&camera, &seen, settings)
}
