//! Scenes as text: reads the numbers of a scene from a TOML file.
//!
//! [`TABLES`] is the list of all tables and keys. [`SceneFile`] holds the numbers of a file with
//! their positions. Each stage makes shapes, lights and materials of them with its own
//! constructors, which check the ranges. The crate opens no file, so that it works in a browser.

mod color_text;
mod error;
mod first_mistake;
mod form;
mod item;
mod key;
mod kind;
mod mesh;
mod mistake;
mod notes;
mod numbers;
mod range;
mod reader;
mod scene_file;
mod scene_number;
mod synonyms;
mod uses;

pub use color_text::names as color_names;
pub use error::Error;
pub use first_mistake::FirstMistake;
pub use form::Form;
pub use item::{Data, Item};
pub use key::{Key, Missing};
pub use kind::{FILE, Kind, Notation, TABLES};
pub use mesh::Mesh;
pub use range::Range;
pub use scene_file::{Meshes, SceneFile};
