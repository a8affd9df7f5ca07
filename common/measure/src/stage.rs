//! `Stage`: the scenes, experiments and extreme cases of a stage.

use common::{Error, Scene};

/// Reads the scene of a scene file.
#[cfg(not(handout))]
pub type OpenScene = fn(&std::path::Path) -> Result<Scene, Error>;

/// Searches for the worst input of the formulas of a shape.
#[cfg(not(handout))]
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
    #[cfg(not(handout))]
    pub experiments: fn() -> Vec<crate::experiment::Experiment<'static>>,
    /// The stiff and extreme cases.
    #[cfg(not(handout))]
    pub extremes: fn(crate::Effort) -> Vec<crate::extremes::Case>,
    /// The search for worst inputs, which returns them in words, if the stage knows any shape.
    #[cfg(not(handout))]
    pub search: Option<Search>,
    /// Opens a scene file, if the stage knows any.
    #[cfg(not(handout))]
    pub open: Option<OpenScene>,
}

impl Stage {
    /// The scene of this name, or of the scene file of this name, which ends in `.toml`. The
    /// error lists the scenes of the stage.
    pub fn scene(&self, name: &str) -> Result<Scene, Error> {
        #[cfg(not(handout))]
        if let Some((_, end)) = name.rsplit_once('.') {
            let none = match self.open {
                Some(open) if end == "toml" => return open(name.as_ref()),
                Some(_) => format!("{name} is no scene file, which ends in .toml"),
                None => format!("{} opens no scene files; stages 4 to 7 do", self.name),
            };
            return Err(Error::Usage(none));
        }
        let known = self.scenes.iter().find(|scene| scene.name == name);
        known.cloned().ok_or_else(|| {
            let names: Vec<_> = self.scenes.iter().map(|scene| scene.name).collect();
            let (stage, names) = (self.name, names.join(", "));
            Error::Usage(format!("{stage} has no scene \"{name}\"; it has {names}"))
        })
    }
}
