//! `Stage`: the name and the scenes of a stage.

use std::path::Path;

use crate::{Error, Scene, text};

/// Reads the scene of a scene file.
pub type OpenScene = fn(&Path) -> Result<Scene, Error>;

/// One stage of the course.
pub struct Stage {
    /// The crate's name, with which the names of its pictures begin.
    pub name: &'static str,
    /// The subject of the stage, in one line.
    pub about: &'static str,
    /// The scenes in the order of the course; the first is shown by default.
    pub scenes: Vec<Scene>,
    /// Reads the scene of a scene file, if the stage knows such files.
    pub open: Option<OpenScene>,
}

impl Stage {
    /// The scene of this name, or of the scene file of this name, which ends in `.toml`. The
    /// error lists the scenes of the stage.
    pub fn scene(&self, name: &str) -> Result<Scene, Error> {
        let is_scene = |name: &str| self.scenes.iter().any(|scene| scene.name == name);
        if let Some((begin, end)) = name.rsplit_once('.') {
            let none = match self.open {
                _ if Path::new(name).is_dir() => format!("{} is a folder", text::name(name)),
                _ if is_scene(begin) && !Path::new(name).exists() => {
                    let (name, stage) = (text::name(name), self.name);
                    format!("there is no file {name}, but {begin} is a scene of {stage}")
                }
                Some(open) if end.eq_ignore_ascii_case("toml") => return open(name.as_ref()),
                Some(_) => format!("{} is no scene file, which ends in .toml", text::name(name)),
                None => format!("{} opens no scene files; stages 4 to 7 do", self.name),
            };
            return Err(Error::Usage(none));
        }
        let known = self.scenes.iter().find(|scene| scene.name == name);
        known.cloned().ok_or_else(|| {
            let names: Vec<_> = self.scenes.iter().map(|scene| scene.name).collect();
            if Path::new(name).is_dir() {
                return Error::Usage(format!("{} is a folder", text::name(name)));
            }
            let begins = names.iter().copied().find(|known| known.starts_with(name));
            let nearest = begins.or_else(|| text::nearest(&names, name));
            let file = format!("{name}.toml");
            let is_file = self.open.is_some() && Path::new(&file).is_file();
            let nearest = if is_file { Some(&*file) } else { nearest };
            let nearest =
                nearest.map(|nearest| format!("; the nearest is {}", text::name(nearest)));
            let nearest = nearest.unwrap_or_default();
            let (stage, name, names) = (self.name, text::name(name), names.join(", "));
            Error::Usage(format!(
                "{stage} has no scene \"{name}\"{nearest}; it has {names}"
            ))
        })
    }
}
