//! What the programs of all stages share and no lesson teaches: colours and
//! pictures, files, settings, progress, and the command line.
//!
//! Nothing here knows a ray or a window. A stage hands its [`Scene`]s to
//! [`program::run`], together with a [`Viewer`] if the build has one.

pub mod argument;
mod color;
pub mod comparison;
#[cfg(all(feature = "display", target_os = "linux"))]
pub mod display;
mod effort;
mod error;
#[cfg(feature = "exercise")]
pub mod exercise;
pub mod experiment;
pub mod extremes;
mod gallery;
mod image;
mod live_picture;
mod overrides;
pub mod picture_file;
#[cfg(feature = "lock")]
pub mod picture_lock;
mod plan;
#[cfg(feature = "report")]
mod plot;
pub mod program;
mod progress;
#[cfg(feature = "report")]
mod report;
mod sampled;
mod scene;
#[cfg(feature = "report")]
mod scene_report;
mod settings;
mod size;
pub mod tally;
mod transfer;
mod viewer;
mod whole_file;

pub use argument::ArgumentError;
pub use color::Color;
pub use effort::Effort;
pub use error::Error;
#[cfg(feature = "exercise")]
pub use exercise::missing;
pub use gallery::{Gallery, Rendering};
pub use image::Image;
pub use live_picture::LivePicture;
pub use plan::{Bound, Omission, Plan};
pub use progress::{Progress, TerminalProgress};
pub use sampled::Sampled;
pub use scene::{Scene, Stage};
pub use settings::{Sampling, Settings};
pub use size::Size;
pub use transfer::Transfer;
pub use viewer::{NotShown, Viewer};
