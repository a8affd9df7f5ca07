//! Fractions whose digits are known.

use common::{Color, Image};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, inverse: impl Fn(u32, u32) -> f64) {
    let mut of = |n: u32, base: u32, exact: f64| {
        let what = format!("{n} in base {base}");
        check.expect(what, exact, Bound::Ulps(1.0), inverse(n, base));
    };
    for (n, eighths) in (0..).zip([0.0, 4.0, 2.0, 6.0, 1.0, 5.0, 3.0, 7.0]) {
        of(n, 2, eighths / 8.0);
    }
    for (n, ninths) in (0..).zip([0.0, 3.0, 6.0, 1.0, 4.0, 7.0, 2.0, 5.0, 8.0]) {
        of(n, 3, ninths / 9.0);
    }
    of(1234, 10, 0.4321);
    of(100, 10, 0.001);
    of(120, 10, 0.021);
    of(7 * 11 + 4, 11, 51.0 / 121.0);
    of(1 << 31, 2, 1.0 / 4_294_967_296.0);
    of(u32::MAX, 2, 4_294_967_295.0 / 4_294_967_296.0);
    of(u32::MAX, 7, fraction(&digits(u32::MAX, 7), 7));

    let mut random = Random::new(3);
    for _ in 0..60 {
        let base = 2 + random.below(35);
        let bits = 1 + random.below(31);
        let n = random.below(1 << bits);
        of(n, base, fraction(&digits(n, base), base));
    }

    check.picture(|settings| {
        let mut image = Image::black(settings.size)?;
        let (width, height) = (settings.size.width(), settings.size.height());
        for n in 0..1500 {
            let place = |share: f64, length: u32| (share * f64::from(length)) as u32;
            let (x, y) = (place(inverse(n, 2), width), place(inverse(n, 3), height));
            image.set(x, y, Color::WHITE);
        }
        Ok(image)
    });
}

/// The digits, the last first.
fn digits(n: u32, base: u32) -> Vec<u32> {
    let remaining = std::iter::successors(Some(n), |n| Some(n / base));
    let digits = remaining.take_while(|&n| n > 0).map(|n| n % base);
    digits.collect()
}

/// The fraction of these digits behind the point: numerator and denominator are exact.
fn fraction(digits: &[u32], base: u32) -> f64 {
    let base = u128::from(base);
    let whole = digits
        .iter()
        .fold(0, |whole, &digit| whole * base + u128::from(digit));
    whole as f64 / base.pow(digits.len() as u32) as f64
}
