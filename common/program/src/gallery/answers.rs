//! The answers of a gallery to what a person asks: lines of text, the numbers of a pixel, files.

use std::path::PathBuf;

use common::pixel_trace::digits;
use common::{Color, Error, Image, picture_file, text};

use super::{Gallery, Job};
use crate::explained_pixel::ExplainedPixel;
use crate::opened_file::OpenedFile;
use crate::print::print;
use crate::save::save_beside_others;
use crate::target::make_default_folder;

impl Gallery<'_> {
    fn name(&self) -> String {
        match &self.file {
            Some(file) if self.number == 0 => {
                let name = file.path().file_name().unwrap_or_default();
                text::visible(&name.to_string_lossy())
            }
            _ => self.scene().map_or("", |scene| scene.name).to_owned(),
        }
    }

    /// Stage and scene, and the time of the rendering, for the title of the window.
    #[must_use]
    pub fn title(&self) -> String {
        let (stage, name, times) = (self.stage.name, self.name(), self.picture.times());
        format!("{stage}: {name}, {times}")
    }

    /// A few lines for a person: an error, the answer to the last key, the pixel that is explained, or the
    /// scene and the pixel under the mouse.
    #[must_use]
    pub fn lines(&self, pointer: Option<[u32; 2]>) -> Vec<String> {
        if let Some(error) = self.error() {
            return vec![format!("error: {error}")];
        }
        if !self.message.is_empty() {
            return vec![self.message.clone()];
        }
        if let Some(explained) = &self.explained {
            let color = self.color(explained.pixel).unwrap_or(explained.color);
            let object = explained.object.as_deref().map(str::to_owned);
            let bytes = self.bytes(explained.pixel);
            let color = format!("colour {}", digits(&color.channels()));
            return [Some(bytes), object, Some(color)]
                .into_iter()
                .flatten()
                .collect();
        }
        let about = self.scene().map(|scene| scene.about.to_owned());
        let pixel = pointer.map(|pixel| self.bytes(pixel));
        about.into_iter().chain(pixel).collect()
    }

    /// Why there is no picture, or why it is not that of the file as it is now.
    pub(super) fn error(&self) -> Option<&Error> {
        let file = self.file.as_ref().filter(|_| self.number == 0);
        let picture = match &self.job {
            Job::Done(Err(error)) => Some(error),
            _ => None,
        };
        file.and_then(OpenedFile::error).or(picture)
    }

    /// The colour of a pixel of the finished picture.
    fn color(&self, [x, y]: [u32; 2]) -> Option<Color> {
        match &self.job {
            Job::Done(Ok(image)) => image.get(x, y),
            _ => None,
        }
    }

    fn bytes(&self, [x, y]: [u32; 2]) -> String {
        let [_, r, g, b] = self.picture.pixel(x, y).to_be_bytes();
        format!("pixel {x},{y}: bytes ({r}, {g}, {b})")
    }

    /// Explains a pixel inside of the picture, and prints all numbers behind it.
    pub fn explain(&mut self, pixel: [u32; 2]) {
        self.message.clear();
        let [x, y] = pixel;
        let seen = Color::from_packed(self.picture.pixel(x, y));
        let color = self.color(pixel).unwrap_or(seen);
        let explained = self
            .scene()
            .ok_or(Error::Stopped)
            .and_then(|scene| ExplainedPixel::new(scene, self.settings(scene)?, pixel, color));
        let printed = explained.and_then(|explained| {
            print(&explained.text)?;
            self.explained = Some(explained);
            Ok(())
        });
        self.note(printed);
    }

    /// No longer explains a pixel.
    pub fn forget(&mut self) {
        self.explained = None;
        self.message.clear();
    }

    /// Prints the camera as the lines of a scene file.
    pub fn print_camera(&mut self) {
        let lines = self.scene().ok_or(Error::Stopped).and_then(|scene| {
            let lines = scene.rays()?.camera_lines(&self.settings(scene)?)?;
            print(&lines)
        });
        self.say("the terminal shows the camera for a scene file");
        self.note(lines);
    }

    /// Saves the picture in this file, or else as `out/STAGE-SCENE.png`. There a different picture of
    /// this name is kept, and the new one gets a number.
    pub fn save(&mut self, path: Option<PathBuf>) {
        let saved = match &self.job {
            Job::Done(Ok(image)) => self.write(image, path),
            Job::Running(_) => Err(Error::Usage("the picture is not finished yet".to_owned())),
            _ => Err(Error::Usage("there is no picture to save".to_owned())),
        };
        let printed = saved.and_then(|path| {
            self.message = format!("saved {}", text::path(&path));
            print(&self.message)
        });
        self.note(printed);
    }

    fn write(&self, image: &Image, path: Option<PathBuf>) -> Result<PathBuf, Error> {
        let (size, rgb) = (image.size(), image.to_rgb8(self.options.transfer));
        if let Some(path) = path {
            picture_file::save_png(&path, size, &rgb)?;
            return Ok(path);
        }
        save_beside_others(make_default_folder()?, &self.file_name(), size, &rgb)
    }

    /// The name for the file of the picture, without its ending.
    #[must_use]
    pub fn file_name(&self) -> String {
        let scene = self.scene().map_or("", |scene| scene.name);
        format!("{}-{scene}", self.stage.name)
    }

    /// Says that no file was chosen.
    pub fn note_no_file(&mut self) {
        self.say("no file was chosen; --open FILE names one");
    }

    fn say(&mut self, message: &str) {
        message.clone_into(&mut self.message);
    }

    fn note(&mut self, outcome: Result<(), Error>) {
        if let Err(error) = outcome {
            self.message = error.to_string();
        }
    }
}
