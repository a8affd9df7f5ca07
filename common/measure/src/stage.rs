//! `Stage`: the scenes, experiments and extreme cases of a stage.

use common::{Error, Scene};

use crate::Effort;
use crate::experiment::Experiment;
use crate::extremes::Case;

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
}

impl Stage {
    /// The scene of this name, or an error that lists the scenes of the stage.
    pub fn scene(&self, name: &str) -> Result<&Scene, Error> {
        let known = self.scenes.iter().find(|scene| scene.name == name);
        known.ok_or_else(|| {
            let names: Vec<_> = self.scenes.iter().map(|scene| scene.name).collect();
            let (stage, names) = (self.name, names.join(", "));
            Error::Usage(format!("{stage} has no scene \"{name}\"; it has {names}"))
        })
    }
}
