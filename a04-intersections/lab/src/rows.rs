//! `rows`: the cases of the corpus that the laboratories of stages 4, 6 and 7 ask.
//!
//! `corpus/laboratory.toml` has their questions, exact answers and bounds; here they become rows of
//! the table of extreme cases.

use a02_math::Direction;
use corpus::{Answer, Asks, Bound, Outlook, Row, Shape};
use measure::extremes::{
    Bound as RowBound, Case, Condition, Fails, Flag, Holds, Known, Nothing, Number, Outcome,
    Refused, Triple,
};

use crate::line::{Line, line};
use crate::subject::{BOX, PLANE, SPHERE, Subject, TRIANGLE};
use crate::support::vector;

/// A shape, or several triangles, as a subject and the numbers of each.
pub type Described = (&'static Subject, Vec<Vec<f64>>);

/// The rows of some families, each computed by a function, which gives the outcomes alone.
///
/// If the file has a mistake, a single case that does not hold says so.
pub fn cases(families: &[&str], compute: impl Fn(&Row) -> Case) -> Vec<Case> {
    match corpus::rows(families) {
        Ok(rows) => rows.into_iter().map(|row| case(row, &compute)).collect(),
        Err(mistake) => vec![Case {
            id: "corpus",
            what: format!("laboratory.toml: {mistake}"),
            exact: Flag(true),
            ours: Flag(false),
            ..Case::default()
        }],
    }
}

/// The case of a row, with outcomes that are computed.
fn case(row: &'static Row, compute: impl Fn(&Row) -> Case) -> Case {
    let computed = compute(row);
    // The condition in the corpus is that of t.
    let of_corpus = match (row.expected.asks, &row.case.answer) {
        (Asks::Distance | Asks::AsGiven | Asks::T, Answer::Hit(_)) => Known(row.case.condition),
        _ => Condition::Unstated,
    };
    Case {
        id: &row.case.question.id,
        what: words(&row.case.question.says),
        exact: exact(row),
        bound: bound(row),
        protocol: match row.expected.protocol {
            Some(Outlook::Fails) => Fails,
            Some(Outlook::Holds) | None => Holds,
        },
        condition: computed.condition.or(of_corpus),
        ..computed
    }
}

/// A sentence as the words of a row: with a small letter, and without a full stop.
fn words(sentence: &str) -> String {
    let mut words = sentence.trim_end_matches('.').to_owned();
    if let Some(first) = words.get_mut(..1) {
        first.make_ascii_lowercase();
    }
    words
}

/// The exact outcome.
fn exact(row: &Row) -> Outcome {
    if row.expected.is_refused {
        return Refused;
    }
    let hit = match &row.case.answer {
        Answer::Hit(hit) => Some(hit),
        Answer::Miss | Answer::Coplanar => None,
        Answer::NoShape => return Refused,
    };
    match row.expected.asks {
        Asks::Distance | Asks::AsGiven => row.distance.as_ref().map(|exact| exact.value).into(),
        Asks::T => hit.map(|hit| hit.t).into(),
        Asks::Normal => match hit.and_then(|hit| hit.normal.as_ref()) {
            Some(digits) => Triple(digits.each_ref().map(|x| x.parse().unwrap_or(f64::NAN))),
            None => Nothing,
        },
        Asks::IsLit => Flag(hit.is_none()),
    }
}

fn bound(row: &Row) -> RowBound {
    match row.expected.bound {
        Bound::Equal => RowBound::Equal,
        Bound::Ulps(ulps) => RowBound::Ulps(ulps),
        Bound::Conditions(times) => RowBound::Ulps(times * row.case.condition),
        Bound::Roundings { length, cosine } => {
            RowBound::Absolute(4.0 * f64::EPSILON * length / cosine)
        }
    }
}

/// A shape of this stage; `None` for a disc or a tube.
pub fn described(shape: &Shape) -> Option<Described> {
    match shape {
        Shape::Plane { point, normal } => Some((&PLANE, vec![[*point, *normal].concat()])),
        Shape::Sphere { center, radius } => {
            Some((&SPHERE, vec![[&center[..], &[*radius]].concat()]))
        }
        Shape::Box { low, high } => Some((&BOX, vec![[*low, *high].concat()])),
        Shape::Triangles(all) => {
            let numbers = all.iter().map(|corners| corners.concat());
            Some((&TRIANGLE, numbers.collect()))
        }
        Shape::Disc { .. } | Shape::Tube { .. } => None,
    }
}

/// The ray of a row, with a direction of any length.
pub fn line_of(row: &Row) -> Line {
    line(row.case.question.origin, row.case.question.direction)
}

/// The distance of the nearest hit, by the lesson's formula and the protocol's.
pub fn met((subject, shapes): Described, row: &Row) -> Case {
    let line = line_of(row);
    let mut nearest: Option<Case> = None;
    for numbers in &shapes {
        let met = match row.expected.asks {
            Asks::AsGiven => met_as_given(subject, numbers, line),
            _ => subject.met(numbers, line),
        };
        nearest = Some(match nearest {
            Some(other) => Case::of(
                nearer(other.ours, met.ours),
                nearer(
                    other.theirs.unwrap_or_default(),
                    met.theirs.unwrap_or_default(),
                ),
            ),
            None => met,
        });
    }
    nearest.unwrap_or_default()
}

/// Where the protocol's formula gets a direction of another length, in units of which its `t` is.
fn met_as_given(subject: &Subject, numbers: &[f64], line: Line) -> Case {
    let Ok(ray) = line.unit_ray() else {
        return Case::of(Refused, (subject.protocol)(numbers, &line.raw_ray()));
    };
    let length = ray.direction().dot(vector(line.direction));
    let theirs = (subject.protocol)(numbers, &line.raw_ray());
    Case::of(subject.lesson(numbers, &ray), theirs.map(|t| t * length))
}

/// The lesser of two distances.
fn nearer(one: Outcome, other: Outcome) -> Outcome {
    match (one, other) {
        (Number(a), Number(b)) => Number(a.min(b)),
        (Number(_), _) => one,
        _ => other,
    }
}
