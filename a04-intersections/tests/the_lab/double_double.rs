//! Arithmetic with 31 digits.

use a04_intersections::lab::exact::DoubleDouble;

fn power_of_two(exponent: i32) -> f64 {
    libm::scalbn(1.0, exponent)
}

fn sum(high: f64, low: f64) -> DoubleDouble {
    DoubleDouble::from(high) + DoubleDouble::from(low)
}

/// 1 + 2^-54 and -1 + 2^-107: the rest lies 107 binary digits below.
#[test]
fn sums_that_cancel_keep_their_last_digit() {
    let (small, smallest) = (power_of_two(-54), power_of_two(-107));
    let rest = sum(1.0, small) + sum(-1.0, smallest);
    assert_eq!(rest, sum(small, smallest));
    assert_eq!(rest.error_of(small), -smallest);
    let rest = sum(1.0, small) - sum(1.0, smallest);
    assert_eq!(rest.error_of(small), smallest);
}

/// The products have few digits and are exact.
#[test]
fn what_was_multiplied_by_can_be_divided_out() {
    for digit in [54, 60, 70, 90] {
        let number = sum(1.0, power_of_two(-digit));
        for factor in [3.0, 5.0, 7.0, 0.1875, 10.0, -1e3] {
            let factor = DoubleDouble::from(factor);
            assert_eq!(number * factor / factor, number);
        }
    }
}

/// 0.01 0101.. in binary, without end: of 1/3 no more than 106 digits fit.
#[test]
fn quotients_are_right_to_the_last_of_106_digits() {
    for divisor in [3.0, 7.0, 11.0, 49.0, 1e6 + 3.0] {
        let divisor = DoubleDouble::from(divisor);
        let quotient = DoubleDouble::from(1.0) / divisor;
        let rest = DoubleDouble::from(1.0) - quotient * divisor;
        assert!(rest.value().abs() <= power_of_two(-104), "{rest:?}");
    }
}
