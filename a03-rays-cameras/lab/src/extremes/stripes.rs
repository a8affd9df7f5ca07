//! Stripes: their number, and whether they are straight.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{AgainstProtocol, count_wrong};

use crate::protocol::count_current_stripe;
use a03_rays_cameras::StripeRule::{self, Direction, Wall};
use a03_rays_cameras::{PinholeCamera, StripedSky};

/// The number of wrong results, or why there are none.
type Counts = Result<AgainstProtocol<usize>, ArgumentError>;

/// A picture of a striped sky, and the height by which the protocol counts its stripes.
struct StripedPicture {
    size: Size,
    camera: PinholeCamera,
    sky: StripedSky,
    stripes: u32,
    height: fn(Vector3) -> f64,
}

impl StripedPicture {
    /// A picture of this full angle.
    fn new(
        size: Size,
        alpha: f64,
        stripes: u32,
        rule: StripeRule,
        height: fn(Vector3) -> f64,
    ) -> Result<Self, ArgumentError> {
        let camera = PinholeCamera::new(Point3::ORIGIN, alpha)?;
        let sky = StripedSky::new(&camera, size, stripes, rule)?;
        Ok(Self {
            size,
            camera,
            sky,
            stripes,
            height,
        })
    }

    /// The picture of the second course, with ten stripes.
    fn wide(rule: StripeRule) -> Result<Self, ArgumentError> {
        Self::new(Size::SECOND_COURSE, FRAC_PI_2, 10, rule, Vector3::y)
    }

    /// The stripe at a position of the picture.
    fn stripe_at(&self, x: f64, y: f64) -> AgainstProtocol<u32> {
        let middle = f64::from(self.size.width()) / 2.0;
        let top = self.camera.generate_ray(self.size, middle, 0.0);
        let top = (self.height)(top.direction());
        let ray = self.camera.generate_ray(self.size, x, y);
        let height = (self.height)(ray.direction());
        AgainstProtocol {
            ours: self.sky.stripe(&ray),
            theirs: count_current_stripe(top, self.stripes, height),
        }
    }
}

/// The stripe that begins at the horizon: of N stripes, the protocol counts the
/// N / 2 above the horizon and the stripe at the horizon itself.
pub fn at_the_horizon() -> Counts {
    count_wrong(2..=1000, |n| {
        let size = Size::SECOND_COURSE;
        let picture = StripedPicture::new(size, FRAC_PI_3, n, Direction, Vector3::y)?;
        let stripe = picture.stripe_at(240.0, 135.0);
        Ok(AgainstProtocol {
            ours: stripe.ours != n / 2,
            theirs: stripe.theirs != n / 2 + 1,
        })
    })
}

/// Number of runs of one stripe from the top of the picture to its bottom.
pub fn down_the_middle() -> Counts {
    let picture = StripedPicture::wide(Direction)?;
    let mut runs = AgainstProtocol { ours: 1, theirs: 1 };
    let mut above = picture.stripe_at(240.0, 0.5);
    for row in 1..picture.size.height() {
        let stripe = picture.stripe_at(240.0, f64::from(row) + 0.5);
        runs.ours += usize::from(stripe.ours != above.ours);
        runs.theirs += usize::from(stripe.theirs != above.theirs);
        above = stripe;
    }
    Ok(runs)
}

pub fn rows_of_several() -> Counts {
    let picture = StripedPicture::wide(Wall)?;
    count_wrong(0..picture.size.height(), |row| {
        let y = f64::from(row) + 0.5;
        let first = picture.stripe_at(0.5, y);
        let mut is_mixed = AgainstProtocol::default();
        for column in 1..picture.size.width() {
            let stripe = picture.stripe_at(f64::from(column) + 0.5, y);
            is_mixed.ours |= stripe.ours != first.ours;
            is_mixed.theirs |= stripe.theirs != first.theirs;
        }
        Ok(is_mixed)
    })
}
