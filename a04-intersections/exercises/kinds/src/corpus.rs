//! Asks a student's shape the rays of the corpus that broke ray tracers.

use std::fmt::Write;

use a02_math::arrays::{point, vector};
use a03_rays_cameras::Ray;
use a04_intersections::Interval;
use common::Error;
use corpus::results::{Recorded, recorded};
use corpus::{Answer, CASES, Case, DOUBLE, Question, Shape, judge};
use testing::exercises::Made;

use crate::shape::Shape as Yours;

/// A remark: for how many rays of the corpus a shape is right, which some numbers describe, and the
/// first for which it is not. It is asked the rays that the lesson has been asked, to which it is compared.
///
/// # Errors
///
/// If the file of the corpus cannot be read.
pub fn corpus(name: &str, new: &dyn Fn(&[f64]) -> Made<Yours>) -> Result<String, Error> {
    let (mut asked, mut right) = (Vec::new(), 0);
    let mut first = None;
    let [lesson, _] = recorded();
    let is_known = |id: &str| {
        lesson
            .results
            .lines()
            .any(|line| line.split(' ').next() == Some(id))
    };
    for case in corpus::read(CASES).map_err(|error| Error::Usage(error.to_string()))? {
        if !is_known(&case.question.id) {
            continue;
        }
        let Some(shapes) = shapes(name, &case.question) else {
            continue;
        };
        let found = nearest(&case.question, &shapes, new);
        let verdict = judge(&case, found, DOUBLE);
        if !verdict.is_counted() {
            continue;
        }
        if verdict.is_right() {
            right += 1;
        } else if first.is_none() {
            first = Some(in_words(&case, found));
        }
        asked.push(case.question.id);
    }
    let mut words = format!(
        "The corpus of ray failures: your {name} is right for {right} of {} rays",
        asked.len()
    );
    for Recorded { name, results } in recorded() {
        let tally = corpus::results::tally_of(results, &asked)
            .map_err(|error| Error::Usage(error.to_string()))?;
        if tally.asked > 0 {
            // A `String` takes all.
            let _ = write!(words, ", {name} for {} of {}", tally.right, tally.asked);
        }
    }
    words.push('.');
    if let Some(first) = first {
        words += &first;
    }
    Ok(words)
}

/// The numbers of the shapes that a question asks for, if they are of this kind.
fn shapes(name: &str, question: &Question) -> Option<Vec<Vec<f64>>> {
    if !question.under.is_empty() {
        return None;
    }
    match (name, &question.shape) {
        ("plane", Shape::Plane { point, normal }) => Some(vec![[*point, *normal].concat()]),
        ("sphere", Shape::Sphere { center, radius }) => {
            Some(vec![[&center[..], &[*radius]].concat()])
        }
        ("box", Shape::Box { low, high }) => Some(vec![[*low, *high].concat()]),
        (
            "disc",
            Shape::Disc {
                center,
                normal,
                radius,
            },
        ) => Some(vec![[&center[..], normal, &[*radius]].concat()]),
        ("triangle", Shape::Triangles(all)) => {
            Some(all.iter().map(|corners| corners.concat()).collect())
        }
        _ => None,
    }
}

/// The `t` of the nearest hit of some shapes.
fn nearest(
    question: &Question,
    shapes: &[Vec<f64>],
    new: &dyn Fn(&[f64]) -> Made<Yours>,
) -> Option<f64> {
    let ray = Ray::derived(point(question.origin), vector(question.direction));
    let [min, max] = question.within;
    let mut nearest: Option<f64> = None;
    for numbers in shapes {
        let shape = new(numbers).ok();
        let hit = shape.and_then(|shape| shape.hit(&ray, Interval { min, max }));
        if let Some(hit) = hit
            && nearest.is_none_or(|t| hit.t < t)
        {
            nearest = Some(hit.t);
        }
    }
    nearest
}

/// A case that a shape does not answer rightly.
fn in_words(case: &Case, found: Option<f64>) -> String {
    let found = found.map_or("a miss".to_owned(), |t| format!("t = {t:?}"));
    let exact = match &case.answer {
        Answer::Hit(hit) => format!("t = {:?}", hit.t),
        Answer::Miss => "a miss".to_owned(),
        Answer::Coplanar => "in the plane".to_owned(),
    };
    let question = &case.question;
    let source = match question.source.as_str() {
        "ours" => String::new(),
        address => format!(" ({address})"),
    };
    format!(
        " The first that is not is {}: {} Yours: {found}; exact: {exact}.{source}",
        question.id, question.says
    )
}
