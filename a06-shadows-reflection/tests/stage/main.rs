//! Tests of the shadows and mirrors of this stage, and of the engine
//! against the lesson.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod extreme_scenes;
mod mirrors;
mod renderers;
mod rounding;
mod secondary_rays;
mod shadows;
mod work;
