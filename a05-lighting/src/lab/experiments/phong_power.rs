//! Methods to raise a cosine to a power.
//!
//! Rounding the cosine changes its P-th power by the relative error eps P / 4,
//! even if the power is exact; only methods that use 1 - cosine can do better.

use std::rc::Rc;

use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Slope, Unit};

use crate::power::squaring;

/// Exponents P with the powers `(1 - d)^P` of eight numbers `d`, computed with
/// 600 bits and rounded: see [`distances`].
const EXACT: [(f64, [f64; 8]); 5] = [
    (
        1e2,
        [
            0.882_427_902_703_529_6,
            0.686_804_987_688_548_1,
            0.534_212_648_374_683_7,
            0.415_259_935_880_696_2,
            0.322_589_071_549_976_35,
            0.250_438_804_377_180_36,
            0.194_300_776_724_805_53,
            0.150_649_250_496_110_58,
        ],
    ),
    (
        1e4,
        [
            0.882_496_213_128_414_1,
            0.687_284_446_184_404_9,
            0.535_250_973_860_698_1,
            0.416_846_061_053_851,
            0.324_631_922_053_560_56,
            0.252_815_693_500_411,
            0.196_885_675_609_333_62,
            0.153_328_008_916_787_66,
        ],
    ),
    (
        1e6,
        [
            0.882_496_895_690_087_8,
            0.687_289_230_465_934_4,
            0.535_261_323_975_709_1,
            0.416_861_860_098_453_94,
            0.324_652_261_914_121_17,
            0.252_839_356_792_21,
            0.196_911_415_219_137_88,
            0.153_354_697_275_550_76,
        ],
    ),
    (
        1e9,
        [
            0.882_496_902_577_700_9,
            0.687_289_278_742_647_2,
            0.535_261_428_414_447,
            0.416_862_019_518_928_43,
            0.324_652_467_152_905_63,
            0.252_839_595_565_734_1,
            0.196_911_674_944_209_08,
            0.153_354_966_575_359_21,
        ],
    ),
    (
        1e12,
        [
            0.882_496_902_584_588_5,
            0.687_289_278_790_923_8,
            0.535_261_428_518_885_7,
            0.416_862_019_678_348_8,
            0.324_652_467_358_144_3,
            0.252_839_595_804_507_43,
            0.196_911_675_203_934_04,
            0.153_354_966_844_658_9,
        ],
    ),
];

/// The numbers `d = 1 - cosine`: 1/8, 3/8 ... 15/8 of 1/P.
fn distances(exponent: f64) -> [f64; 8] {
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|j: f64| (j + 0.5) / 4.0 / exponent)
}

/// A power of `1 - d`.
type Power = fn(d: f64, exponent: f64) -> f64;

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "phong-power",
        about: "How exact is the power of a highlight, and what does it cost?",
        knob: "exponent",
        work: "powers",
        error: "rms error of the power",
        unit: Unit::Other("share of it"),
        exact: "against powers of 600 bits",
        seeds: &[],
        against: Axis::Knob,
        curves: Box::new(|effort: Effort| {
            let count = effort.choose(4_096, 65_536);
            let point = |power: Power, (exponent, exact): (f64, [f64; 8])| {
                let distances = distances(exponent);
                let error = |(d, exact): (&f64, &f64)| (power(*d, exponent) - exact) / exact;
                let errors: Vec<_> = distances.iter().zip(&exact).map(error).collect();
                let inputs: Rc<[f64]> = distances.into_iter().cycle().take(count).collect();
                Point::new(exponent, count as f64, errors, move || {
                    inputs.iter().map(|d| power(*d, exponent)).sum()
                })
            };
            let curve = |method, remark, expected: Option<f64>, power: Power| Curve {
                method,
                remark,
                slope: expected.map(|expected| Slope {
                    expected,
                    tolerance: 0.05,
                    between: (1e2, 1e12),
                }),
                points: EXACT.map(|exact| point(power, exact)).into(),
            };
            vec![
                curve(
                    "libm::pow",
                    "the renderer's, unless the exponent is small and whole",
                    Some(1.0),
                    |d, p| libm::pow(1.0 - d, p),
                ),
                curve(
                    "repeated squaring",
                    "the renderer's up to the exponent 1024, if it is whole",
                    Some(1.0),
                    |d, p| squaring(1.0 - d, p as u64),
                ),
                curve(
                    "exp(P ln1p(-d))",
                    "not in the renderer, though cheaper: the course's formula has e · r and not \
                     d = |e - r|² / 2, and below P = 1e9 nobody sees the difference",
                    None,
                    |d, p| libm::exp(p * libm::log1p(-d)),
                ),
            ]
        }),
    }
}
