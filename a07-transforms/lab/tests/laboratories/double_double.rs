//! Arithmetic with 106 binary digits, by which stage 2 measures sums and products.

use measure::exact::DoubleDouble;

/// 1 + 2^-54 and -1 + 2^-107: the rest lies 107 binary digits below.
#[test]
fn sums_that_cancel_keep_their_last_digit() {
    let power_of_two = |exponent| libm::scalbn(1.0, exponent);
    let sum = |high: f64, low: f64| DoubleDouble::from(high) + DoubleDouble::from(low);
    let (small, smallest) = (power_of_two(-54), power_of_two(-107));
    let rest = sum(1.0, small) + sum(-1.0, smallest);
    assert_eq!(rest, sum(small, smallest));
    assert_eq!(rest.error_of(small), -smallest);
    let rest = sum(1.0, small) - sum(1.0, smallest);
    assert_eq!(rest.error_of(small), smallest);
}

/// 0.01 0101.. in binary, without end: of 1/3 no more than 106 digits fit.
#[test]
fn quotients_are_right_to_the_last_of_106_digits() {
    for divisor in [3.0, 7.0, 11.0, 49.0, 1e6 + 3.0] {
        let divisor = DoubleDouble::from(divisor);
        let quotient = DoubleDouble::from(1.0) / divisor;
        let rest = DoubleDouble::from(1.0) - quotient * divisor;
        assert!(rest.value().abs() <= libm::scalbn(1.0, -104), "{rest:?}");
    }
}

/// 1 / 1e-310 is beyond all doubles.
#[test]
fn a_quotient_that_overflows_is_infinite() {
    for (sign, expected) in [(1.0, f64::INFINITY), (-1.0, f64::NEG_INFINITY)] {
        let quotient = DoubleDouble::from(sign) / DoubleDouble::from(1e-310);
        assert_eq!(quotient.value(), expected);
    }
}
