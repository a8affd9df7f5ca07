//! `Response`: how a colour changes with one number: an edge beside it, its slope, or a turning point.

use super::edge::{Side, side};
use super::slope::{Slope, central, one_sided};
use super::{Channels, Edge, Pixel, State, difference, magnitude, minus};

/// How the colour of a pixel changes with a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Response {
    /// It does not change.
    None,
    /// It has a derivative.
    Smooth {
        /// The change of each channel per unit.
        slope: Channels,
        /// An estimate of the largest error of a channel of the slope.
        error: f64,
    },
    /// Its slope is nearly 0, as at the top of a highlight, and half a pixel changes it all the same.
    Turning {
        /// The change of each channel per unit.
        slope: Channels,
        /// An estimate of the largest error of a channel of the slope.
        error: f64,
        /// The change of each channel when things have moved by half a pixel.
        half_pixel: Channels,
    },
    /// An edge passes through the pixel: a small change of the number moves it across a sample.
    Edge(Edge),
    /// Its slope jumps at the value: there is one below, and another one above.
    Kink {
        /// The change of each channel per unit for a smaller number.
        below: Channels,
        /// The change of each channel per unit for a larger number.
        above: Channels,
    },
    /// It changes, but no slope is known with five digits. This is its change when things have moved by
    /// half a pixel.
    Unknown(Channels),
    /// It has no derivative, because the number is whole.
    Whole,
    /// The number cannot be moved alone, for this reason.
    Fixed(String),
}

/// The largest error of a slope that is told, as a fraction of the slope.
const MAX_ERROR: f64 = 2e-6;
/// A slope is nearly 0 if it gives at most this fraction of the change by half a pixel.
const TURNING: f64 = 0.1;

impl Response {
    /// How a colour changes with a number of this value, at which its state is `center`. Edges are
    /// looked for up to the distance `reach`.
    pub(super) fn of(value: f64, reach: f64, center: &State, pixel: &dyn Pixel) -> Self {
        let sides = [-reach, reach].map(|reach| {
            let far = farthest(value, reach, pixel)?;
            Some(side(value, center, far, pixel))
        });
        let known: Vec<_> = sides.iter().flatten().collect();
        if known.is_empty() {
            let reason = "neither a larger nor a smaller value is allowed";
            return Self::Fixed(reason.to_owned());
        }
        let edges = known.iter().filter_map(|side| side.edge);
        if let Some(edge) = edges.min_by(|a, b| a.distance.abs().total_cmp(&b.distance.abs())) {
            return Self::Edge(edge);
        }
        if known.iter().all(|side| !side.changes) {
            return Self::None;
        }
        let slope = match &sides {
            [Some(below), Some(above)] => {
                match slope_between(value, center, [below, above], pixel) {
                    Ok(slope) => slope,
                    Err(kink) => return kink,
                }
            }
            [Some(side), None] | [None, Some(side)] => slope_beside(value, center, side, pixel),
            [None, None] => None,
        };
        told(slope, center, &known)
    }

    /// How strong it is, to compare it with others: first whether it is an edge, then the largest
    /// change of a channel.
    #[must_use]
    pub fn strength(&self) -> (bool, f64) {
        match self {
            Self::Edge(edge) => (true, magnitude(edge.jump)),
            Self::Smooth { slope, .. } => (false, magnitude(*slope)),
            Self::Kink { below, above } => (false, magnitude(*below).max(magnitude(*above))),
            Self::Unknown(change)
            | Self::Turning {
                half_pixel: change, ..
            } => (false, magnitude(*change)),
            Self::None | Self::Whole | Self::Fixed(_) => (false, 0.0),
        }
    }

    /// Whether the colour changes with the number.
    #[must_use]
    pub fn is_change(&self) -> bool {
        self.strength().1 > 0.0
    }
}

/// How often the distance between an allowed value and one that is not is halved.
const HALVINGS: u32 = 12;

/// The farthest displacement up to the reach at which the number has a colour. Where the reach goes
/// beyond the end of the number's range, it is just before the end.
fn farthest(value: f64, reach: f64, pixel: &dyn Pixel) -> Option<(f64, State)> {
    if let Some(state) = pixel.state(value + reach) {
        return (value + reach != value).then_some((reach, state));
    }
    let mut found = None;
    let (mut allowed, mut refused) = (0.0, reach);
    for _ in 0..HALVINGS {
        let offset = f64::midpoint(allowed, refused);
        if let Some(state) = pixel.state(value + offset) {
            allowed = offset;
            found = Some((offset, state));
        } else {
            refused = offset;
        }
    }
    found.filter(|(offset, _)| value + offset != value)
}

/// The slope where both sides are known; as an error, both slopes where they differ.
fn slope_between(
    value: f64,
    center: &State,
    sides: [&Side; 2],
    pixel: &dyn Pixel,
) -> Result<Option<Slope>, Response> {
    let steps = sides.map(step);
    let least = (value.abs() * 64.0 * f64::EPSILON).max(1e-6 * sides[0].reach.abs());
    if steps[0].min(steps[1]) > least {
        let ends = |step: f64| {
            let places = [value - step, value + step];
            let [below, above] = places.map(|place| pixel.color(place));
            Some((places[1] - places[0], [below?, above?]))
        };
        return Ok(central(steps[0].min(steps[1]), center.color, &ends));
    }
    // The slope may jump at the value itself.
    let Some([below, above]) = slope_beside(value, center, sides[0], pixel)
        .zip(slope_beside(value, center, sides[1], pixel))
        .map(<[Slope; 2]>::from)
    else {
        return Ok(None);
    };
    let largest = magnitude(below.slope).max(magnitude(above.slope));
    if below.error.max(above.error) > 1e-4 * largest {
        return Ok(None);
    }
    if difference(below.slope, above.slope) <= 1e-5 * largest {
        return Ok(Some(if below.error < above.error {
            below
        } else {
            above
        }));
    }
    Err(Response::Kink {
        below: below.slope,
        above: above.slope,
    })
}

/// The slope on one side of the value.
fn slope_beside(value: f64, center: &State, side: &Side, pixel: &dyn Pixel) -> Option<Slope> {
    let least = 1e-6 * side.reach.abs();
    let longest = match side.bend {
        Some(bend) if bend.abs() > least => step(side),
        _ => side.reach.abs() / 4.0,
    };
    let end = |step: f64| {
        let place = value + step.copysign(side.reach);
        Some((place - value, pixel.color(place)?))
    };
    one_sided(longest, center.color, &end)
}

/// The longest step of the differences on a side: it does not pass a place at which the slope jumps.
fn step(side: &Side) -> f64 {
    let quarter = side.reach.abs() / 4.0;
    side.bend
        .map_or(quarter, |bend| quarter.min(bend.abs() / 2.0))
}

/// What is told of a slope.
fn told(slope: Option<Slope>, center: &State, sides: &[&Side]) -> Response {
    let changes = sides
        .iter()
        .map(|side| (side.reach.abs(), minus(side.far, center.color)));
    let farthest = changes.max_by(|a, b| magnitude(a.1).total_cmp(&magnitude(b.1)));
    let (reach, half_pixel) = farthest.unwrap_or_default();
    let change = magnitude(half_pixel);
    match slope {
        // Also the error of a slope that is nearly 0 has to be small beside the change.
        Some(Slope { slope, error })
            if magnitude(slope) * reach < TURNING * change && error * reach < 1e-3 * change =>
        {
            Response::Turning {
                slope,
                error,
                half_pixel,
            }
        }
        Some(Slope { slope, error }) if error <= MAX_ERROR * magnitude(slope) => {
            Response::Smooth { slope, error }
        }
        _ => Response::Unknown(half_pixel),
    }
}
