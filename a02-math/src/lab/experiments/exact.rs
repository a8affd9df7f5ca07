//! Products and sums with their rounding errors, and random whole numbers.

/// The rounded product and its rounding error (Dekker: A Floating-Point
/// Technique for Extending the Available Precision, 1971).
fn product(a: f64, b: f64) -> (f64, f64) {
    let halves = |x: f64| {
        let shifted = x * 134_217_729.0; // 2^27 + 1
        let high = shifted - (shifted - x);
        (high, x - high)
    };
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    let rounded = a * b;
    let lost = ((a_high * b_high - rounded) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (rounded, lost)
}

/// The rounded sum and its rounding error (Knuth: The Art of Computer
/// Programming, volume 2, 4.2.2).
fn sum(a: f64, b: f64) -> (f64, f64) {
    let rounded = a + b;
    let b_part = rounded - a;
    (rounded, (a - (rounded - b_part)) + (b - b_part))
}

/// The sum of products, rounded as if computed with twice the digits (Ogita,
/// Rump, Oishi: Accurate Sum and Dot Product, 2005).
pub fn sum_of_products(pairs: &[(f64, f64)]) -> f64 {
    let (mut total, mut lost) = (0.0, 0.0);
    for (a, b) in pairs {
        let (rounded, of_product) = product(*a, *b);
        let (next, of_sum) = sum(total, rounded);
        total = next;
        lost += of_product + of_sum;
    }
    total + lost
}

/// Random whole numbers from a linear congruential generator with the
/// multiplier of Knuth's MMIX.
pub struct WholeNumbers(u64);

impl WholeNumbers {
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number between -2^bits and 2^bits, both excluded.
    pub fn signed(&mut self, bits: u32) -> f64 {
        const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
        const INCREMENT: u64 = 1_442_695_040_888_963_407;
        self.0 = self.0.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        // The high bits are the random ones.
        let number = (self.0 >> (63 - bits)) as i64 - (1 << bits);
        number.max(1 - (1 << bits)) as f64
    }
}
