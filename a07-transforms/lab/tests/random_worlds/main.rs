//! Random worlds: the three renderers draw the same pictures of them, and the engine, by each of its
//! instruction sets, meets the same shapes as the lesson's list. A release build has more than one set.
//!
//! `RANDOM_SCENES=6000 cargo test --release -p a07-lab --test random_worlds` compares thousands of extreme
//! scenes of each stage, in minutes.

mod groups;
mod hits;
mod levels;
mod lit;
mod mirrors;
mod own_types;
mod random_scene;
mod same_hits;
mod same_pictures;
mod scene_files;
mod shapes;
mod written;
