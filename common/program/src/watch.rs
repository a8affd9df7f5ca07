//! `Watch`: opens a scene file again when it has been saved.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use common::{Error, Scene, Stage};

/// The files of a scene, with the times when they were saved, and their sizes.
pub struct Watch(Vec<(PathBuf, Option<(SystemTime, u64)>)>);

impl Watch {
    /// Watches the files of a scene from now on. Only one scene of a file can be watched.
    pub fn new(scenes: &[Scene]) -> Result<Self, Error> {
        match scenes {
            [scene] if !scene.files.is_empty() => {
                let files = scene.files.iter();
                let files = files.map(|path| (path.clone(), saved(path)));
                Ok(Self(files.collect()))
            }
            _ => Err(Error::Usage(
                "--watch needs one scene file, which ends in .toml".to_owned(),
            )),
        }
    }

    /// Opens the scene file, if one of the files has been saved since the last call.
    pub fn reopen(&mut self, stage: &Stage) -> Option<Result<Scene, Error>> {
        let mut has_changed = false;
        for (path, known) in &mut self.0 {
            let now = saved(path);
            // An editor may delete a file for a moment while it saves.
            has_changed |= now.is_some() && std::mem::replace(known, now) != now;
        }
        let (path, _) = self.0.first().filter(|_| has_changed)?;
        let scene = stage.scene(&path.to_string_lossy());
        Some(scene.and_then(|scene| {
            *self = Self::new(std::slice::from_ref(&scene))?;
            Ok(scene)
        }))
    }
}

fn saved(path: &Path) -> Option<(SystemTime, u64)> {
    let metadata = fs::metadata(path).ok()?;
    Some((metadata.modified().ok()?, metadata.len()))
}
