//! `level`: the instructions that a renderer uses.
//!
//! They are chosen when the program runs, so that one build is fast on each processor. On x86-64 they
//! are AVX2, or else SSE2, which every such processor has; elsewhere there is one choice. The code of
//! each is compiled once more.

use std::cell::Cell;

pub use fearless_simd::Level;

thread_local! {
    static IS_LOWERED: Cell<bool> = const { Cell::new(false) };
}

/// The level of a new renderer: the best of this processor, unless it is made in [`at_baseline`].
pub fn level() -> Level {
    if IS_LOWERED.get() {
        Level::baseline()
    } else {
        Level::new()
    }
}

/// Calls a function that renders. Renderers which it makes on this thread use only the instructions that
/// each processor of this kind has: for tests, which compare them with the best of this processor.
pub fn at_baseline<T>(render: impl FnOnce() -> T) -> T {
    let before = IS_LOWERED.replace(true);
    let result = render();
    IS_LOWERED.set(before);
    result
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
