//! `level`: the instructions that a renderer uses.
//!
//! They are chosen when the program runs, so that one build is fast on each processor. On x86-64 they
//! are AVX2, or else SSE2, which every such processor has; elsewhere there is one choice. A build for
//! development has SSE2 alone, as `build.rs` says.

use std::cell::Cell;

pub use fearless_simd::Level;

thread_local! {
    static IS_LOWERED: Cell<bool> = const { Cell::new(false) };
}

/// Whether this build has the instructions of one level alone.
pub const HAS_ONE: bool = cfg!(one_level);

/// The level of a new renderer: the best of this build and processor, unless [`at_each_level`] lowers it.
pub fn level() -> Level {
    if HAS_ONE || IS_LOWERED.get() {
        Level::baseline()
    } else {
        Level::new()
    }
}

/// The results of a function that renders, with the instructions of each level that this build has. It has
/// to make its renderers on this thread. For tests, which compare the results.
pub fn at_each_level<T>(render: impl Fn() -> T) -> Vec<T> {
    let mut results = vec![render()];
    if !HAS_ONE {
        IS_LOWERED.set(true);
        results.push(render());
        IS_LOWERED.set(false);
    }
    results
}

/// The instructions of the baseline, for tests of functions on lanes.
#[cfg(test)]
pub fn baseline() -> impl fearless_simd::Simd {
    let level = Level::baseline();
    #[cfg(target_arch = "x86_64")]
    return level.as_sse2().unwrap();
    #[cfg(target_arch = "aarch64")]
    return level.as_neon().unwrap();
}
