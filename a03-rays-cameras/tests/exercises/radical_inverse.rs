//! Numbers in many bases, compared with the solution.

use crate::prelude::*;
use crate::solutions::radical_inverse::radical_inverse as solution;

pub fn check(check: &mut Check, inverse: impl Fn(u32, u32) -> f64) {
    let counted = (0..6)
        .map(|n| (n, 2))
        .chain([(7, 3), (1234, 10), (120, 10), (u32::MAX, 7)]);
    check.compare(
        "{} in base {}",
        counted,
        random(|r| {
            let bits = 1 + r.below(31);
            (r.below(1 << bits), 2 + r.below(35))
        }),
        |(n, base)| solution(n, base),
        |(n, base)| inverse(n, base),
    );
    check.picture(|settings| {
        let mut image = Image::black(settings.size)?;
        let (width, height) = (settings.size.width(), settings.size.height());
        for n in 0..1500 {
            let place = |part: f64, length: u32| (part * f64::from(length)) as u32;
            let (x, y) = (place(inverse(n, 2), width), place(inverse(n, 3), height));
            image.set(x, y, Color::WHITE);
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
    wrong("mirrored in 32 bits, the number overflows", |c| {
        check(c, |mut n, base| {
            let (mut mirrored, mut scale) = (0_u32, 1_u32);
            while n > 0 {
                mirrored = mirrored.wrapping_mul(base).wrapping_add(n % base);
                (n, scale) = (n / base, scale.wrapping_mul(base));
            }
            f64::from(mirrored) / f64::from(scale)
        });
    }),
];
