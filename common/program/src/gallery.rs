//! `Gallery`: the scenes of a stage, which a window shows one at a time.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{Scope, ScopedJoinHandle};

use common::{Error, Image, Scene, Size, Transfer, picture_file};
use measure::Stage;

use crate::LivePicture;
use crate::options::Options;
use crate::print::warn;
use crate::target::make_default_folder;
use crate::watch::Watch;

/// The scenes of a stage, the one that is being shown, and its rendering.
pub struct Gallery<'scope, 'a> {
    stage: &'scope Stage,
    scene: Scene,
    /// The files of the scene, if they are watched.
    watch: Option<Watch>,
    options: Options,
    scope: &'scope Scope<'scope, 'a>,
    rendering: Option<Rendering<'scope>>,
}

impl<'scope, 'a> Gallery<'scope, 'a> {
    pub(crate) fn new(
        stage: &'scope Stage,
        scene: Scene,
        watch: Option<Watch>,
        options: Options,
        scope: &'scope Scope<'scope, 'a>,
    ) -> Self {
        Self {
            stage,
            scene,
            watch,
            options,
            scope,
            rendering: None,
        }
    }

    /// Opens the watched scene file if it has been saved, and starts to render it. A broken file
    /// leaves the picture as it is; its error goes to the terminal, too.
    pub fn reopen(&mut self) -> Result<(), Error> {
        let stage = self.stage;
        let Some(opened) = self.watch.as_mut().and_then(|watch| watch.reopen(stage)) else {
            return Ok(());
        };
        let started = opened.and_then(|scene| {
            self.options.settings(&scene)?;
            self.scene = scene;
            self.start()
        });
        started.inspect_err(|error| warn(&format!("error: {error}")))
    }

    /// Stage and scene, for the title of the window.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{}: {}", self.stage.name, self.scene.name)
    }

    /// Whether the scene shows a file that can be chosen.
    #[must_use]
    pub fn opens_files(&self) -> bool {
        self.scene.uses.file
    }

    /// Whether a file has been chosen.
    #[must_use]
    pub fn has_file(&self) -> bool {
        self.options.open.is_some()
    }

    /// Chooses the file that the scene shows.
    pub fn open(&mut self, file: PathBuf) {
        self.options.open = Some(file);
    }

    /// Goes to the next scene, and from the last to the first.
    pub fn go_to_next(&mut self) {
        self.go(1);
    }

    /// Goes to the previous scene, and from the first to the last.
    pub fn go_to_previous(&mut self) {
        self.go(self.stage.scenes.len() - 1);
    }

    /// Goes forward by this number of scenes. The scene of a file counts as the first.
    fn go(&mut self, steps: usize) {
        let scenes = &self.stage.scenes;
        let current = scenes.iter().position(|s| s.name == self.scene.name);
        self.scene = scenes[(current.unwrap_or(0) + steps) % scenes.len()].clone();
    }

    /// The curve between light and the values that are shown.
    #[must_use]
    pub const fn transfer(&self) -> Transfer {
        self.options.transfer
    }

    /// Starts to render the scene in a separate thread. An earlier rendering stops.
    pub fn start(&mut self) -> Result<(), Error> {
        self.rendering = None;
        let scene = self.scene.clone();
        let settings = self.options.settings(&scene)?;
        let threads = self.options.thread_pool()?;
        let picture = Arc::new(LivePicture::new(settings.size, self.transfer()));
        let progress = Arc::clone(&picture);
        let render = move || threads.install(|| scene.render(&settings, &*progress));
        self.rendering = Some(Rendering {
            picture,
            thread: Some(self.scope.spawn(render)),
        });
        Ok(())
    }

    /// The picture as far as it is finished, while it is rendered.
    #[must_use]
    pub fn picture(&self) -> Option<&LivePicture> {
        Some(&self.rendering.as_ref()?.picture)
    }

    /// The finished picture, or the error, of a rendering that has just ended.
    pub fn finished(&mut self) -> Option<Result<Image, Error>> {
        Some(self.rendering.take_if(|r| r.is_over())?.join())
    }

    /// Waits for the end of the rendering.
    pub fn wait(&mut self) -> Result<Image, Error> {
        self.rendering.take().ok_or(Error::Stopped)?.join()
    }

    /// Saves a picture as `out/STAGE-SCENE.png` and returns its path. A different
    /// picture of this name is kept, and the new one gets a number.
    pub fn save(&self, image: &Image) -> Result<PathBuf, Error> {
        let folder = make_default_folder()?;
        let name = format!("{}-{}", self.stage.name, self.scene.name);
        let rgb = image.to_rgb8(self.transfer());
        save_beside_others(folder, &name, image.size(), &rgb)
    }
}

fn save_beside_others(folder: &Path, name: &str, size: Size, rgb: &[u8]) -> Result<PathBuf, Error> {
    let is_same = |path: &Path| {
        picture_file::open(path)
            .is_ok_and(|other| other.size() == size && other.to_rgb8(Transfer::Linear) == rgb)
    };
    let mut path = folder.join(format!("{name}.png"));
    let mut number = 1;
    while path.exists() {
        if is_same(&path) {
            return Ok(path);
        }
        number += 1;
        path = folder.join(format!("{name}-{number}.png"));
    }
    picture_file::save_png(&path, size, rgb)?;
    Ok(path)
}

/// A rendering in a separate thread. Dropping it stops it.
struct Rendering<'scope> {
    picture: Arc<LivePicture>,
    thread: Option<ScopedJoinHandle<'scope, Result<Image, Error>>>,
}

impl Rendering<'_> {
    fn is_over(&self) -> bool {
        let thread = self.thread.as_ref();
        thread.is_none_or(ScopedJoinHandle::is_finished)
    }

    fn join(mut self) -> Result<Image, Error> {
        let thread = self.thread.take().ok_or(Error::Stopped)?;
        thread
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }
}

impl Drop for Rendering<'_> {
    fn drop(&mut self) {
        self.picture.stop();
    }
}

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    #[test]
    fn files_of_other_content_are_never_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.png"), "a letter").unwrap();
        let size = Size::new(1, 1).unwrap();
        // The same picture is there already when it is saved again.
        for (gray, name) in [(2, "a-2.png"), (3, "a-3.png"), (2, "a-2.png")] {
            let path = save_beside_others(folder.path(), "a", size, &[gray; 3]).unwrap();
            assert_eq!(path.file_name().unwrap(), name);
            let saved = picture_file::open(&path).unwrap();
            assert_eq!(saved.pixels(), [Color::from_bytes([gray; 3])]);
        }
        let kept = std::fs::read_to_string(folder.path().join("a.png")).unwrap();
        assert_eq!(kept, "a letter");
        assert_eq!(folder.path().read_dir().unwrap().count(), 3);
    }
}
