//! The images of a lamp in two mirrors, which stand at `2 k width ± lamp`.

use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, images: impl Fn(f64, f64, u32) -> [f64; 2]) {
    let mut case = |width: f64, lamp: f64, n: u32, exact: [f64; 2]| {
        let got = images(width, lamp, n);
        for (side, exact, got) in [("left", exact[0], got[0]), ("right", exact[1], got[1])] {
            let what =
                format!("mirrors {width} apart, lamp at {lamp}, image {n} in the {side} one");
            check.expect(what, exact, Bound::Equal, got);
        }
    };
    case(10.0, 3.0, 0, [3.0, 3.0]);
    case(10.0, 3.0, 1, [-3.0, 17.0]);
    case(10.0, 3.0, 2, [-17.0, 23.0]);
    case(10.0, 3.0, 3, [-23.0, 37.0]);
    case(10.0, 3.0, 4, [-37.0, 43.0]);
    for (width, lamp) in [(8.0, 1.0), (2.0, 2.0), (4.0, 0.5)] {
        for k in 1..6 {
            let far = 2.0 * f64::from(k) * width;
            case(width, lamp, 2 * k, [lamp - far, lamp + far]);
            let before = far - 2.0 * width;
            case(width, lamp, 2 * k - 1, [-before - lamp, far - lamp]);
        }
    }
    let mut random = Random::new(2);
    for k in (1..20).cycle().take(40) {
        // In quarters, so that sums are exact.
        let width = f64::from(4 + random.below(100)) / 4.0;
        let lamp = width * f64::from(random.below(5)) / 4.0;
        let far = 2.0 * f64::from(k) * width;
        case(width, lamp, 2 * k, [lamp - far, lamp + far]);
        let before = far - 2.0 * width;
        case(width, lamp, 2 * k - 1, [-before - lamp, far - lamp]);
    }
}
