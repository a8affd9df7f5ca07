//! The answers of a gallery to what a person asks: lines of text, the numbers of a pixel, files.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use common::pixel_trace::digits;
use common::{Color, Error, Image, Renderer, picture_file, text};

use super::Gallery;
use crate::explained_pixel::ExplainedPixel;
use crate::print::print;
use crate::render::sooner;
use crate::save::save_beside_others;
use crate::target::{check_png, make_default_folder};

/// A short sentence is read in this time.
const READ: Duration = Duration::from_secs(2);

/// An answer to a key.
pub(super) struct Answer {
    /// Empty if there is none.
    pub text: String,
    /// When it was given.
    pub given: Instant,
}

impl Answer {
    /// No answer.
    pub fn none() -> Self {
        Self::now(String::new())
    }

    fn now(text: String) -> Self {
        Self {
            text,
            given: Instant::now(),
        }
    }
}

impl Gallery<'_> {
    fn name(&self) -> String {
        match self.scenes.shown_file() {
            Some(file) => {
                let name = file.path().file_name().unwrap_or_default();
                text::visible(&name.to_string_lossy())
            }
            None => self.scene().map_or("", |scene| scene.name).to_owned(),
        }
    }

    /// Stage and scene, and the time of the rendering, for the title of the window.
    #[must_use]
    pub fn title(&self) -> String {
        let (stage, name) = (self.scenes.stage.name, self.name());
        let times = self.picture().times();
        format!("{stage}: {name}, {times}")
    }

    /// What is wrong with the scene or its picture; none if nothing is.
    #[must_use]
    pub fn mistake(&self) -> Option<String> {
        let error = self.error().map(|error| format!("error: {error}"));
        let warning = (!self.warning.is_empty()).then(|| self.warning.clone());
        error.or(warning)
    }

    /// A few lines for a person: the answer to the last key, and the pixel that is explained, or the scene and
    /// the pixel under the mouse.
    #[must_use]
    pub fn lines(&self, pointer: Option<[u32; 2]>) -> Vec<String> {
        let mut lines = Vec::new();
        if !self.answer.text.is_empty() {
            lines.push(self.answer.text.clone());
        }
        if self.is_rendering()
            && self.picture().is_slow()
            && let Some(other) = self.by_other_renderer()
            && other.renderer == Renderer::Engine
        {
            lines.push(format!("F: the fast renderer {}", sooner(&other)));
        }
        let Some(scene) = self.scene() else {
            return lines;
        };
        if let Some(explained) = &self.explained {
            let color = self.color(explained.pixel).unwrap_or(explained.color);
            lines.push(self.bytes(explained.pixel));
            lines.extend(explained.object.as_deref().map(str::to_owned));
            lines.push(format!("colour {}", digits(&color.channels())));
        } else {
            lines.push(scene.about.to_owned());
            lines.extend(pointer.map(|pixel| self.bytes(pixel)));
        }
        lines
    }

    /// Why there is no picture, or why it is not that of the file as it is now.
    pub(super) fn error(&self) -> Option<&Error> {
        self.scenes.error().or_else(|| self.rendering.error())
    }

    /// The colour of a pixel of the finished picture.
    fn color(&self, [x, y]: [u32; 2]) -> Option<Color> {
        self.rendering.image()?.get(x, y)
    }

    fn bytes(&self, [x, y]: [u32; 2]) -> String {
        let [_, r, g, b] = self.picture().pixel(x, y).to_be_bytes();
        format!("pixel {x},{y}: bytes ({r}, {g}, {b})")
    }

    /// Explains a pixel inside of the picture, and prints all numbers behind it.
    pub fn explain(&mut self, pixel: [u32; 2]) {
        self.end_answer();
        let [x, y] = pixel;
        let seen = Color::from_packed(self.picture().pixel(x, y));
        let color = self.color(pixel).unwrap_or(seen);
        let explained = self.scene().ok_or_else(no_scene).and_then(|scene| {
            let settings = self.settings(scene)?;
            ExplainedPixel::new(scene, settings, pixel, color)
        });
        let printed = explained.and_then(|explained| {
            print(&explained.text)?;
            self.explained = Some(explained);
            Ok(())
        });
        self.note(printed);
    }

    /// Ends the answer to the last key.
    pub fn end_answer(&mut self) {
        self.answer = Answer::none();
    }

    /// The mouse moves: ends an answer that a person has had time to read.
    pub fn point(&mut self) {
        if self.answer.given.elapsed() > READ {
            self.end_answer();
        }
    }

    /// No longer explains a pixel.
    pub fn forget(&mut self) {
        self.explained = None;
        self.end_answer();
    }

    /// Prints the camera as the lines of a scene file.
    pub fn print_camera(&mut self) {
        let lines = self.scene().ok_or_else(no_scene).and_then(|scene| {
            let lines = scene.rays()?.camera_lines(&self.settings(scene)?)?;
            print(&lines)
        });
        self.say("the terminal shows the camera for a scene file");
        self.note(lines);
    }

    /// Saves the picture in this file, or else as `out/STAGE-SCENE.png`. There a different picture of
    /// this name is kept, and the new one gets a number.
    pub fn save(&mut self, path: Option<PathBuf>) {
        let no_picture = |text: &str| Err(Error::Usage(text.to_owned()));
        let saved = match self.rendering.image() {
            Some(image) => self.write(image, path),
            None if self.is_rendering() => no_picture("the picture is not finished yet"),
            None => no_picture("there is no picture to save"),
        };
        let printed = saved.and_then(|path| {
            self.say(&format!("saved {}", text::path(&path)));
            print(&self.answer.text)
        });
        self.note(printed);
    }

    fn write(&self, image: &Image, path: Option<PathBuf>) -> Result<PathBuf, Error> {
        let (size, rgb) = (image.size(), image.to_rgb8(self.options.transfer));
        if let Some(path) = path {
            check_png(&path)?;
            picture_file::save_png(&path, size, &rgb)?;
            return Ok(path);
        }
        save_beside_others(make_default_folder()?, &self.file_name(), size, &rgb)
    }

    /// The name for the file of the picture, without its ending.
    #[must_use]
    pub fn file_name(&self) -> String {
        let scene = self.scene().map_or("", |scene| scene.name);
        format!("{}-{scene}", self.scenes.stage.name)
    }

    /// Whether there is a finished picture.
    #[must_use]
    pub const fn has_picture(&self) -> bool {
        self.rendering.image().is_some()
    }

    /// Says that no file was chosen.
    pub fn note_no_file(&mut self) {
        self.say("no file was chosen; --open FILE names one");
    }

    /// Gives an answer.
    pub fn say(&mut self, message: &str) {
        self.answer = Answer::now(message.to_owned());
    }

    fn note(&mut self, outcome: Result<(), Error>) {
        if let Err(error) = outcome {
            self.say(&error.to_string());
        }
    }
}

/// The scene file was never right.
fn no_scene() -> Error {
    Error::Usage("there is no scene yet".to_owned())
}
