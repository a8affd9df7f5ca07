//! The command line of every stage: it shows, renders, reports and explains the
//! scenes of a [`Stage`](common::Stage).
//!
//! The crate of a stage passes its scenes to [`run`], together with a [`Viewer`] if
//! the build has a window. The commands of laboratories and of exercises are in the crates
//! `measure` and `learn`.

mod black_picture;
mod explain_pixel;
mod explained_pixel;
mod gallery;
mod grammar;
mod interruption;
mod laboratory;
mod live_picture;
mod named;
mod opened_file;
mod options;
mod print;
mod processor_time;
mod render;
mod run;
mod save;
mod show;
mod target;
mod terminal_progress;
mod viewer;
mod watch;
mod work;

pub use explained_pixel::ExplainedPixel;
pub use gallery::Gallery;
pub use laboratory::Measure;
pub use live_picture::LivePicture;
pub use named::{Named, SAMPLINGS, by_name};
pub use print::print;
pub use processor_time::processor_time;
pub use run::{exit_code, print_clap_error, run, run_with};
pub use target::{make_default_folder, make_folder, picture_name};
pub use terminal_progress::terminal_bar;
pub use viewer::{NotShown, Viewer};
