//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{Case, Equal, Fails, wrong};

use crate::lab::protocol::count_current_stripe;
use crate::{PinholeCamera, StripeRule, StripedSky};

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

/// A striped sky behind a picture.
struct Picture {
    size: Size,
    camera: PinholeCamera,
    sky: StripedSky,
    stripes: u32,
}

impl Picture {
    fn new(size: Size, alpha: f64, stripes: u32, rule: StripeRule) -> Result<Self, ArgumentError> {
        let camera = PinholeCamera::new(Point3::ORIGIN, alpha)?;
        Ok(Self {
            size,
            sky: StripedSky::new(&camera, size, stripes, rule)?,
            camera,
            stripes,
        })
    }

    /// The stripe at a place: ours, and the one that the protocol counts by this height.
    fn stripe(&self, x: f64, y: f64, height: fn(Vector3) -> f64) -> [u32; 2] {
        let edge = f64::from(self.size.width()) / 2.0;
        let [top, ray] =
            [(edge, 0.0), (x, y)].map(|(x, y)| self.camera.generate_ray(self.size, x, y));
        let [top, height] = [top, ray].map(|ray| height(ray.direction()));
        [
            self.sky.stripe(&ray),
            count_current_stripe(top, self.stripes, height),
        ]
    }
}

/// The stripe that begins at the horizon: of N stripes, the protocol counts the
/// N / 2 above the horizon and the stripe at the horizon itself.
fn horizon() -> Counts {
    wrong(2..=1000, |n| {
        let picture = Picture::new(Size::SECOND_COURSE, FRAC_PI_3, n, StripeRule::Direction)?;
        let [ours, theirs] = picture.stripe(240.0, 135.0, Vector3::y);
        Ok([ours != n / 2, theirs != n / 2 + 1])
    })
}

/// The protocol counts both halves of the picture from their edges.
fn wrong_rows() -> Counts {
    let rows = (2..=200).flat_map(|stripes| (0..stripes).map(move |row| (stripes, row)));
    wrong(rows, |(n, row)| {
        let picture = Picture::new(Size::new(1, n)?, FRAC_PI_2, n, StripeRule::Wall)?;
        let height = |d: Vector3| d.y() / d.z().abs();
        let [ours, theirs] = picture.stripe(0.5, f64::from(row) + 0.5, height);
        Ok([ours != n - 1 - row, theirs != row + 1])
    })
}

fn ten_stripes(rule: StripeRule) -> Result<Picture, ArgumentError> {
    Picture::new(Size::SECOND_COURSE, FRAC_PI_2, 10, rule)
}

/// Number of runs of one stripe from the top of the picture to its bottom.
fn stripes_in_the_middle() -> Counts {
    let picture = ten_stripes(StripeRule::Direction)?;
    let rows = 0..picture.size.height();
    let column = rows.map(|y| picture.stripe(240.0, f64::from(y) + 0.5, Vector3::y));
    let column: Vec<_> = column.collect();
    Ok([0, 1].map(|i| {
        1 + column
            .windows(2)
            .filter(|pair| pair[0][i] != pair[1][i])
            .count()
    }))
}

fn rows_of_several_stripes() -> Counts {
    let picture = ten_stripes(StripeRule::Wall)?;
    wrong(0..picture.size.height(), |y| {
        let stripe = |x| picture.stripe(f64::from(x) + 0.5, f64::from(y) + 0.5, Vector3::y);
        let row: Vec<_> = (0..picture.size.width()).map(stripe).collect();
        Ok([0, 1].map(|i| row.iter().any(|stripes| stripes[i] != row[0][i])))
    })
}
