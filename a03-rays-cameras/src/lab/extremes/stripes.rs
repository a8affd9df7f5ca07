//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::Point3;
use common::{ArgumentError, Size};
use measure::extremes::{Case, Equal, Fails, Id};

use crate::protocol::count_current_stripe;
use crate::{PinholeCamera, StripeRule, StripedSky};

/// Two counts, the protocol's and ours.
type Counts = Result<(usize, usize), ArgumentError>;

/// A row with two counts; the protocol's is wrong.
fn row(id: Id, what: &str, exact: usize, counts: Counts) -> Case {
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

/// The stripes of 10 at these columns of each row, the protocol's and ours.
fn rows(rule: StripeRule, columns: &[f64]) -> Result<Vec<Vec<(u32, u32)>>, ArgumentError> {
    let size = Size::SECOND_COURSE;
    let (camera, sky, top) = sky(size, FRAC_PI_2, 10, rule)?;
    let stripes = |x: f64, y: u32| {
        let ray = camera.generate_ray(size, x, f64::from(y) + 0.5);
        let counted = count_current_stripe(top, 10, ray.direction().y());
        (counted, sky.stripe(&ray))
    };
    let row = |y| columns.iter().map(|x| stripes(*x, y)).collect();
    Ok((0..size.height()).map(row).collect())
}

/// Number of runs of one stripe from the top of the picture to its bottom.
fn stripes_in_the_middle() -> Counts {
    let stripes = rows(StripeRule::Direction, &[240.0])?.concat();
    let (mut theirs, mut ours): (Vec<_>, Vec<_>) = stripes.into_iter().unzip();
    theirs.dedup();
    ours.dedup();
    Ok((theirs.len(), ours.len()))
}

fn rows_of_several_stripes() -> Counts {
    let columns = 0..Size::SECOND_COURSE.width();
    let columns: Vec<_> = columns.map(|x| f64::from(x) + 0.5).collect();
    let rows = rows(StripeRule::Wall, &columns)?;
    let count = |stripe: fn(&(u32, u32)) -> u32| {
        let sees_more = |row: &&Vec<_>| row.iter().any(|at| stripe(at) != stripe(&row[0]));
        rows.iter().filter(sees_more).count()
    };
    Ok((count(|at| at.0), count(|at| at.1)))
}
