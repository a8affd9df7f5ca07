//! Tests of the shadows and mirrors of this stage, and of the engine
//! against the lesson.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod all_work;
mod engine;
mod eye_in_plane;
mod mirrors;
#[path = "../../../a05-lighting/tests/stage/numbers.rs"]
mod numbers;
mod shadows;
mod work;
