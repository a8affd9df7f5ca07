//! The pictures of this stage: the second course's striped sky, with both rules.

use std::f64::consts::FRAC_PI_2;

use a02_math::Point3;
use common::{ArgumentError, Size};

use crate::{PinholeCamera, StripeRule, StripedSky, View};

const STRIPES: u32 = 10;

/// A camera at the origin with a field of view of 90 degrees, and a sky whose
/// stripes fill a picture of this size.
pub fn striped_sky(size: Size, rule: StripeRule) -> Result<View<StripedSky>, ArgumentError> {
    let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
    let sky = StripedSky::new(&camera, size, STRIPES, rule)?;
    Ok(View::new(camera, sky))
}
