//! What a ray did: the steps behind a pixel, and the first one at which two traces part.

pub mod divergence;
pub mod pixel_trace;
pub mod steps;
