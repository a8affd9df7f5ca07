//! Fresnel's formulas: how much water or glass mirrors.

/// The share of unpolarised light that a surface mirrors, whose angle to the
/// normal has the cosine `cos`, from 0 to 1. It comes from where the
/// refractive index is `from`, and beyond the surface it is `to`.
pub fn reflectance(cos: f64, from: f64, to: f64) -> f64 {
    testing::missing("the share that is mirrored", 1.0 - cos)
}
