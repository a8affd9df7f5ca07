//! `Tracer`: a program that renders a description, and how to run it.

use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use common::Size;

use crate::description::Description;

/// A scene to render, and how to render it.
pub struct Job<'a> {
    pub description: &'a Description,
    /// Where scenes, pictures and logs go.
    pub folder: &'a Path,
    pub size: Size,
    pub threads: u16,
}

impl Job<'_> {
    /// A file of this job and this tracer.
    pub fn file(&self, tracer: &dyn Tracer, extension: &str) -> PathBuf {
        let (scene, threads) = (self.description.name, self.threads);
        let name = format!("{scene}-{}-{threads}", tracer.name());
        self.folder.join(name).with_extension(extension)
    }
}

/// The times that a program prints about itself, in seconds.
pub struct Times {
    /// Making the structures that rays are traced in.
    pub build: f64,
    /// Tracing the picture, without reading the scene and writing the file.
    pub trace: f64,
}

/// A program that renders.
pub trait Tracer {
    fn name(&self) -> &'static str;

    /// Whether it can be run here.
    fn installed(&self) -> bool;

    /// Writes the scene in the language of the program. The error is of the kind
    /// `Unsupported` if the language has no words for it.
    fn write_scene(&self, job: &Job) -> io::Result<()>;

    /// The call that renders `job` into its file with the extension `png`.
    fn command(&self, job: &Job) -> Command;

    /// The times that the program has printed; none if it failed before.
    fn times(&self, log: &str) -> Option<Times>;
}

/// Whether a program of this name can be started.
pub fn is_installed(program: &str) -> bool {
    Command::new(program)
        .arg("--version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok()
}

/// The number before the last "seconds" in the line with this label.
pub fn seconds(log: &str, label: &str) -> Option<f64> {
    let (_, after) = log.rsplit_once(label)?;
    let (before, _) = after.lines().next()?.rsplit_once("seconds")?;
    before.trim().rsplit([' ', '(']).next()?.parse().ok()
}
