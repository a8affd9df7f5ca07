//! Lamps, compared with the solution.

use crate::prelude::*;

yours! { point_light => light_at(|(c, lamp), p| point_light(c, point(lamp), p)) }

type Code = LightAt<(Color, [f64; 3])>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::own(three_lamps),
        wrong: vec![Other::from_right(
            "this lamp is as bright at every distance",
            |right| {
                light_at(move |parameters, p| {
                    let light = right(parameters, p)?;
                    let square = light.distance * light.distance;
                    Some(Illumination {
                        color: light.color * (1.0 / square),
                        ..light
                    })
                })
            },
        )],
        ..lights([Lights {
            words: "light {} at {}",
            first: (Color::new(1.0, 0.5, 0.25), LAMP),
            simple: vec![],
            others: vec![],
            any: |r| (r.color(), r.triple(5.0)),
        }])
    }
}

/// A white floor and a white ball in the light of a red, a green and a blue lamp. Around each lamp,
/// rings are at whole distances.
fn three_lamps(light: &Code, settings: &Settings) -> Result<Image, Error> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let ball = Sphere::new(Point3::new(0.0, 0.7, 0.0), 0.7)?;
    let world = World::new(Color::BLACK)?
        .with(floor, Color::WHITE)
        .with(ball, Color::WHITE);
    let eye = Point3::new(0.0, 4.5, 6.0);
    let (gaze, up) = (Point3::ORIGIN - eye, Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(eye, gaze, up, 0.75)?;
    let lamps = [
        (Color::new(0.8, 0.1, 0.1), [-1.7, 1.2, 1.0]),
        (Color::new(0.1, 0.7, 0.1), [1.7, 1.2, 1.0]),
        (Color::new(0.1, 0.2, 0.9), [0.0, 1.5, -2.0]),
    ];
    let seen = |ray: &Ray| {
        let mut sum = world.background();
        let Some((hit, _)) = world.hit(ray, Interval::AHEAD) else {
            return sum;
        };
        for lamp in lamps {
            if let Some(arriving) = light(lamp, ray.at(hit.t)) {
                let cosine = hit.normal.dot(arriving.direction).max(0.0);
                let is_ring = arriving.distance.fract() < 0.04;
                sum += arriving.color * cosine * if is_ring { 0.6 } else { 1.0 };
            }
        }
        sum
    };
    paint(&camera, &seen, settings)
}
