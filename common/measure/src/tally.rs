//! `tally`: how much work a rendering does, counted exactly.
//!
//! Counts, unlike times, are the same on every machine. Each thread counts for
//! itself, and only in the pool that [`counted`] makes: so what else runs at the
//! same time is not counted, and whoever does not ask pays one look at a flag.

use std::cell::Cell;
use std::ops::{Add, Index};

use common::Error;

/// A kind of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// A ray from the camera.
    PrimaryRay,
    /// A ray to a light, to see whether anything is in its way.
    ShadowRay,
    /// A ray that a surface mirrors.
    ReflectedRay,
    /// A question to a geometry whether a ray meets it. A node asks its children
    /// in turn.
    IntersectionTest,
    /// A ray moved into the space of a transformed object.
    MovedRay,
    /// A power, for a highlight.
    Power,
    /// A random number, for the place of a sample.
    RandomNumber,
}

impl Work {
    /// All kinds.
    pub const ALL: [Self; 7] = [
        Self::PrimaryRay,
        Self::ShadowRay,
        Self::ReflectedRay,
        Self::IntersectionTest,
        Self::MovedRay,
        Self::Power,
        Self::RandomNumber,
    ];

    /// The kind as a reader knows it, in the plural.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::PrimaryRay => "primary rays",
            Self::ShadowRay => "shadow rays",
            Self::ReflectedRay => "reflected rays",
            Self::IntersectionTest => "intersection tests",
            Self::MovedRay => "moved rays",
            Self::Power => "powers",
            Self::RandomNumber => "random numbers",
        }
    }
}

/// How often each kind of work was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally([u64; Work::ALL.len()]);

impl Index<Work> for Tally {
    type Output = u64;

    fn index(&self, work: Work) -> &u64 {
        &self.0[work as usize]
    }
}

impl Add for Tally {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

thread_local! {
    static IS_ON: Cell<bool> = const { Cell::new(false) };
    static TALLY: Cell<Tally> = const { Cell::new(Tally([0; Work::ALL.len()])) };
}

/// Whether work is counted in this thread.
#[inline]
#[must_use]
pub fn is_on() -> bool {
    IS_ON.get()
}

/// Notes that work was done once.
#[inline]
pub fn count(work: Work) {
    count_all(work, 1);
}

/// Notes that work was done so many times.
#[inline]
pub fn count_all(work: Work, times: u64) {
    if IS_ON.get() {
        let mut tally = TALLY.get();
        tally.0[work as usize] += times;
        TALLY.set(tally);
    }
}

/// What `task` returns, and the work that it did: itself and in parallel, on as
/// many threads as it would have had uncounted.
pub fn counted<T: Send>(task: impl FnOnce() -> T + Send) -> Result<(T, Tally), Error> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(rayon::current_num_threads())
        .start_handler(|_| IS_ON.set(true))
        .build()?;
    let result = pool.install(task);
    let tallies = pool.broadcast(|_| TALLY.get());
    let total = tallies.into_iter().fold(Tally::default(), Add::add);
    Ok((result, total))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_of_all_threads_is_counted_exactly() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(4).build();
        let task = || {
            rayon::scope(|scope| {
                for times in 0..100 {
                    scope.spawn(move |_| count_all(Work::Power, times));
                }
            });
            count(Work::ShadowRay);
            "done"
        };
        let (result, tally) = pool.unwrap().install(|| counted(task)).unwrap();
        assert_eq!(result, "done");
        assert_eq!(tally[Work::Power], 99 * 100 / 2);
        assert_eq!(tally[Work::ShadowRay], 1);
        assert_eq!(tally[Work::PrimaryRay], 0);
    }

    #[test]
    fn what_runs_beside_or_before_is_not_counted() {
        count(Work::Power);
        let beside = std::thread::spawn(|| (0..1000).for_each(|_| count(Work::Power)));
        let ((), tally) = counted(|| count(Work::Power)).unwrap();
        beside.join().unwrap();
        assert_eq!(tally[Work::Power], 1);
        assert_eq!(counted(|| ()).unwrap().1, Tally::default());
    }

    #[test]
    fn only_what_is_counted_knows_of_it() {
        assert!(!is_on());
        let (inside, _) = counted(is_on).unwrap();
        assert!(inside && !is_on());
    }
}
