//! `StripedSky`: a background of horizontal stripes in two colours.

use common::{ArgumentError, Color, Size};

use crate::{PinholeCamera, Ray};
use a02_math::Vector3;

/// The quantity of a ray that determines its stripe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StripeRule {
    /// The height of the direction of length 1, as in the text. Rays of one
    /// height form a cone, which intersects the picture in a hyperbola: the
    /// stripes bend away from the horizon to both sides.
    Direction,
    /// The height at which the ray hits a wall perpendicular to the gaze. The
    /// stripes are straight.
    Wall,
}

impl StripeRule {
    fn height(self, d: Vector3) -> f64 {
        match self {
            Self::Direction => d.y(),
            Self::Wall => d.y() / d.z().abs(),
        }
    }
}

/// A sky of stripes of equal height that fill the picture of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripedSky {
    rule: StripeRule,
    stripes: u32,
    top: f64,
}

/// The colour of stripe 0 and of all even ones, counted from below.
const EVEN: [u8; 3] = [25, 25, 112];
/// The colour of the odd stripes.
const ODD: [u8; 3] = [50, 205, 50];

impl StripedSky {
    /// A sky with this number of stripes, at least one, between the lower and the upper
    /// edge of the camera's picture, measured in its middle column.
    pub fn new(
        camera: &PinholeCamera,
        size: Size,
        stripes: u32,
        rule: StripeRule,
    ) -> Result<Self, ArgumentError> {
        if stripes == 0 {
            return Err(ArgumentError::new("stripes", stripes, "at least 1"));
        }
        let upper_edge = camera.generate_ray(size, f64::from(size.width()) / 2.0, 0.0);
        Ok(Self {
            rule,
            stripes,
            top: rule.height(upper_edge.direction()),
        })
    }

    // ANCHOR: stripe
    /// Number of the stripe that the ray hits, counted from 0 at the lower edge.
    /// Rays beyond an edge hit the stripe at that edge.
    #[must_use]
    pub fn stripe(&self, ray: &Ray) -> u32 {
        // From 0 at the lower edge to 1 at the upper one, and exactly 1/2 at
        // the horizon.
        let from_below = 0.5 + 0.5 * self.rule.height(ray.direction()) / self.top;
        // The cast saturates: below the lower edge is 0.
        ((from_below * f64::from(self.stripes)) as u32).min(self.stripes - 1)
    }
    // ANCHOR_END: stripe

    /// The colour of the stripe that the ray hits.
    #[must_use]
    pub fn color_for(&self, ray: &Ray) -> Color {
        let is_even = self.stripe(ray).is_multiple_of(2);
        Color::from_bytes(if is_even { EVEN } else { ODD })
    }
}
