//! `Rounds`: the rounds in which the methods of an experiment take turns to be timed.

use common::Median;

use crate::experiment::Curve;

/// The fewest rounds, and the time in seconds that is enough for all rounds of an experiment.
const MIN_ROUNDS: usize = 9;
const ENOUGH_TIME: f64 = 6.0;

/// The most runs of a measurement.
const MAX_RUNS: f64 = 1e4;

/// The point of a curve whose turn it is, and how often it is run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// The number of the curve.
    pub curve: usize,
    /// The number of the point.
    pub point: usize,
    /// The runs whose time counts as one measurement.
    pub runs: u32,
}

/// In each round all methods take turns at each value of the parameter, so that other load on the machine
/// affects them equally.
///
/// Who has the clock runs the point of [`turn`](Self::turn), and tells [`took`](Self::took) the time.
pub struct Rounds {
    /// Each with the number of its round.
    turns: Vec<(usize, Turn)>,
    done: usize,
    least_time: f64,
    /// All measured times.
    total: f64,
    times: Vec<Vec<PointTimes>>,
}

/// The times of a point, one for each round.
#[derive(Clone, Default)]
struct PointTimes {
    /// The runs of each measurement; 0 before the first one.
    runs: u32,
    seconds: Vec<f64>,
    is_too_short: bool,
}

impl Rounds {
    /// A number of rounds; fewer if they take long. Runs are repeated until they take the least time, in
    /// seconds, which the clock can tell.
    pub fn new(curves: &[Curve], rounds: usize, least_time: f64) -> Self {
        let longest = curves.iter().map(|curve| curve.points.len()).max();
        let mut turns = Vec::new();
        for round in 0..rounds {
            for point in 0..longest.unwrap_or(0) {
                for turn in 0..curves.len() {
                    // Another one begins each time, because the first may find caches empty.
                    let curve = (turn + round) % curves.len();
                    if point < curves[curve].points.len() {
                        let runs = 1;
                        turns.push((round, Turn { curve, point, runs }));
                    }
                }
            }
        }
        let unmeasured = |curve: &Curve| vec![PointTimes::default(); curve.points.len()];
        Self {
            turns,
            done: 0,
            least_time,
            total: 0.0,
            times: curves.iter().map(unmeasured).collect(),
        }
    }

    /// Whose turn it is; none at the end.
    pub fn turn(&self) -> Option<Turn> {
        let (round, turn) = *self.turns.get(self.done)?;
        if round >= MIN_ROUNDS && self.total > ENOUGH_TIME {
            return None;
        }
        let runs = self.times[turn.curve][turn.point].runs.max(1);
        Some(Turn { runs, ..turn })
    }

    /// Takes the time of the runs of this turn, in seconds. The first runs fill caches, and say how many
    /// take long enough: the turn comes again. Later ones may say so, too, where a browser goes on to
    /// optimise: no time is left out because it is short.
    pub fn took(&mut self, seconds: f64) {
        let Some(Turn { curve, point, runs }) = self.turn() else {
            return;
        };
        self.total += seconds;
        let times = &mut self.times[curve][point];
        let is_first = times.runs == 0;
        let is_short = seconds < self.least_time && f64::from(runs) < MAX_RUNS;
        times.is_too_short = seconds < self.least_time / 2.0;
        // A clock that does not see a run sees a hundred of them, or ten thousand.
        let factor = (1.2 * self.least_time / seconds).clamp(1.0, 100.0);
        times.runs = libm::ceil((f64::from(runs) * factor).min(MAX_RUNS)) as u32;
        if times.seconds.is_empty() && (is_first || is_short) {
            return;
        }
        times.seconds.push(seconds / f64::from(runs));
        self.done += 1;
    }

    /// The measured times, and their number if no round is left out.
    pub fn progress(&self) -> [usize; 2] {
        [self.done, self.turns.len()]
    }

    /// The number of times of each point that all points have.
    pub fn whole_rounds(&self) -> usize {
        let counts = self.times.iter().flatten().map(|times| times.seconds.len());
        counts.min().unwrap_or(0)
    }

    /// Whether a point took less time than the clock can tell, however often it was run.
    pub fn is_too_short(&self) -> bool {
        self.times.iter().flatten().any(|times| times.is_too_short)
    }

    /// The times of a point.
    pub(crate) fn of(&self, curve: usize, point: usize) -> &[f64] {
        &self.times[curve][point].seconds
    }

    /// The median of the quotients of a point's times and those of another curve at the same place.
    pub(crate) fn quotient(&self, curve: usize, other: usize, point: usize) -> Median {
        Median::of_quotients(self.of(curve, point), self.of(other, point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example::curve;

    /// A run takes 0.3 ms on a clock with steps of 1 ms, which asks for 50 ms: 200 runs or so are known to a
    /// fiftieth. A run of a nanosecond is never seen.
    #[test]
    fn short_runs_are_repeated_until_the_clock_sees_them() {
        let curves = [curve(&[(1.0, 1.0)]), curve(&[(1.0, 1.0)])];
        let run = [3e-4, 1e-9];
        let mut rounds = Rounds::new(&curves, 2, 0.05);
        let mut order = Vec::new();
        while let Some(turn) = rounds.turn() {
            let seconds = run[turn.curve] * f64::from(turn.runs);
            let before = rounds.progress();
            rounds.took((seconds * 1e3).floor() / 1e3);
            if rounds.progress() != before {
                order.push(turn.curve);
            }
        }
        assert_eq!(order, [0, 1, 1, 0]);
        for seconds in rounds.of(0, 0) {
            assert!((seconds / 3e-4 - 1.0).abs() < 0.02, "{seconds}");
        }
        assert!(rounds.is_too_short());
    }
}
