//! `OpenedFile`: a scene file, which is read again when it has been saved.

use std::fs;
use std::path::{Path, PathBuf};

use common::{Error, Scene, Stage};

use crate::target::ends_in;
use crate::watch::Watch;

/// A scene file, and its scene when the file was last right.
pub struct OpenedFile {
    /// The file, as the person named it.
    path: PathBuf,
    scene: Option<Scene>,
    error: Option<Error>,
    /// None for a file that is read only once.
    watch: Option<Watch>,
}

impl OpenedFile {
    /// Whether the stage reads a file of this name as a scene.
    pub fn is_named(stage: &Stage, name: &str) -> bool {
        stage.open.is_some() && ends_in(name.as_ref(), "toml")
    }

    /// Opens a scene file. One that is broken has an error, and no scene.
    pub fn open(stage: &Stage, path: &Path, is_watched: bool) -> Self {
        let mut file = Self {
            path: path.to_owned(),
            scene: None,
            error: None,
            watch: is_watched.then(|| Watch::new(path)),
        };
        file.read(stage);
        file
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The scene when the file was last right; none if it never was.
    pub const fn scene(&self) -> Option<&Scene> {
        self.scene.as_ref()
    }

    /// What is wrong with the file as it is now.
    pub const fn error(&self) -> Option<&Error> {
        self.error.as_ref()
    }

    /// The error of a broken file.
    pub fn check(self) -> Result<Self, Error> {
        match self.error {
            Some(error) => Err(error),
            None => Ok(self),
        }
    }

    /// Whether the file is read again when it has been saved.
    const fn is_watched(&self) -> bool {
        self.watch.is_some()
    }

    /// Reads the file again if it is watched and has been saved. True if it has been read.
    pub fn reread(&mut self, stage: &Stage) -> bool {
        let has_changed = self.watch.as_mut().is_some_and(Watch::has_changed);
        if has_changed {
            self.read(stage);
        }
        has_changed
    }

    fn read(&mut self, stage: &Stage) {
        // Begun before: a file that is saved while it is read is read again.
        let mut watch = Watch::new(&self.path);
        match stage.scene(&self.path.to_string_lossy()) {
            Ok(scene) => {
                scene.files.iter().for_each(|path| watch.add(path));
                (self.scene, self.error) = (Some(scene), None);
            }
            Err(error) => {
                for path in self.possible_meshes() {
                    watch.add(&path);
                }
                self.error = Some(error);
            }
        }
        if self.is_watched() {
            self.watch = Some(watch);
        }
    }

    /// The files that a broken scene file may name: the mistake may be in one of them.
    fn possible_meshes(&self) -> Vec<PathBuf> {
        let text = fs::read_to_string(&self.path).unwrap_or_default();
        let mut meshes = Vec::new();
        for name in text.lines().flat_map(|line| line.split(['"', '\''])) {
            if Path::new(name).extension().is_some() && !name.contains('=') {
                meshes.push(self.path.with_file_name(name));
            }
        }
        meshes
    }
}
