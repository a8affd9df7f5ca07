//! Products of vectors, compared with the solution.

use a01_image_display::Canvas;
use glam::DVec3;

use crate::prelude::*;

yours! { dot, cross => crate::products::Code { dot, cross } }

#[derive(Clone, Copy)]
pub struct Code {
    pub dot: fn(Vector3, Vector3) -> f64,
    pub cross: fn(Vector3, Vector3) -> Vector3,
}

type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let vectors = Questions {
        words: "a = {}, b = {}",
        simple: vec![
            (x, y),
            (y, x),
            ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]),
            ([1.0, 2.0, 3.0], [-4.0, 0.0, 6.0]),
        ],
        others: random(|r| (r.triple(9.0), r.triple(9.0))),
        answer: |code: &Code, (a, b)| {
            let (a, b) = (vector(a), vector(b));
            Answer::named("a · b", (code.dot)(a, b)).and("a × b", array((code.cross)(a, b)))
        },
    };
    Exercise {
        questions: vectors.into(),
        picture: Picture::own(balls),
        wrong: vec![
            Other::from_right("a vector has three coordinates", |right| Code {
                dot: |a, b| a.x() * b.x() + a.y() * b.y(),
                ..right
            }),
            Other::from_right("a × b is not b × a", |right| Code {
                cross: |a, b| b.cross(a),
                ..right
            }),
            Other::from_right("each coordinate is made of the two others", |right| Code {
                cross: |a, b| Vector3::from_glam(a.to_glam() * b.to_glam()),
                ..right
            }),
        ],
        ..Exercise::default()
    }
}

/// Radius of the balls in pixels.
const RADIUS: f64 = 70.0;

/// A ball whose brightness is the dot product of normal and light, and one that rotates: its
/// points move along the cross product of the axis and their position, and so along the circles.
fn balls(code: &Code, settings: &Settings) -> Result<Image, Error> {
    let paper = Color::WHITE;
    let mut canvas = Canvas::new(settings.size, paper)?;
    rotating_ball(code, &mut canvas);
    let ink = Color::gray(0.15);
    canvas.text((20.0, 16.0), 2, ink, "a \u{b7} b");
    canvas.text((180.0, 16.0), 2, ink, "a \u{d7} b");
    let mut image = canvas.into_image();
    let light = Vector3::new(-0.36, 0.48, 0.8);
    for y in 0..settings.size.height() {
        for x in 0..settings.size.width() / 2 {
            let [right, up] = [f64::from(x) - 80.0, 130.0 - f64::from(y)].map(|n| n / RADIUS);
            let squared = 1.0 - right * right - up * up;
            if squared >= 0.0 {
                let normal = Vector3::new(right, up, squared.sqrt());
                let brightness = (code.dot)(normal, light).clamp(0.0, 1.0);
                image.set(x, y, Color::new(1.0, 0.6, 0.2) * (0.08 + 0.92 * brightness));
            }
        }
    }
    Ok(image)
}

fn rotating_ball(code: &Code, canvas: &mut Canvas) {
    let axis = DVec3::new(0.36, 0.8, 0.48);
    let side = axis.any_orthonormal_vector();
    let other_side = axis.cross(side);
    let place = |p: DVec3| (240.0 + p.x * RADIUS, 130.0 - p.y * RADIUS);
    canvas.line(
        place(axis * -1.3),
        place(axis * -1.0),
        2.0,
        Color::gray(0.5),
    );
    for height in [-0.75, -0.45, -0.1, 0.25, 0.6, 0.9_f64] {
        let radius = (1.0 - height * height).sqrt();
        let steps = (24.0 * radius).ceil();
        let on_circle = |step: f64| {
            let (sine, cosine) = libm::sincos(step / steps * std::f64::consts::TAU);
            axis * height + (side * cosine + other_side * sine) * radius
        };
        for step in 0..8 * steps as u32 {
            let [from, to] = [0.0, 1.0].map(|more| on_circle((f64::from(step) + more) / 8.0));
            if from.z > 0.0 && to.z > 0.0 {
                canvas.line(place(from), place(to), 1.0, Color::gray(0.75));
            }
        }
        for step in 0..steps as u32 {
            let from = on_circle(f64::from(step));
            if from.z > 0.05 {
                let along = (code.cross)(Vector3::from_glam(axis), Vector3::from_glam(from));
                let to = from + along.to_glam() * 0.22;
                canvas.arrow(place(from), place(to), 1.5, Color::new(0.1, 0.3, 0.8));
            }
        }
    }
    canvas.arrow(
        place(axis),
        place(axis * 1.35),
        2.5,
        Color::new(0.8, 0.1, 0.1),
    );
}
