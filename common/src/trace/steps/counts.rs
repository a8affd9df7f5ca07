//! Counts of steps: how much work a rendering does.
//!
//! Counts, unlike times, are the same on every machine. Only the threads of the pool that
//! [`counted`] makes count at all, so that other work at the same time is not counted.

use std::ops::Index;

use super::StepKind;
use super::recorder::{Mode, RECORDER, mode};
use crate::Error;

/// How many steps of each kind were taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts([u64; StepKind::COUNT]);

impl Counts {
    /// No steps.
    pub const NONE: Self = Self([0; StepKind::COUNT]);
}

impl Counts {
    /// How many more steps of each kind these are than others; 0 where they are fewer.
    #[must_use]
    pub fn without(&self, others: &Self) -> Self {
        Self(std::array::from_fn(|kind| {
            self.0[kind].saturating_sub(others.0[kind])
        }))
    }
}

impl Index<StepKind> for Counts {
    type Output = u64;

    fn index(&self, kind: StepKind) -> &u64 {
        &self.0[kind as usize]
    }
}

/// Whether steps are counted in this thread.
#[inline]
#[must_use]
pub fn is_counting() -> bool {
    mode() == Mode::Counting
}

/// Counts steps of a kind, if steps are counted; a trace does not show them.
#[inline]
pub fn count(kind: StepKind, times: u64) {
    RECORDER.with(|recorder| {
        recorder.last.set(Some(kind));
        if recorder.mode.get() == Mode::Counting {
            let mut counts = recorder.counts.get();
            counts.0[kind as usize] += times;
            recorder.counts.set(counts);
        }
    });
}

/// Runs `task`, and returns its result and the steps of all its threads. It has as many threads
/// as without counting.
pub fn counted<T: Send>(task: impl FnOnce() -> T + Send) -> Result<(T, Counts), Error> {
    let start = || {
        RECORDER.with(|recorder| {
            recorder.counts.set(Counts::NONE);
            recorder.mode.set(Mode::Counting);
        });
    };
    let counts = || RECORDER.with(|recorder| recorder.counts.get());
    // Browsers have one thread.
    if cfg!(target_family = "wasm") {
        start();
        let result = task();
        RECORDER.with(|recorder| recorder.mode.set(Mode::Off));
        return Ok((result, counts()));
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(rayon::current_num_threads())
        .start_handler(move |_| start())
        .build()?;
    let result = pool.install(task);
    let of_threads = pool.broadcast(|_| counts());
    let sum = |kind| of_threads.iter().map(|counts| counts.0[kind]).sum();
    Ok((result, Counts(std::array::from_fn(sum))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_all_threads_are_counted_exactly() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(4).build();
        let task = || {
            rayon::scope(|scope| {
                for times in 0..100 {
                    scope.spawn(move |_| count(StepKind::Power, times));
                }
            });
            count(StepKind::ShadowRay, 1);
            "done"
        };
        let (result, counts) = pool.unwrap().install(|| counted(task)).unwrap();
        assert_eq!(result, "done");
        assert_eq!(counts[StepKind::Power], 99 * 100 / 2);
        assert_eq!(counts[StepKind::ShadowRay], 1);
        assert_eq!(counts[StepKind::CameraRay], 0);
    }

    #[test]
    fn steps_before_and_in_other_threads_are_not_counted() {
        let power = || count(StepKind::Power, 1);
        power();
        let other = std::thread::spawn(move || (0..1000).for_each(|_| power()));
        let (is_inside, counts) = counted(|| {
            power();
            is_counting()
        })
        .unwrap();
        other.join().unwrap();
        let counted_powers = counts[StepKind::Power];
        assert_eq!((counted_powers, is_inside, is_counting()), (1, true, false));
        assert_eq!(counted(|| ()).unwrap().1, Counts::NONE);
    }
}
