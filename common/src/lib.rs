//! Types that every stage needs and no lesson teaches: colours, pictures, picture files, scenes, their
//! settings and errors; and in the folder `trace` the steps of a computation, which wrappers around
//! the parts of a lesson report.
//!
//! This crate needs no window and no terminal, builds for WebAssembly, and depends on no other crate
//! of the workbook.

pub mod argument;
pub mod atomic_file;
mod color;
pub mod comparison;
pub mod difference;
mod error;
pub mod file;
mod hash;
mod image;
mod median;
mod omission;
pub mod omitted_work;
pub mod picture_file;
mod progress;
pub mod row;
mod sampling_report;
mod scene;
mod scene_number;
mod settings;
mod size;
mod stage;
pub mod svg;
pub mod text;
mod trace;
mod traced;
mod transfer;
pub mod workbook;

pub use argument::ArgumentError;
pub use color::Color;
pub use error::Error;
pub use hash::fnv1a;
pub use image::Image;
pub use median::Median;
pub use omission::{Omission, Omissions};
pub use progress::Progress;
pub use sampling_report::SamplingReport;
pub use scene::{Paint, Picture, Scene, UsedSettings};
pub use scene_number::{SceneNumber, Unit};
pub use settings::{Edits, Renderer, Sampling, Settings};
pub use size::Size;
pub use stage::Stage;
pub use trace::pixel_trace::PixelTrace;
pub use trace::{divergence, pixel_trace, steps};
pub use traced::{SeenLine, Traced};
pub use transfer::Transfer;
