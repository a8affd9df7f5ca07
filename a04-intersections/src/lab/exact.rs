//! Where rays meet shapes, to about 30 digits of what the given doubles say:
//! the reference that formulas in doubles are held against.
//!
//! The tests compare it with values of mpmath at 200 digits.

mod double_double;

pub use double_double::{DoubleDouble, product_with_error, sum_with_error};

use DoubleDouble as Number;

/// The exact difference of two triples.
fn difference(a: &[f64; 3], b: &[f64; 3]) -> [Number; 3] {
    std::array::from_fn(|i| Number::from(a[i]) - Number::from(b[i]))
}

fn dot(a: &[Number; 3], b: &[Number; 3]) -> Number {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[Number; 3], b: &[Number; 3]) -> [Number; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// A ray and a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereMeeting {
    /// How near the ray comes to the centre.
    pub distance: f64,
    /// Both roots, in order, if there are any.
    pub roots: Option<[Number; 2]>,
}

/// Where the ray `o + t d` meets the sphere around `c` of radius `r`.
pub fn sphere(c: &[f64; 3], r: f64, o: &[f64; 3], d: &[f64; 3]) -> SphereMeeting {
    let (f, d) = (difference(o, c), d.map(Number::from));
    let a = dot(&d, &d);
    let middle = -dot(&f, &d) / a;
    let l = std::array::from_fn(|i| f[i] + d[i] * middle);
    let beside = dot(&l, &l);
    let discriminant = Number::from(r) * Number::from(r) - beside;
    let roots = (discriminant.value() >= 0.0).then(|| {
        let half = (discriminant / a).sqrt();
        [middle - half, middle + half]
    });
    SphereMeeting {
        distance: beside.sqrt().value(),
        roots,
    }
}

/// Where the ray `o + t d` meets the plane through `a` perpendicular to `n`.
pub fn plane(a: &[f64; 3], n: &[f64; 3], o: &[f64; 3], d: &[f64; 3]) -> Number {
    let n = n.map(Number::from);
    dot(&difference(a, o), &n) / dot(&d.map(Number::from), &n)
}

/// `t`, β and γ of where the ray `o + t d` meets the plane of a triangle.
pub fn triangle([a, b, c]: &[[f64; 3]; 3], o: &[f64; 3], d: &[f64; 3]) -> [Number; 3] {
    let [ab, ac, ao] = [b, c, o].map(|point| difference(point, a));
    let d = d.map(Number::from);
    let (across, moment) = (cross(&d, &ac), cross(&ao, &ab));
    let determinant = dot(&ab, &across);
    [dot(&ac, &moment), dot(&ao, &across), dot(&d, &moment)].map(|x| x / determinant)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest double of the exact value and that of the rest, by mpmath.
    fn assert_exact(computed: Number, high: f64, low: f64) {
        assert_eq!(computed.value(), high);
        let rest = computed.error_of(high);
        assert!(
            (rest + low).abs() <= 1e-29 * high.abs(),
            "{rest:e}, not {:e}",
            -low
        );
    }

    #[test]
    fn a_distant_sphere_is_met_where_mpmath_says() {
        let (o, d) = ([123_456_789.0, 0.3, 0.2], [-1.0, 1e-9, 2e-9]);
        let meeting = sphere(&[0.1, 0.2, 0.3], 0.7, &o, &d);
        let [near, far] = meeting.roots.unwrap();
        assert_exact(near, 123_456_788.253_097_03, -6.990_579_491_979_64e-9);
        assert_exact(far, 123_456_789.546_902_98, -5.964_917_363_200_716e-9);
        assert!((meeting.distance - 0.267_425_757_636_574_4).abs() < 1e-16);
    }

    #[test]
    fn a_huge_sphere_is_met_where_mpmath_says() {
        let (o, d) = ([0.3, 1.1, 0.7], [0.1, -1.0, 0.2]);
        let [near, _] = sphere(&[0.0, -1e6, 0.0], 1e6, &o, &d).roots.unwrap();
        let error = near.error_of(1.100_000_507_250_114_2);
        // The cancellation of 1e6 costs six of the digits.
        assert!(
            (error - 3.139_038_135_339_884_2e-18).abs() < 1e-24,
            "{error:e}"
        );
    }

    #[test]
    fn planes_and_needles_are_met_where_mpmath_says() {
        let (o, d) = ([1.1, 2.2, 3.3], [-0.3, -0.2, -0.9]);
        let t = plane(&[3e6, 0.1, -1e6], &[0.3, 0.5, 0.7], &o, &d);
        assert_exact(t, -243_897.939_024_390_27, 9.388_936_650_420_277e-12);
        let corners = [
            [0.1, 0.2, 0.3],
            [
                0.367_261_241_912_424_4,
                0.734_522_483_824_848_7,
                1.101_783_725_737_273_1,
            ],
            [
                0.233_630_630_443_045_2,
                0.467_261_241_912_424_4,
                0.700_891_859_706_358_9,
            ],
        ];
        let [t, beta, gamma] = triangle(&corners, &[1.5, 2.5, -3.5], &[-1.1, -1.65, 4.4]);
        // An aspect ratio of 1e8 costs eight of the digits.
        let error = t.error_of(1.056_511_056_519_799_3);
        assert!(
            (error - 8.385_229_290_032_157e-17).abs() < 1e-22,
            "{error:e}"
        );
        assert!((beta.value() - 2_136_675.135_227_814).abs() < 1e-8);
        assert!((gamma.value() + 4_273_348.187_262_596).abs() < 1e-8);
    }
}
