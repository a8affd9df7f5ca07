//! Numbers in many bases, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(u32, u32) -> f64) {
    let large = [(1234, 10), (120, 10), (u32::MAX, 7)];
    check.compare(
        "{} in base {}",
        (0..6).map(|n| (n, 2)).chain(large),
        random(|r| {
            let bits = 1 + r.below(31);
            (r.below(1 << bits), 2 + r.below(35))
        }),
        [radical_inverse, yours],
        |radical_inverse, (n, base)| radical_inverse(n, base),
    );
    check.picture(|settings| {
        let mut image = Image::black(settings.size)?;
        let [width, height] = [settings.size.width(), settings.size.height()].map(f64::from);
        for n in 0..1500 {
            let (x, y) = (yours(n, 2) * width, yours(n, 3) * height);
            image.set(x as u32, y as u32, Color::WHITE);
        }
        Ok(image)
    });
}

variants! { check:
    yours => radical_inverse;
    right "a sum of fractions" => |mut n, base| {
        let (mut sum, mut place) = (0.0, 1.0);
        while n > 0 {
            place /= f64::from(base);
            sum += f64::from(n % base) * place;
            n /= base;
        }
        sum
    };
    wrong "digits stand behind the point, not before it" => |n, base| {
        radical_inverse(n, base) * f64::from(base)
    };
    wrong "the base need not be 2" => |n, _| radical_inverse(n, 2);
    wrong "all digits are mirrored, not the last alone" => |n, base| {
        f64::from(n % base) / f64::from(base)
    };
}
