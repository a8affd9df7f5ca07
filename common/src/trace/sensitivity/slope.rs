//! The slope of a colour, as the limit of difference quotients.
//!
//! Each step is half of the one before. Richardson's extrapolation finds the limit, and the difference
//! of its last results their error: C. J. F. Ridders, "Accurate computation of F'(x) and F'(x) F''(x)",
//! Advances in Engineering Software 4 (1982). A long step misses the shape of a narrow highlight, and
//! a short one is lost in rounding; the result with the least error counts.

use super::{Channels, magnitude, minus};

/// A slope, and the largest error of a channel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope {
    pub slope: Channels,
    pub error: f64,
}

/// Most steps: the last one is 2^-29 of the first.
const ROWS: usize = 30;
/// Most columns of the extrapolation.
const COLUMNS: usize = 6;
/// Ends the search.
const SMALL: f64 = 1e-11;

/// The derivative at the middle of two colours, which `ends` has on both sides of the value in this
/// distance; the distance between them comes first.
pub(super) fn central(
    step: f64,
    center: Channels,
    ends: &dyn Fn(f64) -> Option<(f64, [Channels; 2])>,
) -> Option<Slope> {
    let mut bends: Vec<f64> = Vec::new();
    limit(4.0, magnitude(center), step, &mut |step, distrust| {
        let (width, [below, above]) = ends(step)?;
        // The second difference of a smooth function falls to a quarter with half the step.
        let bend = std::array::from_fn(|i| above[i] + below[i] - 2.0 * center[i]);
        bends.push(magnitude(bend));
        if let [.., before, last] = bends[..] {
            let rounding = 1e-14 * magnitude(center);
            *distrust = last > before / 2.0 && last > rounding
                || last < before / 16.0 && before > 1e-9 * magnitude(center);
        }
        Some(minus(above, below).map(|change| change / width))
    })
}

/// The derivative on one side of the value, where `end` has the colour at this distance; the distance
/// itself comes first.
pub(super) fn one_sided(
    step: f64,
    center: Channels,
    end: &dyn Fn(f64) -> Option<(f64, Channels)>,
) -> Option<Slope> {
    limit(2.0, magnitude(center), step, &mut |step, _| {
        let (width, color) = end(step)?;
        Some(minus(color, center).map(|change| change / width))
    })
}

/// The limit of quotients with the steps `step`, `step` / 2, …, whose errors begin with the step for
/// the factor 2, and with its square for the factor 4. A quotient may say that it is not to be
/// trusted.
fn limit(
    factor: f64,
    scale: f64,
    step: f64,
    quotient: &mut dyn FnMut(f64, &mut bool) -> Option<Channels>,
) -> Option<Slope> {
    let mut rows: Vec<(Slope, bool)> = Vec::new();
    let mut before: Vec<Channels> = Vec::new();
    for row in 0..ROWS {
        let step = step / f64::from(1_u32 << row);
        let mut distrust = false;
        let mut columns = vec![quotient(step, &mut distrust)?];
        let mut power = 1.0;
        for earlier in before.iter().take(COLUMNS) {
            power *= factor;
            let newest = columns[columns.len() - 1];
            columns.push(std::array::from_fn(|i| {
                (power * newest[i] - earlier[i]) / (power - 1.0)
            }));
        }
        // The column that differs least from the one before it and from the row before.
        let mut of_row: Option<Slope> = None;
        for column in 1..columns.len() {
            let slope = columns[column];
            let errors =
                [columns[column - 1], before[column - 1]].map(|it| magnitude(minus(slope, it)));
            let error = errors[0].max(errors[1]);
            if of_row.is_none_or(|known| error < known.error) {
                of_row = Some(Slope { slope, error });
            }
        }
        if let Some(Slope { slope, error }) = of_row {
            // It has to agree with the row before; and colours are rounded.
            let last = rows.last().map(|(last, _)| *last);
            let change = last.map_or(f64::INFINITY, |last| magnitude(minus(slope, last.slope)));
            let rounding = 2.0 * f64::EPSILON * scale / step;
            let error = error.max(change).max(rounding);
            rows.push((Slope { slope, error }, distrust));
            // One result may agree by luck.
            let is_small = |error: f64| !distrust && error <= SMALL * magnitude(slope);
            if is_small(error) && last.is_some_and(|last| is_small(last.error)) {
                break;
            }
        }
        before = columns;
    }
    least_error(&rows)
}

/// The slope with the least error that is to be trusted. Half a step doubles what rounding does: so
/// errors of the steps after a slope tell its own, where it agrees with others by luck.
fn least_error(rows: &[(Slope, bool)]) -> Option<Slope> {
    let mut best: Option<Slope> = None;
    let mut rounding: f64 = 0.0;
    for (Slope { slope, error }, distrust) in rows.iter().rev() {
        rounding = error.max(rounding / 2.0);
        if !distrust && best.is_none_or(|best| rounding < best.error) {
            best = Some(Slope {
                slope: *slope,
                error: rounding,
            });
        }
    }
    best
}
