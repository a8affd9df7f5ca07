//! Problems from harmless to extreme, computed on the page: exact, by the protocol, and by ours.

use std::fmt::Write;

use common::Error;
use measure::extremes::{AgainstProtocol, Outcome};
use measure::sweep::{Point, Sweep, ten_to};

use crate::{Answered, Reply};

const ALL: [Sweep; 7] = [
    a04_lab::sweeps::FAR_BALL,
    a04_lab::sweeps::TANGENT,
    a04_lab::sweeps::NEEDLE,
    a02_lab::sweeps::ANGLE,
    a07_lab::sweeps::STRETCHED,
    a05_lab::sweeps::SPOT,
    a04_lab::sweeps::DIRECTION,
];

/// The width and the height of each of both pictures.
const PANEL: u32 = 120;

/// The columns between them.
const GAP: u32 = 8;

/// All problems: below the names of the columns a line of words for each, and the ranges of their powers.
pub fn all() -> Reply {
    let mut text = "name\tparameter\tcomputes\tshows\tstage\texercise\tunit".to_owned();
    for sweep in &ALL {
        let exercise = sweep.exercise.as_ref().map_or("", |asked| asked.name);
        let Sweep {
            name,
            parameter,
            computes,
            shows,
            stage,
            ..
        } = sweep;
        let unit = sweep.unit.unwrap_or("ulp");
        let _ = write!(
            text,
            "\n{name}\t{parameter}\t{computes}\t{shows}\t{stage}\t{exercise}\t{unit}"
        );
    }
    Reply::text(text).with_rows(ALL.iter().map(|sweep| {
        let [first, last] = sweep.powers;
        [
            ("range.first", first),
            ("range.last", last),
            ("range.harmless", sweep.harmless),
            ("range.step", sweep.step.copysign(last - first)),
        ]
    }))
}

/// The problem of this name: its errors at all powers of ten, or, with a power, its digits and its pictures there.
pub fn sweep(name: &str, numbers: &[f64]) -> Answered {
    let sweep = find(name)?;
    Ok(match numbers {
        [power, ..] => point(sweep, *power),
        [] => curves(sweep),
    })
}

fn find(name: &str) -> Result<&'static Sweep, Error> {
    let found = ALL.iter().find(|sweep| sweep.name == name);
    found.ok_or_else(|| Error::Usage(format!("there is no problem \"{name}\"")))
}

fn curves(sweep: &Sweep) -> Reply {
    let points: Vec<_> = sweep.powers().map(|power| sweep.point(power)).collect();
    let list = |error: fn(&Point) -> f64| -> Vec<f64> {
        let errors = points
            .iter()
            .map(|point| error(point) * sweep.drawn_ulp(point));
        errors.collect()
    };
    Reply::default()
        .with("powers", sweep.powers())
        .with("allowed", list(Point::allowed))
        .with("ours", list(|point| point.error(point.found.ours)))
        .with("protocol", list(|point| point.error(point.found.theirs)))
        .with("breaks", sweep.breaks_at())
        .with("lost", [sweep.lost()])
}

/// The text has a line for each of the exact answer, the protocol's and ours.
fn point(sweep: &Sweep, power: f64) -> Reply {
    let point = sweep.point(power);
    let AgainstProtocol { ours, theirs } = point.found;
    let found = [theirs, ours].map(|found| Outcome::from(found).to_string());
    let right = [0, 1]
        .map(|n| right_digits(&found[n], point.error([theirs, ours][n]) * ulp_of(&point)) as f64);
    let [theirs_shown, ours_shown] = &found;
    let lines = format!("{}\n{theirs_shown}\n{ours_shown}", point.exact.digits());
    Reply {
        pixels: pictures(sweep, ten_to(power)),
        ..Reply::text(lines)
    }
    .with("right", right)
    .with(
        "errors",
        [theirs, ours].map(|found| point.error(found) * sweep.drawn_ulp(&point)),
    )
    .with("allowed", [point.allowed() * sweep.drawn_ulp(&point)])
    .with("value", [ten_to(power)])
    .with("size", [f64::from(2 * PANEL + GAP), f64::from(PANEL)])
}

fn ulp_of(point: &Point) -> f64 {
    measure::extremes::ulp(point.size)
}

/// How many of the letters of a number are right: up to the last digit of which half a unit is more than the error.
fn right_digits(number: &str, error: f64) -> usize {
    let (digits, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let before_dot = digits.find('.').unwrap_or(digits.len());
    let mut place = exponent.parse::<i32>().unwrap_or(0);
    place += digits[..before_dot]
        .bytes()
        .filter(u8::is_ascii_digit)
        .count() as i32;
    if !error.is_finite() {
        return 0;
    }
    for (index, letter) in digits
        .char_indices()
        .filter(|(_, letter)| letter.is_ascii_digit())
    {
        place -= 1;
        let _ = letter;
        if error > 0.5 * libm::pow(10.0, place.into()) {
            return index;
        }
    }
    number.len()
}

/// The picture of the protocol's formula, and beside it that of ours; light that comes through is white.
fn pictures(sweep: &Sweep, value: f64) -> Vec<u8> {
    let mut pixels = Vec::new();
    let middle = |index: u32| 2.0 * (f64::from(index) + 0.5) / f64::from(PANEL) - 1.0;
    for row in 0..PANEL {
        let places = (0..PANEL).map(|column| [middle(column), -middle(row)]);
        let row: Vec<_> = places.map(|place| (sweep.picture)(value, place)).collect();
        pixels.extend(row.iter().flat_map(|both| color(both.theirs)));
        pixels.extend((0..GAP).flat_map(|_| [0; 4]));
        pixels.extend(row.iter().flat_map(|both| color(both.ours)));
    }
    pixels
}

/// Blue of a brightness; white where there is nothing.
fn color(brightness: Option<f64>) -> [u8; 4] {
    let [red, green, blue] = match brightness {
        Some(bright) => [0.35, 0.6, 1.0].map(|channel| channel * bright),
        None => [1.0; 3],
    };
    let byte = |channel: f64| (channel * 255.0 + 0.5) as u8;
    [byte(red), byte(green), byte(blue), 255]
}

/// What the exercise of a problem is asked at each power: the numbers of all questions, one after the other, and how
/// many each has. The text names the part of the answer.
pub fn questions(name: &str) -> Answered {
    let sweep = find(name)?;
    let points: Vec<_> = sweep.powers().map(|power| sweep.point(power)).collect();
    let part = sweep.exercise.as_ref().map_or("", |exercise| exercise.part);
    Ok(Reply::text(part)
        .with(
            "count",
            points.first().map(|point| point.given.len() as f64),
        )
        .with("given", points.into_iter().flat_map(|point| point.given)))
}

/// The errors of answers to these questions; NaN is no answer.
pub fn errors(name: &str, answers: &[f64]) -> Answered {
    let sweep = find(name)?;
    let points = sweep.powers().map(|power| sweep.point(power));
    let errors = points
        .zip(answers)
        .map(|(point, answer)| point.error(Some(answer * point.factor)) * sweep.drawn_ulp(&point));
    Ok(Reply::default().with("yours", errors.collect::<Vec<_>>()))
}
