//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::Point3;
use common::{ArgumentError, Size};
use measure::extremes::{Bound, Case, Protocol};

use crate::{PinholeCamera, StripeRule, StripedSky, protocol};

pub fn cases() -> Vec<Case> {
    vec![
        horizon(),
        row(
            "Q06",
            "N straight stripes on N rows, N = 2..=200: rows of a wrong stripe",
            0,
            wrong_rows(),
        ),
        row(
            "Q14",
            "10 stripes, 480x270, full angle pi/2: stripes down the middle column",
            10,
            stripes_in_the_middle(),
        ),
        row(
            "Q15",
            "the same, straight stripes: rows that see more than one",
            0,
            rows_of_several_stripes(),
        ),
    ]
}

/// A row with two counts, the protocol's and ours; the protocol's is wrong.
fn row(
    id: &'static str,
    what: &str,
    exact: usize,
    counts: Result<(usize, usize), ArgumentError>,
) -> Case {
    let (theirs, ours) = counts.unwrap_or((exact, usize::MAX));
    Case::new(id, what, exact, Bound::Equal, ours).protocol(Protocol::Fails, theirs)
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
fn horizon() -> Case {
    let size = Size::SECOND_COURSE;
    let count = || -> Result<(usize, usize), ArgumentError> {
        let (mut theirs, mut ours) = (0, 0);
        for stripes in 2..=1000 {
            let (camera, sky, top) = sky(size, FRAC_PI_3, stripes, StripeRule::Direction)?;
            let level = camera.generate_ray(size, 240.0, 135.0);
            let height = level.direction().y();
            let counted = protocol::count_current_stripe(top, stripes, height);
            theirs += usize::from(counted != stripes / 2 + 1);
            ours += usize::from(sky.stripe(&level) != stripes / 2);
        }
        Ok((theirs, ours))
    };
    row(
        "Q05",
        "N stripes at full angle pi/3, N = 2..=1000: N with a wrong one at the horizon",
        0,
        count(),
    )
}

/// The protocol counts both halves of the picture from their edges.
fn wrong_rows() -> Result<(usize, usize), ArgumentError> {
    let (mut theirs, mut ours) = (0, 0);
    for stripes in 2..=200 {
        let size = Size::new(1, stripes)?;
        let (camera, sky, _) = sky(size, FRAC_PI_2, stripes, StripeRule::Wall)?;
        for row in 0..stripes {
            let ray = camera.generate_ray(size, 0.5, f64::from(row) + 0.5);
            let height = ray.direction().y() / ray.direction().z().abs();
            let counted = protocol::count_current_stripe(1.0, stripes, height);
            theirs += usize::from(counted != row + 1);
            ours += usize::from(sky.stripe(&ray) != stripes - 1 - row);
        }
    }
    Ok((theirs, ours))
}

/// Number of runs of one stripe from the top of the picture to its bottom.
fn stripes_in_the_middle() -> Result<(usize, usize), ArgumentError> {
    let size = Size::SECOND_COURSE;
    let (camera, sky, top) = sky(size, FRAC_PI_2, 10, StripeRule::Direction)?;
    let (mut theirs, mut ours) = (Vec::new(), Vec::new());
    for row in 0..size.height() {
        let ray = camera.generate_ray(size, 240.0, f64::from(row) + 0.5);
        theirs.push(protocol::count_current_stripe(top, 10, ray.direction().y()));
        ours.push(sky.stripe(&ray));
    }
    theirs.dedup();
    ours.dedup();
    Ok((theirs.len(), ours.len()))
}

fn rows_of_several_stripes() -> Result<(usize, usize), ArgumentError> {
    let size = Size::SECOND_COURSE;
    let (camera, sky, top) = sky(size, FRAC_PI_2, 10, StripeRule::Wall)?;
    let (mut theirs, mut ours) = (0, 0);
    for row in 0..size.height() {
        let across = (0..size.width()).map(|column| {
            let (x, y) = (f64::from(column) + 0.5, f64::from(row) + 0.5);
            let ray = camera.generate_ray(size, x, y);
            let height = ray.direction().y();
            (
                protocol::count_current_stripe(top, 10, height),
                sky.stripe(&ray),
            )
        });
        let (first, second): (Vec<_>, Vec<_>) = across.unzip();
        theirs += usize::from(first.iter().any(|stripe| *stripe != first[0]));
        ours += usize::from(second.iter().any(|stripe| *stripe != second[0]));
    }
    Ok((theirs, ours))
}
