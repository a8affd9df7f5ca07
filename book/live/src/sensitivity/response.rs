//! `Response`: how the colour of a pixel answers a number that is moved to both sides.
//!
//! To each side the number is moved by a step and by half of it. Where the colour is a smooth function,
//! the two difference quotients agree but for the curvature, and tell the slope and how exact it is.
//! Over an edge they do not: there the colour jumps.

use std::array;

/// The channels of a linear colour.
pub type Channels = [f64; 3];

/// How a colour answers a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Response {
    /// It stays as it is, but for rounding.
    None,
    /// It changes by this much per unit.
    Slope {
        /// The change of each channel per unit.
        slope: Channels,
        /// How far off a channel may be.
        error: f64,
    },
    /// It jumps.
    Jump {
        /// The value of the number at which it jumps.
        at: f64,
        /// The colour beyond, seen from the present value, minus the one before.
        jump: Channels,
    },
    /// It changes without a jump, but half a step and a whole one agree on no slope, such as at the top
    /// of a highlight.
    Bend {
        /// The value of the number at which it has changed most.
        at: f64,
        /// The change there.
        change: Channels,
    },
}

/// What a change loses in some hundred roundings, as a fraction of the colour.
const ROUNDING: f64 = 256.0 * f64::EPSILON;
/// How often a step is halved until its value is allowed.
const MAX_SHORTENINGS: u32 = 12;
/// How often a step is halved to see whether a jump stays in it, and how often before that is judged.
const MAX_HALVINGS: u32 = 48;
const LEAD: u32 = 8;
/// What halving a step leaves of the change in it: at least this, if it is a jump. It is the root of
/// what it leaves of a root.
const JUMP_STAYS: f64 = 0.840_896_415_253_714_5;

/// By how much a number was moved, negative to the smaller values, and how the colour changed.
type Moved = (f64, Channels);

/// How a colour answers a number of this value that is moved by up to `step`, and the largest change of
/// a channel. `color` has none for a value that is not allowed.
pub fn response(value: f64, step: f64, color: &dyn Fn(f64) -> Option<Channels>) -> (Response, f64) {
    let Some(center) = color(value) else {
        return (Response::None, 0.0);
    };
    let sides = [-step, step].map(|step| side(value, step, center, color));
    let sides: Vec<[Moved; 2]> = sides.into_iter().flatten().collect();
    let (mut most, mut change) = (0.0, [0.0; 3]);
    for (moved, changed) in sides.as_flattened() {
        if magnitude(*changed) > magnitude(change) {
            (most, change) = (*moved, *changed);
        }
    }
    let strength = magnitude(change);
    let rounding = ROUNDING * (magnitude(center) + strength);
    if strength <= rounding {
        return (Response::None, 0.0);
    }
    let jumps = sides
        .iter()
        .filter_map(|[_, (step, _)]| jump(value, *step, color));
    if let Some((at, jump)) = jumps.max_by(|a, b| magnitude(a.1).total_cmp(&magnitude(b.1))) {
        return (Response::Jump { at, jump }, strength.max(magnitude(jump)));
    }
    let (slope, error) = slope(&sides);
    let shortest = sides.as_flattened().iter().map(|(moved, _)| moved.abs());
    let error = error + 2.0 * rounding / shortest.fold(f64::INFINITY, f64::min);
    if error < magnitude(slope) {
        return (Response::Slope { slope, error }, strength);
    }
    let at = value + most;
    (Response::Bend { at, change }, strength)
}

/// The changes by half the step and by the whole one, which is shortened until its value is allowed; none
/// if no value is.
fn side(
    value: f64,
    step: f64,
    center: Channels,
    color: &dyn Fn(f64) -> Option<Channels>,
) -> Option<[Moved; 2]> {
    let moved = |step: f64| {
        // A rounded value is moved by another step, and this difference is exact.
        let step = value + step - value;
        let color = color(value + step)?;
        (step != 0.0).then(|| (step, minus(color, center)))
    };
    (0..MAX_SHORTENINGS).find_map(|i| {
        let step = step / f64::from(1 << i);
        Some([moved(step / 2.0)?, moved(step)?])
    })
}

/// The slope by half the step, and how far off it may be: as far as the slope by the whole step is
/// from it. Where both sides are known, what remains of their difference is added, once it is extrapolated
/// to no step: nothing of a curve, but all of a bend at the value itself.
fn slope(sides: &[[Moved; 2]]) -> (Channels, f64) {
    let (mut by_half, mut by_whole) = ([0.0; 3], [0.0; 3]);
    let mut remaining = [0.0; 3];
    for side in sides {
        let [half, whole] = side.map(|(step, change)| change.map(|channel| channel / step));
        let sign = side[0].0.signum();
        for channel in 0..3 {
            by_half[channel] += half[channel] / sides.len() as f64;
            by_whole[channel] += whole[channel] / sides.len() as f64;
            remaining[channel] += sign * (2.0 * half[channel] - whole[channel]);
        }
    }
    let mut error = magnitude(minus(by_half, by_whole));
    if sides.len() == 2 {
        error += magnitude(remaining);
    }
    (by_half, error)
}

/// The jump within a step, and where it is. The step is halved again and again, and the half is kept in
/// which the colour changes more. After some halvings little is left of what is smooth beside a jump. From
/// then on a smooth change would be halved each time, and that of a root, the steepest that a grazing ray
/// makes, would be 0.71 times as large; a jump stays. The limit lies half-way between root and jump.
fn jump(value: f64, step: f64, color: &dyn Fn(f64) -> Option<Channels>) -> Option<(f64, Channels)> {
    let mut ends = [value, value + step];
    let mut colors = [color(ends[0])?, color(ends[1])?];
    let mut limit = 0.0;
    for halvings in 1..=MAX_HALVINGS {
        let middle = f64::midpoint(ends[0], ends[1]);
        if ends.contains(&middle) {
            break;
        }
        let between = color(middle)?;
        let changes = [minus(between, colors[0]), minus(colors[1], between)].map(magnitude);
        let farther_end = usize::from(changes[0] > changes[1]);
        ends[farther_end] = middle;
        colors[farther_end] = between;
        let change = changes[0].max(changes[1]);
        if halvings <= LEAD {
            limit = change;
        } else {
            limit *= JUMP_STAYS;
            if change <= limit {
                return None;
            }
        }
    }
    Some((ends[0], minus(colors[1], colors[0])))
}

fn minus(a: Channels, b: Channels) -> Channels {
    array::from_fn(|i| a[i] - b[i])
}

/// The largest channel, without its sign.
fn magnitude(a: Channels) -> f64 {
    a.into_iter().map(f64::abs).fold(0.0, f64::max)
}
