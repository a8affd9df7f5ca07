//! `tally`: how much work a rendering does, counted exactly.
//!
//! Counts, unlike times, are the same on every machine. Each thread has its own
//! counts, and only the threads of the pool that [`counted`] makes count at all. So
//! other work at the same time is not counted. When counting is off, the cost is one
//! test of a flag.

use std::cell::Cell;
use std::ops::Index;

use crate::Error;

/// A kind of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// A ray from the camera.
    PrimaryRay,
    /// A ray to a light, to see whether anything is in its way.
    ShadowRay,
    /// A ray that a surface mirrors.
    ReflectedRay,
    /// A test of a geometry for a hit. A node tests its children in turn.
    IntersectionTest,
    /// A ray transformed into the space of an object.
    MovedRay,
    /// A power, for a highlight.
    Power,
    /// A random number, for the place of a sample.
    RandomNumber,
}

impl Work {
    /// All kinds, with their names for a reader, in the plural, and the reason why a renderer
    /// may do less of this work without a change of the picture.
    pub const ALL: [(Self, &str, &str); 7] = [
        (
            Self::PrimaryRay,
            "primary rays",
            "where samples agree, more of them change no more than the allowed error",
        ),
        (
            Self::ShadowRay,
            "shadow rays",
            "light from behind a surface, light on a single colour and light without shadows need none",
        ),
        (
            Self::ReflectedRay,
            "reflected rays",
            "a surface that does not mirror multiplies their colour by 0",
        ),
        (
            Self::IntersectionTest,
            "intersection tests",
            "a ray that is not sent needs none, one occluder casts a shadow as well as two, and a \
             tree of bounding boxes (--fast) shows which objects a ray cannot hit",
        ),
        (
            Self::MovedRay,
            "moved rays",
            "a ray that is not sent, or misses the bounds of an object (--fast), is not transformed",
        ),
        (
            Self::Power,
            "powers",
            "a black highlight and light mirrored away from the eye are not seen",
        ),
        (
            Self::RandomNumber,
            "random numbers",
            "a sample with a fixed place needs none",
        ),
    ];
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

/// Counts one piece of work.
#[inline]
pub fn count(work: Work) {
    count_all(work, 1);
}

/// Counts `times` pieces of work.
#[inline]
pub fn count_all(work: Work, times: u64) {
    if IS_ON.get() {
        let mut tally = TALLY.get();
        tally.0[work as usize] += times;
        TALLY.set(tally);
    }
}

/// Runs `task`, and returns its result and the work of all its threads. It has as
/// many threads as without counting.
pub fn counted<T: Send>(task: impl FnOnce() -> T + Send) -> Result<(T, Tally), Error> {
    // Browsers have one thread.
    if cfg!(target_family = "wasm") {
        TALLY.set(Tally::default());
        IS_ON.set(true);
        let result = task();
        IS_ON.set(false);
        return Ok((result, TALLY.get()));
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(rayon::current_num_threads())
        .start_handler(|_| IS_ON.set(true))
        .build()?;
    let result = pool.install(task);
    let tallies = pool.broadcast(|_| TALLY.get());
    let sum = |work| tallies.iter().map(|tally| tally.0[work]).sum();
    Ok((result, Tally(std::array::from_fn(sum))))
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
    fn work_before_and_in_other_threads_is_not_counted() {
        count(Work::Power);
        let other = std::thread::spawn(|| (0..1000).for_each(|_| count(Work::Power)));
        let (is_inside, tally) = counted(|| {
            count(Work::Power);
            is_on()
        })
        .unwrap();
        other.join().unwrap();
        assert_eq!((tally[Work::Power], is_inside, is_on()), (1, true, false));
        assert_eq!(counted(|| ()).unwrap().1, Tally::default());
    }
}
