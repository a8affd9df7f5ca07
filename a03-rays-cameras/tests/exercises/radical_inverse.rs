//! Numbers in many bases, compared with the solution.

use crate::prelude::*;
use crate::solutions::radical_inverse::radical_inverse as solution;

pub fn check(check: &mut Check, inverse: impl Fn(u32, u32) -> f64) {
    let large = [(1234, 10), (120, 10), (u32::MAX, 7)];
    check.compare(
        "{} in base {}",
        (0..6).map(|n| (n, 2)).chain(large),
        random(|r| {
            let bits = 1 + r.below(31);
            (r.below(1 << bits), 2 + r.below(35))
        }),
        |(n, base)| solution(n, base),
        |(n, base)| inverse(n, base),
    );
    check.picture(|settings| {
        let mut image = Image::black(settings.size)?;
        let [width, height] = [settings.size.width(), settings.size.height()].map(f64::from);
        for n in 0..1500 {
            let (x, y) = (inverse(n, 2) * width, inverse(n, 3) * height);
            image.set(x as u32, y as u32, Color::WHITE);
        }
        Ok(image)
    });
}

pub const VARIANTS: &[Variant] = &[
    right("a sum of fractions", |c| {
        check(c, |mut n, base| {
            let (mut sum, mut place) = (0.0, 1.0);
            while n > 0 {
                place /= f64::from(base);
                sum += f64::from(n % base) * place;
                n /= base;
            }
            sum
        });
    }),
    wrong("digits stand behind the point, not before it", |c| {
        check(c, |n, base| solution(n, base) * f64::from(base));
    }),
    wrong("the base need not be 2", |c| {
        check(c, |n, _| solution(n, 2))
    }),
    wrong("all digits are mirrored, not the last alone", |c| {
        check(c, |n, base| f64::from(n % base) / f64::from(base));
    }),
];
