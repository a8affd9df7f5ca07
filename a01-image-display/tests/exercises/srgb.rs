//! Values whose power is a product: with u^12 of light, u^12 to the power of
//! 1 / 2.4 is u^5.

use common::{Color, Image};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

/// Some roundings of numbers up to 1, the power's among them.
const BOUND: Bound = Bound::Absolute(1e-14);

pub fn check(
    check: &mut Check,
    encode: impl Fn(f64) -> f64 + Copy,
    decode: impl Fn(f64) -> f64 + Copy,
) {
    let product = |u: f64, n: usize| std::iter::repeat_n(u, n).product::<f64>();
    let mut random = Random::new(2);
    let mut both = |part: &str, linear: f64, value: f64| {
        let what = format!("the value of sRGB for {linear} of light, {part}");
        check.expect(what, value, BOUND, encode(linear));
        let what = format!("the light of the value {value}, {part}");
        check.expect(what, linear, BOUND, decode(value));
    };
    both("the end", 1.0, 1.0);
    both("the start", 0.0, 0.0);
    // The least is just above the border, 0.6185^12 being 0.003134.
    let curved = [0.9, 0.75, 0.7, 0.62, 0.6185];
    let more = std::iter::repeat_with(|| random.between(0.62, 0.99)).take(30);
    for u in curved.into_iter().chain(more) {
        both(
            "on the curve",
            product(u, 12),
            1.055 * product(u, 5) - 0.055,
        );
    }
    // The straight part ends at 0.0031308.
    for linear in [0.001, 0.002, 0.003, 0.003_13, 0.003_130_799] {
        both("on the straight part", linear, 12.92 * linear);
    }
    let what = "the value of sRGB at the border, 0.0031308 of light";
    check.expect(what, 0.040_449_936, BOUND, encode(0.003_130_8));

    let byte = |value: f64| usize::from(Color::gray(value).to_bytes()[0]);
    let mut changed: usize = 0;
    for n in 0..=255_u8 {
        let there_and_back = encode(decode(f64::from(n) / 255.0));
        changed += usize::from(byte(there_and_back) != usize::from(n));
    }
    let what = "bytes that change on the way to light and back";
    check.expect(what, 0, Bound::Equal, changed);
    // IEC 61966-2-1 makes 0.7354 of half the light.
    let half = byte(encode(0.5));
    check.expect("the byte of half the light", 188, Bound::Equal, half);

    check.picture(|settings| {
        let (width, height) = (settings.size.width(), settings.size.height());
        Image::from_fn(settings.size, |x, y| {
            let share = f64::from(x * 8 / width) / 7.0;
            let stripes = Color::gray(f64::from(y % 2));
            match y * 3 / height {
                0 => Color::gray(share),
                1 => Color::gray(encode(share)),
                _ if x * 3 / width == 1 => stripes,
                _ => Color::gray(encode(0.5)),
            }
        })
    });
}
