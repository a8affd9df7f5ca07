//! Light and values on both parts of the curve, compared with the solution.

use crate::prelude::*;
use crate::solutions::srgb::{decode as light, encode as value};

pub fn check(check: &mut Check, encode: fn(f64) -> f64, decode: fn(f64) -> f64) {
    // Above and below the border between both parts.
    let inputs = || random(|r| r.between(0.0, 1.0) * [1.0, 0.01][r.below(2) as usize]);
    let simple = [1.0, 0.0, 0.5, 0.02, 0.002];
    check.compare("the light {}", simple, inputs(), [value, encode], |f, x| {
        f(x)
    });
    check.compare("the value {}", simple, inputs(), [light, decode], |f, x| {
        f(x)
    });
    check.picture(|settings| {
        let (width, height) = (settings.size.width(), settings.size.height());
        Image::from_fn(settings.size, |x, y| {
            let share = f64::from(x * 8 / width) / 7.0;
            Color::gray(match y * 3 / height {
                0 => share,
                1 => encode(share),
                _ if x * 3 / width == 1 => f64::from(y % 2),
                _ => encode(0.5),
            })
        })
    });
}

variants! { check:
    yours => encode, decode;
    wrong "the curve is near to a power of 2.2, but another" => |x| libm::pow(x, 1.0 / 2.2), |v| {
        libm::pow(v, 2.2)
    };
    wrong "near black the curve is a straight line" => |x| curve_from(-1.0, x), light;
    wrong "light and values have different borders" => |x| curve_from(0.040_45, x), light;
}

/// The value where the curve begins at this light.
fn curve_from(border: f64, linear: f64) -> f64 {
    if linear <= border {
        12.92 * linear
    } else {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    }
}
