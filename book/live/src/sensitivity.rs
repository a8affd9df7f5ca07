//! The numbers of the scene file that a reader writes on the page: how a pixel answers them, and
//! which pixels change with one of them.

mod response;

use std::cell::RefCell;

use a03_rays_cameras::registry::NumberedFile;
use common::{Color, Error, Image, SceneNumber, Settings, Unit};
use page::settings;

use crate::catalogue::FILE;
use crate::{Answered, Reply, file};
use response::{Response, response};

/// A file whose text a page has sent, so that it is read once for many requests about it.
struct Opened {
    file: NumberedFile,
    defaults: Settings,
    numbers: Vec<SceneNumber>,
    /// The last pictures that were asked for, and their settings.
    pictures: Vec<(Settings, Image)>,
}

/// A page asks for two sizes of a picture in turn.
const MAX_PICTURES: usize = 2;

impl Opened {
    /// The picture of the file.
    fn picture(&mut self, settings: &Settings) -> Result<&Image, Error> {
        let mut known = self.pictures.iter();
        let place = if let Some(place) = known.position(|(known, _)| known == settings) {
            place
        } else {
            let picture = self.file.view(settings)?.render(settings, &())?;
            self.pictures.truncate(MAX_PICTURES - 1);
            self.pictures.insert(0, (settings.clone(), picture));
            0
        };
        Ok(&self.pictures[place].1)
    }

    /// The picture after a number has moved by a step that moves things by about a pixel, and the
    /// step; none if no such step is allowed.
    fn moved(
        &self,
        settings: &Settings,
        number: &SceneNumber,
    ) -> Result<Option<(f64, Image)>, Error> {
        let step = self.file.pixel_step(settings, number, None)?;
        for step in [step, -step, step / 64.0, -step / 64.0] {
            let moved = self.file.with(settings, number, number.value + step);
            let view = moved.and_then(|moved| moved.view(settings).ok());
            if let Some(Ok(image)) = view.map(|view| view.render(settings, &())) {
                return Ok(Some((step, image)));
            }
        }
        Ok(None)
    }

    /// How a pixel answers a number that moves things by up to half a pixel, and the largest change.
    fn response(
        &self,
        settings: &Settings,
        number: &SceneNumber,
        pixel: [u32; 2],
    ) -> Result<(Response, f64), Error> {
        if number.unit == Unit::Whole {
            return Ok((Response::None, 0.0));
        }
        let step = self.file.pixel_step(settings, number, Some(pixel))? / 2.0;
        Ok(response(number.value, step, &|value| {
            let moved = self.file.with(settings, number, value)?;
            let color = moved.view(settings).ok()?.color(settings, pixel);
            color.is_finite().then(|| color.channels())
        }))
    }
}

thread_local! {
    static OPENED: RefCell<Option<Opened>> = const { RefCell::new(None) };
}

/// Answers with the scene file of a picture.
fn with_file(picture: &str, answer: impl FnOnce(&mut Opened) -> Answered) -> Answered {
    let no_file = || Error::Usage("only a scene file has numbers".to_owned());
    let text = picture.strip_prefix(FILE).ok_or_else(no_file)?;
    OPENED.with_borrow_mut(|last| {
        let opened = match last.take() {
            Some(opened) if *opened.file.text == *text => opened,
            _ => {
                let (defaults, file) = file::numbered(text)?;
                Opened {
                    numbers: file.numbers(&defaults),
                    file,
                    defaults,
                    pictures: Vec::new(),
                }
            }
        };
        answer(last.insert(opened))
    })
}

/// All numbers of a file. The text has a line for each, its table and its key; the places are in the
/// units of UTF-16 that the strings of a page have.
pub fn numbers(picture: &str) -> Answered {
    with_file(picture, |Opened { file, numbers, .. }| {
        let names = numbers
            .iter()
            .map(|SceneNumber { table, key, .. }| format!("{table}\t{key}"));
        let names: Vec<_> = names.collect();
        let units_before = |at: usize| {
            let before = file.text.get(..at).unwrap_or(&file.text);
            before.encode_utf16().count() as f64
        };
        let list =
            |value: &dyn Fn(&SceneNumber) -> f64| numbers.iter().map(value).collect::<Vec<_>>();
        Ok(Reply::text(names.join("\n"))
            .with("lines", list(&|number| number.line as f64))
            .with("starts", list(&|number| units_before(number.bytes.start)))
            .with("ends", list(&|number| units_before(number.bytes.end)))
            .with("values", list(&|number| number.value))
            .with("units", list(&|number| unit(number.unit)))
            .with("least", list(&|number| number.allowed[0]))
            .with("greatest", list(&|number| number.allowed[1])))
    })
}

/// The place of a unit in the list of the page.
fn unit(unit: Unit) -> f64 {
    match unit {
        Unit::Length => 0.0,
        Unit::Degree => 1.0,
        Unit::Direction(_) => 2.0,
        Unit::Factor | Unit::Scale => 3.0,
        Unit::Channel => 4.0,
        Unit::Whole => 5.0,
    }
}

/// How a pixel answers some of the numbers of a file. Behind the settings stand the pixel, the index
/// of the first number, and how many. The kind of an answer is 0 for none, 1 for a slope, 2 for a jump and 3
/// for a change without a slope; its channels stand in `changes`.
pub fn responses(picture: &str, given: &[f64]) -> Answered {
    with_file(picture, |opened| {
        let settings = settings(&opened.defaults, given)?;
        let &[column, row, first, count] = given.get(10..14).unwrap_or_default() else {
            return Err(Error::Usage(
                "a pixel and its numbers are needed".to_owned(),
            ));
        };
        let rest = opened.numbers.get(first as usize..).unwrap_or_default();
        let pixel = [column as u32, row as u32];
        let [mut kinds, mut changes, mut strengths] = [const { Vec::new() }; 3];
        let [mut errors, mut places] = [const { Vec::new() }; 2];
        for number in rest.iter().take(count as usize) {
            let (response, strength) = opened.response(&settings, number, pixel)?;
            let (kind, channels, error, place) = match response {
                Response::None => (0.0, [0.0; 3], 0.0, 0.0),
                Response::Slope { slope, error } => (1.0, slope, error, 0.0),
                Response::Jump { at, jump } => (2.0, jump, 0.0, at),
                Response::Bend { at, change } => (3.0, change, 0.0, at),
            };
            kinds.push(kind);
            changes.extend(channels);
            errors.push(error);
            places.push(place);
            strengths.push(strength);
        }
        Ok(Reply::default()
            .with("kinds", kinds)
            .with("changes", changes)
            .with("errors", errors)
            .with("places", places)
            .with("strengths", strengths))
    })
}

/// How much each pixel of the picture changes when a number moves by a step that moves things by about
/// a pixel. Behind the settings stands the index of the number; without one, the picture is made for
/// later requests. The opacity of a pixel has its change in a logarithmic scale: 0 for none, 255 for a
/// change of 1 or more, 1 for a ten-thousandth or less.
pub fn changes(picture: &str, given: &[f64]) -> Answered {
    with_file(picture, |opened| {
        let settings = settings(&opened.defaults, given)?;
        let Some(index) = given.get(10) else {
            opened.picture(&settings)?;
            return Ok(Reply::default());
        };
        let Some(number) = opened.numbers.get(*index as usize) else {
            return Err(Error::Usage("the file has no such number".to_owned()));
        };
        let moved = opened.moved(&settings, number)?;
        let before = opened.picture(&settings)?;
        let moved_pixels = moved.iter().flat_map(|(_, image)| image.pixels());
        let pairs = before.pixels().iter().zip(moved_pixels);
        let pixels = pairs.flat_map(|(before, after)| [0, 0, 0, opacity(change(*before, *after))]);
        let size = before.size();
        Ok(Reply {
            pixels: pixels.collect(),
            ..Reply::default()
        }
        .with("size", [size.width().into(), size.height().into()])
        .with("step", moved.iter().map(|(step, _)| *step)))
    })
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

fn opacity(change: f64) -> u8 {
    if change == 0.0 {
        return 0;
    }
    let decades = libm::log10(change).clamp(-4.0, 0.0);
    (255.0 + decades * 63.5) as u8
}
