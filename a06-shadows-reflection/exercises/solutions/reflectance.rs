//! Fresnel's formulas: how much water or glass mirrors.

use crate::prelude::*;

/// The fraction of unpolarised light that a surface mirrors, whose angle to the
/// normal has the cosine `cos`, from 0 to 1. It comes from where the
/// refractive index is `from`, and beyond the surface it is `to`.
pub fn reflectance(cos: f64, from: f64, to: f64) -> f64 {
    missing!("the fraction that is mirrored", 1.0 - cos, {
        let ratio = from / to;
        let cos_squared = 1.0 - ratio * ratio * (1.0 - cos * cos);
        // All light is mirrored.
        if cos_squared <= 0.0 {
            return 1.0;
        }
        let beyond = cos_squared.sqrt();
        let fraction = |a: f64, b: f64| {
            let amplitude = (a - b) / (a + b);
            amplitude * amplitude
        };
        let across = fraction(from * cos, to * beyond);
        let along = fraction(from * beyond, to * cos);
        f64::midpoint(across, along)
    })
}

testing::examples! {
    assert_close!(reflectance(1.0, 1.0, 1.5), 0.04);
    assert_close!(reflectance(0.6, 1.0, 4.0 / 3.0), 0.0392);
    assert_close!(reflectance(0.5, 2.0, 1.0), 1.0, "all is mirrored");
    assert!(reflectance(0.0, 1.5, 1.5).is_finite(), "a number, along equal indices");
}
