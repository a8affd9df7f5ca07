//! Fresnel's formulas: how much water or glass mirrors.

use crate::prelude::*;

/// The share of unpolarised light that a surface mirrors, whose angle to the
/// normal has the cosine `cos`, from 0 to 1. It comes from where the
/// refractive index is `from`, and beyond the surface it is `to`.
pub fn reflectance(cos: f64, from: f64, to: f64) -> f64 {
    let sine = from / to * (1.0 - cos * cos).sqrt();
    if sine >= 1.0 {
        return 1.0;
    }
    let beyond = (1.0 - sine * sine).sqrt();
    let across = (from * cos - to * beyond) / (from * cos + to * beyond);
    let along = (from * beyond - to * cos) / (from * beyond + to * cos);
    (across * across + along * along) / 2.0
}

testing::examples! {
    assert_close(reflectance(1.0, 1.0, 1.5), 0.04);
    assert_close(reflectance(0.6, 1.0, 4.0 / 3.0), 0.0392);
    assert_eq!(reflectance(0.5, 2.0, 1.0), 1.0, "all is mirrored");
    assert!(reflectance(0.0, 1.5, 1.5).is_finite(), "a number, along equal indices");
}
