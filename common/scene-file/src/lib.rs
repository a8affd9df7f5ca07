//! Scenes as text: reads the numbers of a scene from a TOML file, and writes the scenes of
//! the engine as TOML and for POV-Ray.
//!
//! [`KINDS`] is the list of all tables and keys. [`SceneFile`] holds the numbers of a file with
//! their positions. Each stage makes shapes, lights and materials of them with its own
//! constructors, which check the ranges. The crate opens no file, so that it works in a browser.

mod error;
mod export;
mod item;
mod kind;
mod mesh;
mod mistake;
mod notes;
mod numbers;
mod phrases;
mod reader;

pub use error::Error;
pub use export::{WrittenShape, export};
pub use item::{Data, Item};
pub use kind::{KINDS, Key, Kind, OwnTable};
pub use mesh::Mesh;
pub use phrases::{POV_RAY, Phrases, TOML};
pub use reader::{Meshes, SceneFile};
