//! Tests of the transforms, nodes and discs of this stage, of scene files, and of the programs of all
//! stages that trace rays.
//!
//! `cargo test` runs them after `pictures`, whose failures leave pictures to look at.

mod adaptive;
mod command_lines;
mod deep_reflections;
mod explained;
mod export;
mod lamps_on_groups;
mod node;
mod own_shape;
mod refusals;
mod rows;
mod scales;
mod scene_cases;
mod scene_files;
mod schema;
mod work;
