//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{Case, Equal, Fails, case, wrong};

use crate::protocol::count_current_stripe;
use a03_rays_cameras::StripeRule::{self, Direction, Wall};
use a03_rays_cameras::{PinholeCamera, StripedSky};

/// Two counts, ours and the protocol's.
type Counts = Result<[usize; 2], ArgumentError>;

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let [ours, theirs] = stripes_in_the_middle().unwrap_or_default();
    vec![
        Case::wrong("Q05", "N stripes at full angle pi/3, N = 2..=1000: N with a wrong one at the horizon",
            horizon()),
        Case::wrong("Q06", "N straight stripes on N rows, N = 2..=200: rows of a wrong stripe", wrong_rows()),
        case("Q14", "10 stripes, 480x270, full angle pi/2: stripes down the middle column",
            [ours.into(), theirs.into()], 10.0, Equal, Fails),
        Case::wrong("Q15", "the same, straight stripes: rows that see more than one", rows_of_several_stripes()),
    ]
}

/// The stripe at a place of a picture of this full angle: ours, and the one that the protocol
/// counts by this height.
fn stripe_at(
    (size, alpha): (Size, f64),
    (stripes, rule): (u32, StripeRule),
    height: fn(Vector3) -> f64,
) -> Result<impl Fn(f64, f64) -> [u32; 2], ArgumentError> {
    let camera = PinholeCamera::new(Point3::ORIGIN, alpha)?;
    let sky = StripedSky::new(&camera, size, stripes, rule)?;
    let top = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
    let top = height(top.direction());
    Ok(move |x, y| {
        let ray = camera.generate_ray(size, x, y);
        let theirs = count_current_stripe(top, stripes, height(ray.direction()));
        [sky.stripe(&ray), theirs]
    })
}

/// The stripe that begins at the horizon: of N stripes, the protocol counts the
/// N / 2 above the horizon and the stripe at the horizon itself.
fn horizon() -> Counts {
    wrong(2..=1000, |n| {
        let picture = (Size::SECOND_COURSE, FRAC_PI_3);
        let [ours, theirs] = stripe_at(picture, (n, Direction), Vector3::y)?(240.0, 135.0);
        Ok([ours != n / 2, theirs != n / 2 + 1])
    })
}

/// The protocol counts both halves of the picture from their edges.
fn wrong_rows() -> Counts {
    let rows = (2..=200).flat_map(|stripes| (0..stripes).map(move |row| (stripes, row)));
    wrong(rows, |(n, row)| {
        let picture = (Size::new(1, n)?, FRAC_PI_2);
        let stripe = stripe_at(picture, (n, Wall), |d| d.y() / d.z().abs())?;
        let [ours, theirs] = stripe(0.5, f64::from(row) + 0.5);
        Ok([ours != n - 1 - row, theirs != row + 1])
    })
}

const WIDE: (Size, f64) = (Size::SECOND_COURSE, FRAC_PI_2);

/// Number of runs of one stripe from the top of the picture to its bottom.
fn stripes_in_the_middle() -> Counts {
    let stripe = stripe_at(WIDE, (10, Direction), Vector3::y)?;
    let rows = 0..WIDE.0.height();
    let column: Vec<_> = rows.map(|y| stripe(240.0, f64::from(y) + 0.5)).collect();
    Ok([0, 1].map(|i| column.chunk_by(|a, b| a[i] == b[i]).count()))
}

fn rows_of_several_stripes() -> Counts {
    let stripe = stripe_at(WIDE, (10, Wall), Vector3::y)?;
    wrong(0..WIDE.0.height(), |y| {
        let stripe = |x| stripe(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let row: Vec<_> = (0..WIDE.0.width()).map(stripe).collect();
        Ok([0, 1].map(|i| row.iter().any(|stripes| stripes[i] != row[0][i])))
    })
}
