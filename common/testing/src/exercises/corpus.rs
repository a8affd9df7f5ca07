//! `ask_corpus`: how a student's shape answers the rays that broke ray tracers.

use corpus::{CASES, Case, Question, Shape, verdict};

use super::exercise::Exercise;
use super::findings::answer_of;

/// For how many rays of the corpus a shape is right, and the first for which it is not. The first form
/// of question of a shape's exercise takes the numbers of the shape, then those of the ray and its interval.
pub fn ask_corpus(name: &str, exercise: &Exercise<()>) -> String {
    let cases = match corpus::read(CASES) {
        Ok(cases) => cases,
        Err(error) => return error,
    };
    let (mut asked, mut right, mut first) = (0, 0, String::new());
    for case in cases {
        let shapes = shapes(name, &case.question);
        if shapes.is_empty() {
            continue;
        }
        let found = nearest(&case.question, &shapes, exercise);
        let verdict = verdict(&case, found);
        asked += usize::from(verdict.is_counted());
        if verdict.is_right() {
            right += usize::from(verdict.is_counted());
        } else if first.is_empty() {
            first = in_words(&case, found);
        }
    }
    format!("{name} is right for {right} of {asked} rays.{first}")
}

/// The numbers of the shapes that a question asks for, if they are those of an exercise.
fn shapes(exercise: &str, question: &Question) -> Vec<Vec<f64>> {
    if !question.under.is_empty() {
        return Vec::new();
    }
    match (exercise, &question.shape) {
        ("plane", Shape::Plane { point, normal }) => vec![[*point, *normal].concat()],
        ("axis_aligned_box", Shape::Box { low, high }) => vec![[*low, *high].concat()],
        ("sphere", Shape::Sphere { center, radius }) => vec![[&center[..], &[*radius]].concat()],
        ("triangle", Shape::Triangles(all)) => all.iter().map(|corners| corners.concat()).collect(),
        (
            "disc",
            Shape::Disc {
                center,
                normal,
                radius,
            },
        ) => vec![[&center[..], normal, &[*radius]].concat()],
        _ => Vec::new(),
    }
}

/// The `t` of the nearest hit of some shapes.
fn nearest(question: &Question, shapes: &[Vec<f64>], exercise: &Exercise<()>) -> Option<f64> {
    let form = exercise.forms.first()?;
    let mut nearest: Option<f64> = None;
    for shape in shapes {
        let ray = [&question.origin[..], &question.direction, &question.within].concat();
        let numbers = [&shape[..], &ray].concat();
        let answer = answer_of(&form.answer, &numbers)?;
        if let Some(t) = answer.number("t")
            && nearest.is_none_or(|nearest| t < nearest)
        {
            nearest = Some(t);
        }
    }
    nearest
}

/// A case that a shape does not answer rightly.
fn in_words(case: &Case, found: Option<f64>) -> String {
    let found = found.map_or("a miss".to_owned(), |t| format!("t = {t:?}"));
    let exact = match &case.answer {
        corpus::ExactAnswer::Hit(hit) => format!("t = {:?}", hit.t),
        corpus::ExactAnswer::Miss => "a miss".to_owned(),
        corpus::ExactAnswer::Coplanar => "in the plane".to_owned(),
    };
    let Question {
        id, says, source, ..
    } = &case.question;
    let source = match source.as_str() {
        "ours" => String::new(),
        address => format!(" ({address})"),
    };
    format!(" The first that is not is {id}: {says} Yours: {found}; exact: {exact}.{source}")
}

#[cfg(test)]
mod tests {
    use judge::answers::Answer;

    use super::*;
    use crate::exercises::Form;

    /// What is said of a plane by its formula for point, normal, origin, direction and interval.
    fn said(t_of: fn(&[f64]) -> Option<f64>) -> String {
        let answer = move |(): &(), numbers: [f64; 14]| {
            t_of(&numbers).map_or(Answer::words("no hit"), |t| Answer::named("t", t))
        };
        let exercise = Exercise {
            forms: vec![Form::new(answer)],
            ..Exercise::default()
        };
        ask_corpus("plane", &exercise.with_code(()))
    }

    #[test]
    fn a_shape_hears_of_the_first_ray_that_breaks_it() {
        let formula = said(|x| {
            let along_normal = |v: [f64; 3]| v[0] * x[3] + v[1] * x[4] + v[2] * x[5];
            let to_point = [x[0] - x[6], x[1] - x[7], x[2] - x[8]];
            let t = along_normal(to_point) / along_normal([x[9], x[10], x[11]]);
            (x[12] < t && t < x[13]).then_some(t)
        });
        let missed = said(|_| None);
        let right = |words: &str| -> u32 { words.split(' ').nth(4).unwrap().parse().unwrap() };
        assert!(right(&formula) > right(&missed), "{formula}");
        assert!(missed.contains(" Yours: a miss; exact: t = "), "{missed}");
    }
}
