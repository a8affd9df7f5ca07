//! Figures of the first two stages: colours and vectors.

use super::{ask, assert_near};

/// A quarter of 3 is 0.75; of a light that is limited to 1, a quarter.
#[test]
fn light_is_limited_once() {
    for (light, fraction, byte, clamped) in [
        (3.0, 0.25, 191.0, 64.0),
        (1.0, 0.25, 64.0, 64.0),
        (2.0, 0.5, 255.0, 128.0),
        (4.0, 1.0, 255.0, 255.0),
        (0.0, 0.5, 0.0, 0.0),
    ] {
        let answer = ask("color", &[light, fraction]);
        assert_near(answer.get("product"), &[light * fraction]);
        assert_near(answer.get("byte"), &[byte]);
        assert_near(answer.get("clamped_byte"), &[clamped]);
    }
}

/// (3, 4) and (5, 0): a dot product of 15, a parallelogram of 20, a cosine of 3/5.
#[test]
fn products_of_vectors_are_those_of_geometry() {
    let answer = ask("vectors", &[3.0, 4.0, 5.0, 0.0]);
    assert_near(answer.get("dot"), &[15.0]);
    assert_near(answer.get("area"), &[20.0]);
    assert_near(answer.get("cosine"), &[0.6]);
    assert_near(answer.get("projection"), &[3.0, 0.0]);
    assert_near(answer.get("reflected"), &[3.0, -4.0]);
    let none = ask("vectors", &[3.0, 4.0, 0.0, 0.0]);
    assert!(none.get("projection").is_empty() && none.get("reflected").is_empty());
}

/// Below 10^-8 the cosine rounds to 1, and the arc cosine is 0.
#[test]
fn only_the_arc_cosine_loses_small_angles() {
    for power in [-12.0, -10.0, -9.0, -6.0, -3.0] {
        let answer = ask("angle", &[power]);
        assert!(answer.get("our_error")[0] <= 2.0 * f64::EPSILON);
        let lost = answer.get("cosine_error")[0];
        if power < -8.0 {
            assert_eq!(lost, 1.0);
        } else {
            // A cosine is rounded by half an ulp of 1: the angle by at most that over it.
            let angle = answer.get("ours")[0];
            assert!(
                lost > 0.0 && lost <= 2.0 * f64::EPSILON / (angle * angle),
                "{lost}"
            );
        }
    }
}
