//! Random worlds: the three renderers draw the same pictures of them, the engine by each of its instruction sets. A
//! release build has more than one set.
//!
//! `RANDOM_SCENES=3000 cargo test --release -p a07-lab --test random_worlds` compares thousands of scenes, in minutes.

mod compare;
mod coverage;
mod edges;
mod hits;
mod levels;
mod own_types;
mod rays;
mod scenes;
mod shared;
mod zeros;
