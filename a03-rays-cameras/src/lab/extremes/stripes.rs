//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::Point3;
use common::{ArgumentError, Size};
use measure::extremes::{Case, Equal, Fails};

use crate::protocol::count_current_stripe;
use crate::{PinholeCamera, StripeRule, StripedSky};

/// Two counts, the protocol's and ours.
type Counts = Result<(usize, usize), ArgumentError>;

/// A row with two counts; the protocol's is wrong.
fn row(id: &'static str, what: &str, exact: usize, counts: Counts) -> Case {
    let (theirs, ours) = counts.unwrap_or((exact, usize::MAX));
    Case::new(id, what, exact, Equal, ours).protocol(Fails, theirs)
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    vec![
        row("Q05", "N stripes at full angle pi/3, N = 2..=1000: N with a wrong one at the horizon",
            0, horizon()),
        row("Q06", "N straight stripes on N rows, N = 2..=200: rows of a wrong stripe", 0, wrong_rows()),
        row("Q14", "10 stripes, 480x270, full angle pi/2: stripes down the middle column",
            10, stripes_in_the_middle()),
        row("Q15", "the same, straight stripes: rows that see more than one", 0, rows_of_several_stripes()),
    ]
}

fn sky(
    size: Size,
    alpha: f64,
    stripes: u32,
    rule: StripeRule,
) -> Result<(PinholeCamera, StripedSky, f64), ArgumentError> {
    let camera = PinholeCamera::new(Point3::ORIGIN, alpha)?;
    let sky = StripedSky::new(&camera, size, stripes, rule)?;
    let edge = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
    Ok((camera, sky, edge.direction().y()))
}

/// The stripe that begins at the horizon: of N stripes, the protocol counts the
/// N / 2 above the horizon and the stripe at the horizon itself.
fn horizon() -> Counts {
    let (mut theirs, mut ours) = (0, 0);
    for stripes in 2..=1000 {
        let size = Size::SECOND_COURSE;
        let (camera, sky, top) = sky(size, FRAC_PI_3, stripes, StripeRule::Direction)?;
        let level = camera.generate_ray(size, 240.0, 135.0);
        let counted = count_current_stripe(top, stripes, level.direction().y());
        theirs += usize::from(counted != stripes / 2 + 1);
        ours += usize::from(sky.stripe(&level) != stripes / 2);
    }
    Ok((theirs, ours))
}

/// The protocol counts both halves of the picture from their edges.
fn wrong_rows() -> Counts {
    let (mut theirs, mut ours) = (0, 0);
    for stripes in 2..=200 {
        let size = Size::new(1, stripes)?;
        let (camera, sky, _) = sky(size, FRAC_PI_2, stripes, StripeRule::Wall)?;
        for row in 0..stripes {
            let ray = camera.generate_ray(size, 0.5, f64::from(row) + 0.5);
            let height = ray.direction().y() / ray.direction().z().abs();
            let counted = count_current_stripe(1.0, stripes, height);
            theirs += usize::from(counted != row + 1);
            ours += usize::from(sky.stripe(&ray) != stripes - 1 - row);
        }
    }
    Ok((theirs, ours))
}

/// The stripes of 10 at some places of a row, the protocol's and ours.
fn stripes_of_row(
    row: u32,
    rule: StripeRule,
    columns: &[f64],
) -> Result<[Vec<u32>; 2], ArgumentError> {
    let size = Size::SECOND_COURSE;
    let (camera, sky, top) = sky(size, FRAC_PI_2, 10, rule)?;
    let rays = columns
        .iter()
        .map(|x| camera.generate_ray(size, *x, f64::from(row) + 0.5));
    let counted = rays
        .clone()
        .map(|ray| count_current_stripe(top, 10, ray.direction().y()));
    Ok([
        counted.collect(),
        rays.map(|ray| sky.stripe(&ray)).collect(),
    ])
}

/// Number of runs of one stripe from the top of the picture to its bottom.
fn stripes_in_the_middle() -> Counts {
    let (mut theirs, mut ours) = (Vec::new(), Vec::new());
    for row in 0..Size::SECOND_COURSE.height() {
        let [counted, stripes] = stripes_of_row(row, StripeRule::Direction, &[240.0])?;
        theirs.extend(counted);
        ours.extend(stripes);
    }
    theirs.dedup();
    ours.dedup();
    Ok((theirs.len(), ours.len()))
}

fn rows_of_several_stripes() -> Counts {
    let columns: Vec<_> = (0..Size::SECOND_COURSE.width())
        .map(|x| f64::from(x) + 0.5)
        .collect();
    let (mut theirs, mut ours) = (0, 0);
    for row in 0..Size::SECOND_COURSE.height() {
        let stripes = stripes_of_row(row, StripeRule::Wall, &columns)?;
        let [several, too] =
            stripes.map(|row| usize::from(row.iter().any(|stripe| *stripe != row[0])));
        theirs += several;
        ours += too;
    }
    Ok((theirs, ours))
}
