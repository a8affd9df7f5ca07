//! The formulas as the course's protocol prints them.

use a04_lab::formula::sphere::Shot;
use a04_lab::line::Line;
use a04_lab::protocol::{Compared, axis_aligned_box, plane, sphere, triangle};
use a04_lab::support::{point, vector};
use corpus::{CASES, Found, Question, Shape};

use crate::{Adapter, nearest, within};

pub const ADAPTER: Adapter = Adapter {
    name: "protocol",
    title: "the course's protocol, as printed",
    cases: CASES,
    ask,
};

fn ask(question: &Question) -> Option<Found> {
    if !question.under.is_empty() {
        return None;
    }
    let ray = corpus_lesson::ray(question);
    let normal3 = |normal| vector(normal).as_normal();
    let found = match &question.shape {
        // Its normals have length 1.
        Shape::Plane { point: a, normal } => plane(point(*a), normal3(*normal).normalized()?, &ray),
        Shape::Sphere { center, radius } => sphere(&Shot {
            center: *center,
            radius: *radius,
            line: Line {
                origin: question.origin,
                direction: question.direction,
            },
        }),
        Shape::Box { low, high } => {
            axis_aligned_box(point(*low), point(*high), &ray, Compared::Three)
        }
        Shape::Disc {
            center,
            normal,
            radius,
        } => {
            let normal = normal3(*normal).normalized()?;
            a07_lab::protocol::disc(point(*center), normal, *radius, &ray)
        }
        Shape::Triangles(all) => nearest(
            all.iter()
                .map(|corners| triangle(&corners.map(point), &ray)),
        ),
        Shape::Tube { .. } => return None,
    };
    Some(within(question, found))
}
