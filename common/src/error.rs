//! `Error`: the errors of a stage's program, each reported in one sentence.

use std::path::PathBuf;

use crate::{ArgumentError, Size, text};

/// The reason why a picture could not be made, opened or written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The command line is wrong.
    #[error("{0}")]
    Usage(String),
    /// A constructor refused an argument.
    #[error(transparent)]
    Argument(#[from] ArgumentError),
    /// A file could not be opened.
    #[error("cannot open {}: {reason}", text::path(path))]
    Open {
        /// The file.
        path: PathBuf,
        /// The reason, and a remedy if there is one.
        reason: String,
    },
    /// A scene file has a mistake: the file, the position and the mistake.
    #[error("{0}")]
    SceneFile(String),
    /// A picture file could not be written.
    #[error("cannot write {}: {reason}", text::path(path))]
    Write {
        /// The file.
        path: PathBuf,
        /// The cause.
        reason: String,
    },
    /// An extreme case is out of its bound.
    #[error("{0} of the extreme cases fail; they are marked FAILED")]
    Extremes(usize),
    /// Cargo, which builds and runs a laboratory, could not be started.
    #[error("cannot start cargo, which builds the laboratory: {0}")]
    Laboratory(std::io::Error),
    /// There is not enough memory for a picture.
    #[error("not enough memory for a picture of {size} pixels; a smaller --size would fit")]
    Memory {
        /// The picture's size.
        size: Size,
    },
    /// The threads for the rendering could not be started.
    #[error("cannot start the threads: {0}; fewer --threads may do")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// The rendering was stopped before its end.
    #[error("the rendering was stopped")]
    Stopped,
}

impl Error {
    /// The exit code of a program that ends with this error: 2 for a wrong command
    /// line, 130 as shells say of Ctrl+C, else 1.
    #[must_use]
    pub const fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Stopped => 130,
            _ => 1,
        }
    }
}
