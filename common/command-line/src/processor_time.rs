//! `processor_time`: the time that the processors have worked for this program.
//!
//! Other programs that run at the same time lengthen it far less than the time of the day. Work that
//! two threads share counts twice.

/// The seconds of all threads since the program has begun.
#[cfg(target_os = "linux")]
#[must_use]
pub fn processor_time() -> f64 {
    use rustix::time::{ClockId, clock_gettime};

    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// The seconds since the first call: the standard library has no clock for the processors.
#[cfg(not(target_os = "linux"))]
#[must_use]
pub fn processor_time() -> f64 {
    use std::sync::LazyLock;
    use std::time::Instant;

    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}
