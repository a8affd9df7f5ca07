//! `StageFolder`: where the files of a stage's exercises are, while a program runs.

use std::path::{Path, PathBuf};
use std::{env, fs};

use common::{Error, Image, Scene, Settings, Stage, Transfer, picture_file};
use judge::answers::Record;

use super::exercise::Exercise;

/// The samples of a pixel, of a scene that has more: they show mistakes as well as a hundred.
const SAMPLES: u32 = 4;

/// The folder of a stage, and its scenes.
#[derive(Clone, Copy)]
pub struct StageFolder {
    folder: &'static Path,
    scenes: fn() -> Stage,
}

impl StageFolder {
    /// The stage in this folder of the workbook.
    #[must_use]
    pub fn new(folder: &'static str, scenes: fn() -> Stage) -> Self {
        let folder = Path::new(folder);
        Self { folder, scenes }
    }

    /// The stage.
    pub(super) fn stage(&self) -> Stage {
        (self.scenes)()
    }

    /// The file with the recorded answers of an exercise.
    pub(super) fn record_file(&self, name: &str) -> PathBuf {
        let file = format!("exercises/answers/{name}.txt");
        self.folder.join(file)
    }

    /// The file of an exercise, which gives the exercise its questions.
    pub(super) fn record(&self, name: &str, exercise: &mut Exercise<()>) -> Result<Record, String> {
        let file = self.record_file(name);
        let failed = |problem: String| format!("{}: {problem}", file.display());
        let text = fs::read_to_string(&file).map_err(|error| failed(error.to_string()))?;
        let record = Record::read(&text).map_err(failed)?;
        exercise.take_questions(&record).map_err(failed)?;
        Ok(record)
    }

    /// Whether a part of the starter is no longer missing in the student's file; also if one of
    /// both cannot be read.
    pub(super) fn is_begun(&self, name: &str) -> bool {
        let read = |folder: &str| {
            let file = format!("exercises/{folder}{name}.rs");
            fs::read_to_string(self.folder.join(file)).ok()
        };
        let (Some(yours), Some(starter)) = (read(""), read("solutions/")) else {
            return true;
        };
        let calls = |text: &str, call| text.matches(call).count();
        let missing = calls(&starter, "missing(") + calls(&starter, "missing!(");
        calls(&yours, "missing(") < missing
    }

    /// The workbook.
    fn workbook(&self) -> PathBuf {
        self.folder.parent().unwrap_or(self.folder).to_owned()
    }

    /// The picture of this name in the book.
    pub(super) fn in_book(&self, name: &str) -> PathBuf {
        self.workbook().join("book/src/pictures").join(name)
    }

    /// The folder for the pictures of exercises, as seen from the current one. If it cannot be
    /// made, saving fails.
    pub(super) fn pictures(&self) -> PathBuf {
        let folder = self.workbook().join("out/exercises");
        let _ = fs::create_dir_all(&folder);
        let folder = folder.canonicalize().unwrap_or(folder);
        let here = env::current_dir().unwrap_or_default();
        folder
            .strip_prefix(here)
            .map_or(folder.clone(), Path::to_owned)
    }

    /// Saves a picture, and says where it lies.
    pub(super) fn save(&self, image: &Image, name: &str) -> String {
        let path = self.pictures().join(name);
        match picture_file::save_png(&path, image.size(), &image.to_rgb8(Transfer::Linear)) {
            Ok(()) => format!("picture: {}", path.display()),
            Err(error) => format!("a picture: {error}"),
        }
    }

    /// The settings with which the scene of an exercise is rendered.
    pub(super) fn settings(scene: &Scene) -> Settings {
        let mut settings = scene.defaults.clone();
        settings.samples = settings.samples.min(SAMPLES);
        settings
    }

    /// The file with the expected picture of a scene: the book's, or, of a scene with many samples,
    /// one with few that is recorded with the answers.
    pub(super) fn expected(&self, scene: &str) -> PathBuf {
        let name = format!("{}-{scene}.png", self.stage().name);
        let recorded = self.folder.join("exercises/answers").join(&name);
        if recorded.is_file() {
            recorded
        } else {
            self.in_book(&name)
        }
    }

    /// Saves the lesson's picture of a scene with few samples, unless it is the one in the book.
    pub(super) fn record_picture(&self, scene: &str) -> Result<(), Error> {
        let stage = self.stage();
        let scene = stage.scene(scene)?;
        let settings = Self::settings(&scene);
        if settings.samples == scene.defaults.samples {
            return Ok(());
        }
        let file = format!("exercises/answers/{}-{}.png", stage.name, scene.name);
        let image = scene.render(&settings, &())?;
        let file = self.folder.join(file);
        picture_file::save_png(&file, image.size(), &image.to_rgb8(Transfer::Linear))
    }
}
