//! The command line of every stage: it shows, renders, reports and explains the
//! scenes of a [`Stage`](measure::Stage).
//!
//! The crate of a stage passes its scenes to [`run`], together with a [`Viewer`] if
//! the build has a window. Only this crate reads arguments and prints.

mod appearance;
mod explain;
mod explain_pixel;
mod explanation;
mod extremes;
mod gallery;
mod grammar;
mod laboratory;
mod live_picture;
mod named;
mod options;
mod print;
mod render;
mod report;
mod run;
mod save;
mod show;
mod slider;
mod target;
mod terminal_progress;
mod viewer;
mod watch;

pub use appearance::Theme;
pub use explanation::Explanation;
pub use gallery::Gallery;
pub use live_picture::LivePicture;
pub use named::{Named, SAMPLINGS, by_name};
pub use run::{run, run_with};
pub use slider::Slider;
pub use target::picture_name;
pub use viewer::{NotShown, Viewer};

/// A stage for tests, with these scenes only.
#[cfg(test)]
fn stage_of(scenes: Vec<common::Scene>) -> measure::Stage {
    measure::Stage {
        name: "a00",
        about: "",
        scenes,
        experiments: Vec::new,
        extremes: |_| Vec::new(),
        search: None,
        open: None,
    }
}
