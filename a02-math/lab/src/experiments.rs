//! Error against the task's difficulty: angles and linear systems.
//!
//! The inputs are numbers with few binary digits, so that the solution is known
//! exactly and only the method rounds.

mod systems;
mod vectors;

use measure::Effort;
use measure::experiment::{Experiment, TaskSet};

pub use systems::refined;

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![vectors::angles(), systems::experiment()]
}

/// Random tasks for some numbers of bits, with a power of two as the parameter.
fn task_sets<T>(
    seed: u64,
    effort: Effort,
    bits: impl IntoIterator<Item = i32>,
    task: fn(&mut WholeNumbers, i32) -> T,
) -> Vec<TaskSet<T>> {
    let mut sets = Vec::new();
    for bits in bits {
        let mut numbers = WholeNumbers(seed);
        let count = effort.choose(4096, 65_536);
        sets.push(TaskSet {
            parameter: libm::scalbn(1.0, bits),
            tasks: (0..count).map(|_| task(&mut numbers, bits)).collect(),
        });
    }
    sets
}

/// Random whole numbers, the same in every run, from a linear congruential generator with
/// the multiplier of Knuth's MMIX.
struct WholeNumbers(u64);

impl WholeNumbers {
    /// A number between -2^bits and 2^bits, both excluded.
    fn signed(&mut self, bits: u32) -> f64 {
        const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
        const INCREMENT: u64 = 1_442_695_040_888_963_407;
        self.0 = self.0.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        // The high bits are the random ones.
        let number = (self.0 >> (63 - bits)) as i64 - (1 << bits);
        number.max(1 - (1 << bits)) as f64
    }
}
