//! What a ray did: the steps behind a pixel, the first one at which two traces part, and how the pixel
//! changes with the numbers of its scene.

pub mod divergence;
pub mod pixel_trace;
pub mod sensitivity;
pub mod steps;
