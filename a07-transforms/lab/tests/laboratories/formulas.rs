//! The formulas that stage 4 measures are those of the renderer, and the exact ones are exact.

use a04_lab::exact::{self, triangle};
use a04_lab::experiments::far_sphere::{ours, queries};
use a04_lab::experiments::needle::needles;
use a04_lab::formula::sphere::{self, stable};
use a04_lab::formula::triangle::{fused, rounded, watertight};
use a04_lab::line::line;
use a04_lab::support::first;
use measure::exact::DoubleDouble as Number;

#[test]
fn the_stable_formula_is_that_of_the_renderer() {
    let mut hits = 0;
    for query in queries(64.0, 1000).iter() {
        assert_eq!(stable(query), ours(query), "{query:?}");
        hits += usize::from(ours(query).is_some());
    }
    assert!((600..800).contains(&hits), "{hits}");
}

#[test]
fn the_watertight_formula_is_that_of_the_renderer() {
    let mut hits = 0;
    for needle in needles(4096.0, 1024).iter() {
        let t = first(&needle.triangle, &needle.ray);
        let by_formula = watertight(&needle.corners, &needle.line, rounded);
        assert_eq!(by_formula, t, "{:?}", needle.ray);
        hits += usize::from(t.is_some());
    }
    assert!((450..550).contains(&hits), "{hits}");
}

/// `(1 + 2⁻³⁰)(1 - 2⁻³⁰) - 1 · 1` is `-2⁻⁶⁰`, and the rounded product is 1.
#[test]
fn errors_of_products_are_added_again() {
    let (a, b, least) = (
        1.0 + libm::exp2(-30.0),
        1.0 - libm::exp2(-30.0),
        libm::exp2(-60.0),
    );
    assert_eq!(rounded(a, b, 1.0, 1.0), 0.0);
    assert_eq!(fused(a, b, 1.0, 1.0), -least);
    assert_eq!(fused(1.0, 1.0, a, b), least);
}

/// A triangle of the condition 2, and its exact `t` in fractions.
/// Its aspect ratio of 7e6 costs the areas all digits but one, unless no product is rounded.
#[test]
fn a_needle_keeps_its_digits_by_exact_products() {
    let corners = [
        [
            -1.357_655_219_180_742_4e-5,
            -0.174_437_413_219_493_46,
            0.453_623_991_204_949_56,
        ],
        [
            -6.395_277_068_804_717e-5,
            -0.173_954_527_077_512_44,
            0.425_624_671_268_451_5,
        ],
        [
            -330.563_061_927_175_3,
            3_168.466_936_335_583_3,
            -183_727.691_847_281_36,
        ],
    ];
    let origin = [
        -14_069.511_146_510_215,
        -31_272.557_085_719_94,
        -70_657.075_328_031_47,
    ];
    let direction = [
        0.292_344_074_456_473_87,
        0.666_569_597_159_459_2,
        0.685_725_830_250_592_1,
    ];
    let line = line(origin, direction);
    let t = 47_893.817_032_311_57;
    let off = |found: Option<f64>| (found.unwrap() - t).abs() / t;
    assert!((0.06..0.07).contains(&off(watertight(&corners, &line, rounded))));
    let few = 4.0 * f64::EPSILON;
    assert!(off(watertight(&corners, &line, fused)) <= few);
}

/// The nearest double of the exact value, and the nearest double of the rest, by mpmath.
fn assert_exact(computed: Number, high: f64, low: f64) {
    assert_eq!(computed.value(), high);
    let rest = computed.error_of(high);
    let off = (rest + low).abs();
    assert!(off <= 1e-29 * high.abs(), "{rest:e}, not {low:e} below");
}

#[test]
fn a_distant_sphere_is_met_where_mpmath_says() {
    let hit = exact::sphere(&sphere::SphereQuery {
        center: [0.1, 0.2, 0.3],
        radius: 0.7,
        line: line([123_456_789.0, 0.3, 0.2], [-1.0, 1e-9, 2e-9]),
    });
    let [near, far] = hit.roots.unwrap();
    assert_exact(near, 123_456_788.253_097_03, -6.990_579_491_979_64e-9);
    assert_exact(far, 123_456_789.546_902_98, -5.964_917_363_200_716e-9);
    assert!((hit.distance - 0.267_425_757_636_574_4).abs() < 1e-16);
}

#[test]
fn needles_are_met_where_mpmath_says() {
    let b = [
        0.367_261_241_912_424_4,
        0.734_522_483_824_848_7,
        1.101_783_725_737_273_1,
    ];
    let c = [
        0.233_630_630_443_045_2,
        0.467_261_241_912_424_4,
        0.700_891_859_706_358_9,
    ];
    let corners = [[0.1, 0.2, 0.3], b, c];
    let hit = triangle(&corners, &line([1.5, 2.5, -3.5], [-1.1, -1.65, 4.4]));
    // An aspect ratio of 1e8 costs eight of the digits.
    let error = hit.t.error_of(1.056_511_056_519_799_3);
    let off = (error - 8.385_229_290_032_157e-17).abs();
    assert!(off < 1e-22, "{error:e}");
    assert!((hit.beta.value() - 2_136_675.135_227_814).abs() < 1e-8);
    assert!((hit.gamma.value() + 4_273_348.187_262_596).abs() < 1e-8);
}
