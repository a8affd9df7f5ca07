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
/// Most halvings. After 40 of them the interval is as short as rounding allows, or nearly so.
const HALVINGS: usize = 40;
/// Rows of the extrapolation: the last step is the first one divided by 64.
const ROWS: usize = 7;
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
            (Some(step), None) => one_sided(value, -step, center, at).into_smooth(),
            (None, Some(step)) => one_sided(value, step, center, at).into_smooth(),
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

/// What is found on one side of the value.
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
    // Below this it is rounding, or a jump that nobody sees.
    if change <= 1e-9 * scale {
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
    Some(Edge {
        distance: near.0,
        jump: minus(far.1, near.1),
    })
}

/// A slope with an estimate of its error.
struct Estimate {
    slope: Channels,
    error: f64,
    /// The difference quotients of the first and the last step.
    ends: [Channels; 2],
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

/// The slope where both sides are allowed.
fn two_sided(value: f64, step: f64, center: Channels, at: At) -> Response {
    let [above, below] = [step, -step].map(|step| one_sided(value, step, center, at));
    let central = extrapolated(4.0, |row| {
        let step = step / f64::from(1_u32 << row);
        let (right, left) = (value + step, value - step);
        let change = minus(at(right)?, at(left)?);
        Some(change.map(|change| change / (right - left)))
    });
    let Some(central) = central else {
        return above.into_smooth();
    };
    let [first, last] = [0, 1].map(|end| difference(above.ends[end], below.ends[end]));
    let slopes = magnitude(above.slope).max(magnitude(below.slope));
    // Of a smooth function the two differ by the step times its second derivative.
    if last > first / 4.0 && last > 1e-6 * slopes && last > 8.0 * (above.error + below.error) {
        return Response::Kink {
            below: below.slope,
            above: above.slope,
        };
    }
    central.into_smooth()
}

/// The slope on one side of the value, that of the sign of the step.
fn one_sided(value: f64, step: f64, center: Channels, at: At) -> Estimate {
    let estimate = extrapolated(2.0, |row| {
        let place = value + step / f64::from(1_u32 << row);
        let change = minus(at(place)?, center);
        Some(change.map(|change| change / (place - value)))
    });
    estimate.unwrap_or(Estimate {
        slope: [0.0; 3],
        error: f64::INFINITY,
        ends: [[0.0; 3]; 2],
    })
}

/// The limit of difference quotients, each with half of the step before, whose errors begin with
/// the step for the factor 2, and with its square for the factor 4.
fn extrapolated(
    factor: f64,
    mut quotient: impl FnMut(usize) -> Option<Channels>,
) -> Option<Estimate> {
    let mut rows: Vec<Vec<Channels>> = Vec::new();
    for row in 0..ROWS {
        let mut columns = vec![quotient(row)?];
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
    let ends = [rows[0][0], rows[ROWS - 1][0]];
    let (mut slope, mut error) = ([0.0; 3], [f64::INFINITY; 3]);
    for channel in 0..3 {
        for row in 1..ROWS {
            for column in 1..=row {
                let best = rows[row][column][channel];
                let before = [rows[row][column - 1], rows[row - 1][column - 1]];
                let differences = before.map(|it| (best - it[channel]).abs());
                let estimate = differences[0].max(differences[1]);
                if estimate < error[channel] {
                    (slope[channel], error[channel]) = (best, estimate);
                }
            }
        }
    }
    let error = error.into_iter().fold(0.0, f64::max);
    Some(Estimate { slope, error, ends })
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
