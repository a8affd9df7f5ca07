//! Fractions whose digits are known.

use common::{Color, Image};
use measure::extremes::Bound;
use testing::exercise::Check;

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
