//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::Point3;
use common::{ArgumentError, Size};
use measure::extremes::{Case, Equal, Fails};

use crate::lab::protocol::count_current_stripe;
use crate::{PinholeCamera, Ray, StripeRule, StripedSky};

/// Two counts, ours and the protocol's.
type Counts = Result<[usize; 2], ArgumentError>;

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let [ours, theirs] = stripes_in_the_middle().unwrap_or_default();
    vec![
        Case::wrong("Q05", "N stripes at full angle pi/3, N = 2..=1000: N with a wrong one at the horizon",
            horizon()),
        Case::wrong("Q06", "N straight stripes on N rows, N = 2..=200: rows of a wrong stripe", wrong_rows()),
        Case::new("Q14", "10 stripes, 480x270, full angle pi/2: stripes down the middle column",
            10.0, Equal, ours).protocol(Fails, theirs),
        Case::wrong("Q15", "the same, straight stripes: rows that see more than one", rows_of_several_stripes()),
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
    let mut wrong = [0; 2];
    for stripes in 2..=1000 {
        let size = Size::SECOND_COURSE;
        let (camera, sky, top) = sky(size, FRAC_PI_3, stripes, StripeRule::Direction)?;
        let level = camera.generate_ray(size, 240.0, 135.0);
        let counted = count_current_stripe(top, stripes, level.direction().y());
        wrong[0] += usize::from(sky.stripe(&level) != stripes / 2);
        wrong[1] += usize::from(counted != stripes / 2 + 1);
    }
    Ok(wrong)
}

/// The protocol counts both halves of the picture from their edges.
fn wrong_rows() -> Counts {
    let mut wrong = [0; 2];
    for stripes in 2..=200 {
        let size = Size::new(1, stripes)?;
        let (camera, sky, _) = sky(size, FRAC_PI_2, stripes, StripeRule::Wall)?;
        for row in 0..stripes {
            let ray = camera.generate_ray(size, 0.5, f64::from(row) + 0.5);
            let height = ray.direction().y() / ray.direction().z().abs();
            let counted = count_current_stripe(1.0, stripes, height);
            wrong[0] += usize::from(sky.stripe(&ray) != stripes - 1 - row);
            wrong[1] += usize::from(counted != row + 1);
        }
    }
    Ok(wrong)
}

/// The stripes of 10 at these columns of each row, ours and the protocol's.
fn rows(rule: StripeRule, columns: &[f64]) -> Result<[Vec<Vec<u32>>; 2], ArgumentError> {
    let size = Size::SECOND_COURSE;
    let (camera, sky, top) = sky(size, FRAC_PI_2, 10, rule)?;
    let count = |ray: &Ray| count_current_stripe(top, 10, ray.direction().y());
    let stripes: [&dyn Fn(&Ray) -> u32; 2] = [&|ray| sky.stripe(ray), &count];
    Ok(stripes.map(|stripe| {
        let at = |x: f64, y: u32| stripe(&camera.generate_ray(size, x, f64::from(y) + 0.5));
        let row = |y| columns.iter().map(|x| at(*x, y)).collect();
        (0..size.height()).map(row).collect()
    }))
}

/// Number of runs of one stripe from the top of the picture to its bottom.
fn stripes_in_the_middle() -> Counts {
    Ok(rows(StripeRule::Direction, &[240.0])?.map(|rows| {
        let mut stripes = rows.concat();
        stripes.dedup();
        stripes.len()
    }))
}

fn rows_of_several_stripes() -> Counts {
    let columns = 0..Size::SECOND_COURSE.width();
    let columns: Vec<_> = columns.map(|x| f64::from(x) + 0.5).collect();
    let sees_more = |row: &&Vec<u32>| row.iter().any(|stripe| *stripe != row[0]);
    let rows = rows(StripeRule::Wall, &columns)?;
    Ok(rows.map(|rows| rows.iter().filter(sees_more).count()))
}
