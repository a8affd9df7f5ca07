//! `Stage`: the scenes, experiments and extreme cases of a stage.

use std::path::Path;

use common::{Error, Scene};

use crate::Effort;
use crate::experiment::Experiment;
use crate::extremes::Case;

/// Reads the scene of a scene file.
pub type OpenScene = fn(&Path) -> Result<Scene, Error>;

/// Searches for the worst input of the formulas of a shape.
pub type Search = fn(&str) -> Result<String, Error>;

/// One stage of the course: its name, scenes, experiments and extreme cases.
pub struct Stage {
    /// The crate's name, with which the names of its pictures begin.
    pub name: &'static str,
    /// The subject of the stage, in one line.
    pub about: &'static str,
    /// The scenes in the order of the course; the first is shown by default.
    pub scenes: Vec<Scene>,
    /// The experiments about error against run time.
    pub experiments: fn() -> Vec<Experiment<'static>>,
    /// The stiff and extreme cases.
    pub extremes: fn(Effort) -> Vec<Case>,
    /// The search for worst inputs, which returns them in words, if the stage knows any shape.
    pub search: Option<Search>,
    /// Opens a scene file, if the stage knows any.
    pub open: Option<OpenScene>,
}

impl Stage {
    /// The scene of this name, or of the scene file of this name, which ends in `.toml`. The
    /// error lists the scenes of the stage.
    pub fn scene(&self, name: &str) -> Result<Scene, Error> {
        let path = Path::new(name);
        if path.extension().is_some_and(|end| end == "toml") {
            let none = || format!("{} opens no scene files; stages 4 to 7 do", self.name);
            return self.open.ok_or_else(|| Error::Usage(none()))?(path);
        }
        let known = self.scenes.iter().find(|scene| scene.name == name);
        known.cloned().ok_or_else(|| {
            let names: Vec<_> = self.scenes.iter().map(|scene| scene.name).collect();
            let (stage, names) = (self.name, names.join(", "));
            Error::Usage(format!("{stage} has no scene \"{name}\"; it has {names}"))
        })
    }
}
