//! Tests of the shadows and mirrors of this stage.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod mirrors;
mod rounding;
mod secondary_rays;
mod shadows;
mod work;
