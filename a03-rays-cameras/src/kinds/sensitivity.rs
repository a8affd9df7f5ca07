//! How the pixels of a scene file change with its numbers: a number is moved, camera and world are
//! made again, and the pixel, or the picture, is traced again.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use common::sensitivity::{
    DependentPixels, Influence, NumberPlace, Response, Unit, sort_by_strength,
};
use common::{Color, Edits, Error, Image, Progress, Renderer, Settings, Size};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use scene_file::{SceneFile, SceneNumber};

use crate::kinds::Format;
use crate::{Camera, Sampler, View, camera_coordinates};

/// A scene file whose numbers can be moved.
pub struct NumberedFile {
    format: Format,
    text: String,
    /// The values of the file. A number differs from the file only while a view is made.
    file: Mutex<SceneFile>,
}

/// How far things are moved to see what changes: so far that they move by this fraction of a pixel.
const PIXEL: f64 = 0.5;
/// The same for a whole picture, so that each border between two objects is seen.
const PIXEL_OF_PICTURE: f64 = 1.0;
/// By how much colours and factors are moved, of their size, but at least of 1.
const OF_SIZE: f64 = 1.0 / 256.0;
/// A number is moved by at least this fraction of its size, so that rounding does not hide it.
const LEAST: f64 = 1e-9;

impl NumberedFile {
    /// The file that was read from this text.
    #[must_use]
    pub const fn new(format: Format, file: SceneFile, text: String) -> Self {
        Self {
            format,
            text,
            file: Mutex::new(file),
        }
    }

    /// The text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// All numbers of the file in the order of its text. Colours in bytes are those of pictures with
    /// the transfer of the settings.
    pub fn numbers(&self, settings: &Settings) -> Vec<SceneNumber> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.set_transfer(settings.transfer);
        file.numbers(&self.text)
    }

    /// The camera and the world of the file.
    pub fn view(&self, settings: &Settings) -> Result<View, scene_file::Error> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.set_transfer(settings.transfer);
        (self.format.view)(&file)
    }

    /// The camera and the world with another value of a number, and with the changes that a person
    /// has made in the window. None if this value is not allowed.
    fn moved(&self, settings: &Settings, number: &SceneNumber, value: f64) -> Option<View> {
        if !number.range.contains(value) {
            return None;
        }
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.set_transfer(settings.transfer);
        file.set_number(number, value);
        let view = (self.format.view)(&file);
        file.set_number(number, number.place.value);
        drop(file);
        view.ok().map(|view| edited(view, settings))
    }

    /// How the linear colour of a pixel, the mean of its samples before it is clamped, changes with
    /// each number of the file; the strongest first. The progress counts each number as a row.
    /// [`Error::Stopped`] if it stops.
    pub fn influences(
        &self,
        settings: &Settings,
        pixel: [u32; 2],
        progress: &dyn Progress,
    ) -> Result<Vec<Influence>, Error> {
        let numbers = self.numbers(settings);
        let mut influences = self.influences_of(settings, pixel, &numbers, progress)?;
        sort_by_strength(&mut influences);
        Ok(influences)
    }

    /// How the linear colour of a pixel changes with some of the numbers of the file, in their order.
    /// Stops with [`Error::Stopped`].
    pub fn influences_of(
        &self,
        settings: &Settings,
        pixel: [u32; 2],
        numbers: &[SceneNumber],
        progress: &dyn Progress,
    ) -> Result<Vec<Influence>, Error> {
        let view = self.edited_view(settings)?;
        let footprint = Footprint::of_pixel(&view, settings.size, pixel);
        let center = color_of(&view, settings, pixel);
        let tried = AtomicUsize::new(0);
        progress.done(0.0);
        let influences = numbers.par_iter().map(|number| {
            if progress.stopped() {
                return Err(Error::Stopped);
            }
            let response = if number.place.unit == Unit::Whole {
                Response::Whole
            } else {
                let value = number.place.value;
                let reach = footprint.reach(&number.place, PIXEL);
                Response::of(value, center.channels(), reach, &mut |value| {
                    let view = self.moved(settings, number, value)?;
                    let color = color_of(&view, settings, pixel);
                    color.is_finite().then_some(color.channels())
                })
            };
            let tried = 1 + tried.fetch_add(1, Ordering::Relaxed);
            progress.done(tried as f64 / numbers.len() as f64);
            Ok(Influence {
                number: number.place.clone(),
                response,
            })
        });
        influences.collect()
    }

    /// The pixels of the picture that depend on the numbers of a line, by the engine. Each number is
    /// moved by a step that moves things by about a pixel; `picture` is the picture as it is, if it is
    /// known. The progress counts each number as a row.
    ///
    /// [`Error::Usage`] if the line has no numbers, and [`Error::Stopped`] if `progress` stops it.
    pub fn pixels_of(
        &self,
        settings: &Settings,
        line: usize,
        picture: Option<&Image>,
        progress: &dyn Progress,
    ) -> Result<DependentPixels, Error> {
        let settings = &by_engine(settings);
        let mut numbers = self.numbers_of(settings, line)?;
        numbers.retain(|number| number.place.unit != Unit::Whole);
        let drawn;
        let picture = match picture {
            Some(picture) if picture.size() == settings.size => picture,
            _ => {
                drawn = self.picture(settings, progress)?;
                &drawn
            }
        };
        let mut found = DependentPixels {
            size: settings.size,
            strengths: vec![0.0; picture.pixels().len()],
            numbers: Vec::new(),
        };
        progress.done(0.0);
        let all = numbers.len() as f64;
        for (tried, number) in numbers.into_iter().enumerate() {
            let Some(moved) = self.picture_moved(settings, &number, progress)? else {
                continue;
            };
            let changes = moved.changes(picture);
            for (strength, change) in found.strengths.iter_mut().zip(changes) {
                *strength = strength.max(change);
            }
            found.numbers.push((number.place, moved.step));
            progress.done((tried + 1) as f64 / all);
        }
        Ok(found)
    }

    /// The picture of the file by the engine. Stops with [`Error::Stopped`].
    pub fn picture(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        let view = self.edited_view(settings)?;
        view.render(&by_engine(settings), &Silent(progress))
    }

    /// The picture by the engine after a number has moved by a step that moves things by about a pixel;
    /// none if no such step is allowed. Stops with [`Error::Stopped`].
    pub fn picture_moved(
        &self,
        settings: &Settings,
        number: &SceneNumber,
        progress: &dyn Progress,
    ) -> Result<Option<MovedPicture>, Error> {
        let footprint = Footprint::of_picture(&self.edited_view(settings)?, settings.size);
        let reach = footprint.reach(&number.place, PIXEL_OF_PICTURE);
        for step in [reach, -reach, reach / 64.0, -reach / 64.0] {
            if let Some(view) = self.moved(settings, number, number.place.value + step) {
                let image = view.render(&by_engine(settings), &Silent(progress))?;
                return Ok(Some(MovedPicture { image, step }));
            }
        }
        Ok(None)
    }

    /// The numbers of a line, of which there is at least one.
    fn numbers_of(&self, settings: &Settings, line: usize) -> Result<Vec<SceneNumber>, Error> {
        let last = self.text.lines().count();
        if line == 0 || line > last {
            let text = format!("the file has the lines 1 to {last}, and no line {line}");
            return Err(Error::Usage(text));
        }
        let mut numbers = self.numbers(settings);
        let lines: Vec<_> = numbers.iter().map(|number| number.place.line).collect();
        numbers.retain(|number| number.place.line == line);
        if numbers.is_empty() {
            let nearest = lines.into_iter().min_by_key(|other| other.abs_diff(line));
            let nearest = nearest.map_or_else(String::new, |nearest| {
                format!("; the nearest line that has some is {nearest}")
            });
            let text = format!("line {line} has no numbers of the scene{nearest}");
            return Err(Error::Usage(text));
        }
        if numbers
            .iter()
            .all(|number| number.place.unit == Unit::Whole)
        {
            let text =
                format!("line {line} has whole numbers only, by which no pixel has a derivative");
            return Err(Error::Usage(text));
        }
        Ok(numbers)
    }

    /// The camera and the world of the file, with the changes that a person has made in the window.
    fn edited_view(&self, settings: &Settings) -> Result<View, Error> {
        let view = self.view(settings);
        let view = view.map_err(|error| Error::SceneFile(error.within(&self.text)))?;
        Ok(edited(view, settings))
    }
}

/// The picture of a scene file after one of its numbers has moved.
pub struct MovedPicture {
    image: Image,
    /// The change of the number.
    pub step: f64,
}

impl MovedPicture {
    /// How much each pixel differs from the picture before, row after row from the top: the largest
    /// change of a channel.
    pub fn changes(&self, before: &Image) -> impl Iterator<Item = f64> {
        let pixels = before.pixels().iter().zip(self.image.pixels());
        pixels.map(|(before, after)| change(*before, *after))
    }
}

/// The settings for the engine, without an error bound.
fn by_engine(settings: &Settings) -> Settings {
    Settings {
        renderer: Renderer::Engine,
        max_error: None,
        ..settings.clone()
    }
}

/// The view with the changes that a person has made in the window.
fn edited(view: View, settings: &Settings) -> View {
    if settings.edits == Edits::default() {
        return view;
    }
    view.edited(settings.size, &settings.edits)
}

/// The linear colour of a pixel by the lesson: the mean of its samples.
fn color_of(view: &View, settings: &Settings, [column, row]: [u32; 2]) -> Color {
    let (size, sampler) = (settings.size, Sampler::new(settings));
    let mut sum = Color::BLACK;
    for place in sampler.places(column, row) {
        let (x, y) = camera_coordinates(size, column, row, place);
        let ray = view.camera.ray_for(size, x, y);
        sum += view.world.radiance(&ray, settings.depth);
    }
    sum.map(|sum| sum / f64::from(sampler.samples()))
}

/// The largest change of a channel. One to or from no number counts as a change of 1.
fn change(before: Color, after: Color) -> f64 {
    let channels = before.channels().into_iter().zip(after.channels());
    channels.fold(0.0, |largest, (before, after)| {
        let change = (after - before).abs();
        match (before.to_bits() == after.to_bits(), change.is_finite()) {
            (true, _) => largest,
            (false, true) => largest.max(change),
            (false, false) => largest.max(1.0),
        }
    })
}

/// Passes on that a picture is no longer needed, and shows no row.
struct Silent<'a>(&'a dyn Progress);

impl Progress for Silent<'_> {
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {}

    fn stopped(&self) -> bool {
        self.0.stopped()
    }
}

/// How large a pixel is where its objects are.
#[derive(Clone, Copy, Debug)]
struct Footprint {
    /// Its width, in the unit of the scene.
    width: f64,
    /// The angle between the rays of neighbouring pixels, in radians; of parallel rays, the angle
    /// under which its width is seen from the object.
    angle: f64,
    /// The same angle seen from the origin of the world, if it is larger there, for what rotates
    /// objects and lights.
    angle_of_world: f64,
}

/// The largest angle by which things are rotated for a pixel, in radians.
const LARGEST_ANGLE: f64 = 1.0 / 64.0;

/// The places beside a pixel at which an object is looked for, in pixels.
const BESIDE: [(f64, f64); 9] = [
    (0.0, 0.0),
    (-0.5, 0.0),
    (0.5, 0.0),
    (0.0, -0.5),
    (0.0, 0.5),
    (-0.5, -0.5),
    (0.5, -0.5),
    (-0.5, 0.5),
    (0.5, 0.5),
];

impl Footprint {
    /// The footprint of a pixel, at the distance of the nearest object in it.
    fn of_pixel(view: &View, size: Size, [column, row]: [u32; 2]) -> Self {
        let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
        let places = BESIDE.iter().map(|(dx, dy)| (x + dx, y + dy));
        let distances = places.filter_map(|(x, y)| distance(view, size, x, y));
        let nearest = distances.min_by(f64::total_cmp);
        Self::at(view, size, (x, y), nearest)
    }

    /// The footprint of the pixel in the middle, at the median of the distances of objects.
    fn of_picture(view: &View, size: Size) -> Self {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let mut distances = Vec::new();
        for i in 0..ACROSS * ACROSS {
            let [x, y] = [i % ACROSS, i / ACROSS].map(|i| f64::from(2 * i + 1));
            let [x, y] = [x * width, y * height].map(|x| x / f64::from(2 * ACROSS) - 0.5);
            distances.extend(distance(view, size, x, y));
        }
        distances.sort_by(f64::total_cmp);
        let median = distances.get(distances.len() / 2).copied();
        let middle = ((width - 1.0) / 2.0, (height - 1.0) / 2.0);
        Self::at(view, size, middle, median)
    }

    /// The footprint of the pixel at camera coordinates, at a distance, or at the distance of the world's origin.
    fn at(view: &View, size: Size, (x, y): (f64, f64), distance: Option<f64>) -> Self {
        let rays = [x, x + 1.0].map(|x| view.camera.ray_for(size, x, y));
        let eye = rays[0].origin().to_glam();
        let distance = distance.unwrap_or(eye.length()).max(f64::MIN_POSITIVE);
        let [here, beside] = rays.map(|ray| ray.at(distance).to_glam());
        let width = (beside - here).length();
        let angle = width / distance;
        Self {
            width,
            angle,
            angle_of_world: (width / here.length()).max(angle).min(LARGEST_ANGLE),
        }
    }

    /// By how much a number is moved, so that things move by about a fraction of a pixel.
    fn reach(self, number: &NumberPlace, fraction: f64) -> f64 {
        let size = number.value.abs();
        let angle = if number.table == "[camera]" {
            self.angle
        } else {
            self.angle_of_world
        };
        let reach = match number.unit {
            Unit::Length => fraction * self.width,
            Unit::Degree => fraction * angle.to_degrees(),
            Unit::Direction(length) => fraction * angle * length,
            Unit::Factor if number.key.contains("scale") => fraction * angle * size,
            Unit::Factor | Unit::Channel | Unit::Whole => OF_SIZE * size.max(1.0),
        };
        let least = LEAST * size.max(f64::MIN_POSITIVE);
        if reach.is_finite() {
            reach.max(least)
        } else {
            least
        }
    }
}

/// Places across the picture at which distances are looked for.
const ACROSS: u32 = 8;

/// The distance of the object that is seen at camera coordinates.
fn distance(view: &View, size: Size, x: f64, y: f64) -> Option<f64> {
    let ray = view.camera.ray_for(size, x, y);
    let (_, t) = view.world.nearest(&ray)?;
    t.is_finite().then_some(t)
}
