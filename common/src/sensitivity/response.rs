//! `Response`: how a colour changes with one number: its derivative, or the edge beside it.
//!
//! The derivative is the limit of central differences with the steps h, h/2, h/4, …, which
//! Richardson's extrapolation finds and whose error it estimates: C. J. F. Ridders, "Accurate
//! computation of F'(x) and F'(x) F''(x)", Advances in Engineering Software 4 (1982). No step is
//! right for every number: a long one misses the shape of a highlight, and a short one is lost in
//! rounding. The extrapolation takes the order at which its own error is least.
//!
//! Where the colour jumps, no difference quotient has a limit. So the colour is first asked for at
//! some places beside the number, and a change between two of them that does not shrink while its
//! interval is halved is a jump.

/// The channels of a linear colour.
type Channels = [f64; 3];

/// A place beside the value of a number at which the colour jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// How far it is from the value: what has to be added to reach it. 0 if the value itself
    /// is at the edge, as far as can be told.
    pub distance: f64,
    /// The colour beyond the edge minus the colour before it, seen from the value.
    pub jump: Channels,
}

/// How the colour of a pixel changes with a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Response {
    /// It does not change.
    None,
    /// It has a derivative.
    Smooth {
        /// The change of each channel per unit.
        slope: Channels,
        /// An estimate of the error of the slope.
        error: f64,
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
    /// It has no derivative, because the number is whole.
    Whole,
    /// The number cannot be moved alone, for this reason.
    Fixed(String),
}

/// The colour at values of a number; none where it has no colour, such as outside of its range.
type At<'a> = &'a mut dyn FnMut(f64) -> Option<Channels>;

/// The places at which edges are looked for, as fractions of the reach.
const FRACTIONS: [f64; 3] = [1.0 / 16.0, 0.25, 1.0];
/// A change that has shrunk to this fraction, while its interval was halved, is no jump: the one of
/// a smooth function shrinks to half with each halving, and that of a root to 0.7.
const SHRUNK: f64 = 1.0 / 16.0;
/// A jump of at most this fraction of the colour is none.
const LEAST_JUMP: f64 = 1e-6;
/// Most halvings. After 40 of them the interval is as short as rounding allows, or nearly so.
const HALVINGS: usize = 40;
/// Rows of the extrapolation: the last step is the first one divided by 512.
const ROWS: usize = 10;
/// A change of at most this fraction of the colour is rounding. It allows some hundred roundings,
/// which a grazing ray can make larger.
const ROUNDING: f64 = 1e-13;

impl Response {
    /// How a colour changes with a number of this value, where the colour is `center`. Edges are looked for up to the distance
    /// `reach`, which is also the measure for the steps of the derivative: the colour should have its
    /// shape at this scale, and not at a much smaller one.
    pub fn of(value: f64, center: [f64; 3], reach: f64, at: At) -> Self {
        // Most numbers of a scene have nothing to do with a pixel.
        let ends = [value - reach, value + reach].map(&mut *at);
        if ends == [Some(center); 2] {
            return Self::None;
        }
        let mut sides = [-reach, reach].map(|reach| Side::of(value, reach, at));
        if sides.iter().all(|side| side.points.is_empty()) {
            let reason = "neither a larger nor a smaller value is allowed";
            return Self::Fixed(reason.to_owned());
        }
        let points = || sides.iter().flat_map(|side| &side.points);
        let largest = points().map(|(_, color)| difference(*color, center));
        let largest = largest.fold(0.0, f64::max);
        if largest <= ROUNDING * magnitude(center) {
            return Self::None;
        }
        for side in &mut sides {
            side.find_edge(value, center, at);
        }
        let edges = sides.iter().filter_map(|side| side.edge);
        let nearest = edges.min_by(|a, b| a.distance.abs().total_cmp(&b.distance.abs()));
        if let Some(edge) = nearest {
            return Self::Edge(edge);
        }
        let [below, above] = sides.map(|side| side.step(value));
        match (below, above) {
            (Some(below), Some(above)) => two_sided(value, below.min(above), center, at),
            (Some(step), None) => slope_of_side(value, -step, center, at),
            (None, Some(step)) => slope_of_side(value, step, center, at),
            (None, None) => Self::None,
        }
    }

    /// How strong it is, to compare it with others: first whether it is an edge, then the largest
    /// change of a channel.
    #[must_use]
    pub fn strength(&self) -> (bool, f64) {
        match self {
            Self::Edge(edge) => (true, magnitude(edge.jump)),
            Self::Smooth { slope, .. } => (false, magnitude(*slope)),
            Self::Kink { below, above } => (false, magnitude(*below).max(magnitude(*above))),
            Self::None | Self::Whole | Self::Fixed(_) => (false, 0.0),
        }
    }

    /// Whether the colour changes with the number.
    #[must_use]
    pub fn is_change(&self) -> bool {
        self.strength().1 > 0.0
    }
}

/// The samples on one side of the value.
struct Side {
    /// Displacements from the value, from the nearest to the farthest, and the colours there.
    points: Vec<(f64, Channels)>,
    edge: Option<Edge>,
}

impl Side {
    /// The colours up to a reach, which is negative on the side of the smaller values. Beyond the
    /// range of the number there are none; then the reach is shorter.
    fn of(value: f64, reach: f64, at: At) -> Self {
        for shorter in [1.0, 1.0 / 64.0, 1.0 / 4096.0] {
            let mut points = Vec::new();
            for fraction in FRACTIONS {
                let offset = fraction * shorter * reach;
                match at(value + offset) {
                    Some(color) if value + offset != value => points.push((offset, color)),
                    _ => break,
                }
            }
            if !points.is_empty() {
                return Self { points, edge: None };
            }
        }
        Self {
            points: Vec::new(),
            edge: None,
        }
    }

    /// Finds the edge that is nearest to the value.
    fn find_edge(&mut self, value: f64, center: Channels, at: At) {
        let mut near = (0.0, center);
        for far in &self.points {
            self.edge = jump_between(value, near, *far, at);
            if self.edge.is_some() {
                return;
            }
            near = *far;
        }
    }

    /// The longest step of the derivative: a quarter of the reach.
    fn step(&self, value: f64) -> Option<f64> {
        let (farthest, _) = self.points.last()?;
        let step = (farthest / 4.0).abs();
        // A step that the sum with the value keeps exactly.
        let step = (value + step) - value;
        (step > 0.0).then_some(step)
    }
}

/// The jump between two displacements, if the change between them is one.
fn jump_between(value: f64, near: (f64, Channels), far: (f64, Channels), at: At) -> Option<Edge> {
    let change = difference(near.1, far.1);
    let scale = magnitude(near.1).max(magnitude(far.1));
    // Below this it is rounding, or a jump that nobody sees: a byte has 255 steps.
    if change <= LEAST_JUMP * scale {
        return None;
    }
    let (mut near, mut far) = (near, far);
    for _ in 0..HALVINGS {
        let middle = near.0 + (far.0 - near.0) / 2.0;
        let place = value + middle;
        if place == value + near.0 || place == value + far.0 {
            break;
        }
        let middle = (middle, at(place)?);
        let [left, right] = [difference(near.1, middle.1), difference(middle.1, far.1)];
        if left.max(right) < SHRUNK * change {
            return None;
        }
        if left >= right {
            far = middle;
        } else {
            near = middle;
        }
    }
    let edge = Edge {
        distance: near.0,
        jump: minus(far.1, near.1),
    };
    is_calm_beside(value, near, far, at).then_some(edge)
}

/// Whether the colour changes little on both sides of a jump. Rounding, as in the picture of an eye
/// that is very far away, changes it there as much.
fn is_calm_beside(value: f64, near: (f64, Channels), far: (f64, Channels), at: At) -> bool {
    let jump = difference(near.1, far.1);
    // At least some roundings away.
    let least = 16.0 * f64::EPSILON * value.abs().max(far.0.abs());
    let step = (far.0 - near.0).abs().max(least).copysign(far.0);
    let mut is_calm = |from: (f64, Channels), step: f64| {
        let color = at(value + from.0 + step);
        color.is_none_or(|color| difference(color, from.1) < jump / 4.0)
    };
    let steps = [1.0, 2.0, 3.0].map(|times| times * step);
    steps
        .into_iter()
        .all(|step| is_calm(near, -step) && is_calm(far, step))
}

/// A slope with an estimate of its error.
struct Estimate {
    slope: Channels,
    error: f64,
    /// The difference quotients, from that of the longest step.
    quotients: Vec<Channels>,
}

impl Estimate {
    fn into_smooth(self) -> Response {
        if magnitude(self.slope) <= self.error {
            return Response::None;
        }
        Response::Smooth {
            slope: self.slope,
            error: self.error,
        }
    }
}

/// A value of the number, and the colour there.
struct Sample {
    place: f64,
    color: Channels,
}

/// The colours at the displacements h, h/2, h/4, …; none if one of them has no colour.
fn samples(value: f64, step: f64, at: At) -> Option<Vec<Sample>> {
    let mut samples = Vec::new();
    for row in 0..ROWS {
        let place = value + step / f64::from(1_u32 << row);
        let color = at(place)?;
        samples.push(Sample { place, color });
    }
    Some(samples)
}

/// The slope where both sides are allowed.
fn two_sided(value: f64, step: f64, center: Channels, at: At) -> Response {
    let (Some(right), Some(left)) = (samples(value, step, at), samples(value, -step, at)) else {
        return Response::Fixed("some smaller or larger values are not allowed".to_owned());
    };
    let [above, below] = [&right, &left].map(|side| one_sided(value, center, side));
    let pairs = right.iter().zip(&left);
    let central = pairs.map(|(right, left)| {
        let change = minus(right.color, left.color);
        change.map(|change| change / (right.place - left.place))
    });
    let central = extrapolated(4.0, central);
    // Of a smooth function, the two slopes differ by the step times its second derivative, so that
    // their difference vanishes; rounding lets it grow. At a kink it stays.
    let differences = above.quotients.iter().zip(&below.quotients);
    let differences: Vec<_> = differences.map(|(a, b)| minus(*a, *b)).collect();
    let last = differences[ROWS - 1];
    let stays = differences[ROWS - 4..]
        .iter()
        .all(|earlier| difference(*earlier, last) <= 0.1 * magnitude(last));
    let slopes = magnitude(above.slope).max(magnitude(below.slope));
    if stays && magnitude(last) > 1e-6 * slopes {
        return Response::Kink {
            below: below.slope,
            above: above.slope,
        };
    }
    central.into_smooth()
}

/// The slope where only the side of the sign of the step is allowed.
fn slope_of_side(value: f64, step: f64, center: Channels, at: At) -> Response {
    match samples(value, step, at) {
        Some(samples) => one_sided(value, center, &samples).into_smooth(),
        None => Response::Fixed("some values beside it are not allowed".to_owned()),
    }
}

/// The slope on one side of the value.
fn one_sided(value: f64, center: Channels, samples: &[Sample]) -> Estimate {
    let quotients = samples.iter().map(|sample| {
        let change = minus(sample.color, center);
        change.map(|change| change / (sample.place - value))
    });
    extrapolated(2.0, quotients)
}

/// The limit of difference quotients, each with half of the step before, whose errors begin with
/// the step for the factor 2, and with its square for the factor 4.
fn extrapolated(factor: f64, quotients: impl Iterator<Item = Channels>) -> Estimate {
    let mut rows: Vec<Vec<Channels>> = Vec::new();
    for quotient in quotients {
        let mut columns = vec![quotient];
        let mut power = 1.0;
        for before in rows.last().into_iter().flatten() {
            power *= factor;
            let last = columns[columns.len() - 1];
            columns.push(std::array::from_fn(|i| {
                (power * last[i] - before[i]) / (power - 1.0)
            }));
        }
        rows.push(columns);
    }
    let quotients = rows.iter().map(|columns| columns[0]).collect();
    // The difference of the last two steps is mostly rounding, which is less in longer steps.
    let rounding = minus(rows[ROWS - 1][1], rows[ROWS - 2][1]).map(f64::abs);
    let (mut slope, mut error) = ([0.0; 3], [f64::INFINITY; 3]);
    for channel in 0..3 {
        for row in 1..ROWS {
            for column in 1..=row {
                let best = rows[row][column][channel];
                let before = [rows[row][column - 1], rows[row - 1][column - 1]];
                let differences = before.map(|it| (best - it[channel]).abs());
                let rounding = rounding[channel] / f64::from(1_u32 << (ROWS - 1 - row));
                let estimate = differences[0].max(differences[1]).max(rounding);
                if estimate < error[channel] {
                    (slope[channel], error[channel]) = (best, estimate);
                }
            }
        }
    }
    let error = error.into_iter().fold(0.0, f64::max);
    Estimate {
        slope,
        error,
        quotients,
    }
}

fn minus(a: Channels, b: Channels) -> Channels {
    std::array::from_fn(|i| a[i] - b[i])
}

fn magnitude(a: Channels) -> f64 {
    a.into_iter().map(f64::abs).fold(0.0, f64::max)
}

fn difference(a: Channels, b: Channels) -> f64 {
    magnitude(minus(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The response of a function at a value, with a reach of 1/100.
    fn of(value: f64, f: fn(f64) -> f64) -> Response {
        Response::of(value, [f(value); 3], 0.01, &mut |x| Some([f(x); 3]))
    }

    #[track_caller]
    fn assert_slope(response: &Response, expected: f64) {
        let Response::Smooth { slope, error } = response else {
            panic!("{response:?}");
        };
        let difference = (slope[0] - expected).abs();
        assert!(difference <= 1e-9 * expected.abs(), "{slope:?}");
        assert!(*error <= 1e-6 * expected.abs(), "{error}");
    }

    #[test]
    fn smooth_functions_have_their_derivative() {
        assert_slope(&of(2.0, |x| 3.0 * x), 3.0);
        assert_slope(&of(2.0, |x| x * x * x), 12.0);
        assert_slope(&of(0.0, |x| x - x * x), 1.0);
        assert_slope(&of(1.0, libm::exp), std::f64::consts::E);
        // A narrow highlight: its width is a tenth of the reach.
        let highlight = |x: f64| libm::exp(-1e6 * x * x);
        let expected = -2e6 * 5e-4 * libm::exp(-0.25);
        assert_slope(&of(5e-4, highlight), expected);
        // Steep, but without an edge.
        let Response::Smooth { slope, .. } = of(1e-4, |x| x.max(0.0).sqrt()) else {
            panic!("a root");
        };
        assert!((slope[0] - 50.0).abs() < 50e-6, "{slope:?}");
        assert_eq!(of(7.0, |_| 0.25), Response::None);
    }

    #[test]
    fn jumps_and_kinks_are_told_apart() {
        for place in [1.0 + 1e-12, 1.003, 0.9951] {
            let mut f = |x: f64| Some([if x < place { x } else { x + 0.5 }; 3]);
            let center = f(1.0).unwrap();
            let Response::Edge(edge) = Response::of(1.0, center, 0.01, &mut f) else {
                panic!("{place}");
            };
            let distance = place - 1.0;
            assert!((edge.distance - distance).abs() < 1e-9, "{edge:?}");
            // Seen from the value: beyond a smaller place it is darker.
            let jump = 0.5_f64.copysign(distance);
            assert!((edge.jump[0] - jump).abs() < 1e-6, "{edge:?}");
        }
        let Response::Kink { below, above } = of(0.0, |x| x.max(2.0 * x)) else {
            panic!("a kink");
        };
        assert!((below[1] - 1.0).abs() < 1e-9 && (above[1] - 2.0).abs() < 1e-9);
    }

    #[test]
    fn at_the_end_of_a_range_one_side_is_enough() {
        let mut f = |x: f64| (x >= 0.0).then_some([x * (1.0 + x); 3]);
        assert_slope(&Response::of(0.0, [0.0; 3], 0.01, &mut f), 1.0);
        let mut near = |x: f64| (x > 0.999).then_some([x * x; 3]);
        assert_slope(&Response::of(1.0, [1.0; 3], 0.01, &mut near), 2.0);
        let mut only = |x: f64| (x == 1.0).then_some([1.0; 3]);
        let fixed = Response::of(1.0, [1.0; 3], 0.01, &mut only);
        assert!(matches!(fixed, Response::Fixed(_)), "{fixed:?}");
    }

    #[test]
    fn rounding_is_no_edge() {
        // The bits of the value decide about a millionth of the colour.
        let noisy = |x: f64| {
            let bits = x.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
            x + 1e-6 * bits as f64 / f64::from(1 << 24)
        };
        let response = of(1.0, noisy);
        assert!(!matches!(response, Response::Edge(_)), "{response:?}");
    }
}
