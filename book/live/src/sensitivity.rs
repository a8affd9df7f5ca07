//! The numbers of the scene file that a reader writes on the page: how a pixel changes with them, and
//! which pixels change with one of them.

use std::cell::RefCell;

use common::sensitivity::{self, Channels, Influence, NumberPlace, Response, Unit};
use common::{Color, Error, Image, Scene, Settings};
use page::settings;

use crate::catalogue::FILE;
use crate::{Answer, Answered, file};

/// A file whose text a page has sent, so that it is read once for many requests about it.
struct Opened {
    text: String,
    scene: Scene,
    numbers: Vec<NumberPlace>,
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
            let picture = self.scene.render(settings, &())?;
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
        number: &NumberPlace,
    ) -> Result<Option<(f64, Image)>, Error> {
        let rays = self.scene.rays()?;
        let reach = rays.footprint(settings, None)?.reach(number, 1.0);
        for step in [reach, -reach, reach / 64.0, -reach / 64.0] {
            let moved = rays.with(settings, &[(number, number.value + step)]);
            if let Some(Ok(image)) = moved.map(|moved| moved.render(settings, &())) {
                return Ok(Some((step, image)));
            }
        }
        Ok(None)
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
            Some(opened) if opened.text == text => opened,
            _ => {
                let scene = file::scene(text)?;
                Opened {
                    text: text.to_owned(),
                    numbers: scene.rays()?.numbers(&scene.defaults).unwrap_or_default(),
                    scene,
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
    with_file(picture, |Opened { text, numbers, .. }| {
        let names = numbers
            .iter()
            .map(|NumberPlace { table, key, .. }| format!("{table}\t{key}"));
        let names: Vec<_> = names.collect();
        let units_before = |at: usize| {
            let before = text.get(..at).unwrap_or(text);
            before.encode_utf16().count() as f64
        };
        let list =
            |value: &dyn Fn(&NumberPlace) -> f64| numbers.iter().map(value).collect::<Vec<_>>();
        Ok(Answer::text(names.join("\n"))
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

/// How a pixel changes with some of the numbers of a file. Behind the settings stand the pixel, the
/// index of the first number, and how many.
pub fn influences(picture: &str, given: &[f64]) -> Answered {
    with_file(picture, |opened| {
        let settings = settings(&opened.scene.defaults, given)?;
        let &[column, row, first, count] = given.get(10..14).unwrap_or_default() else {
            return Err(Error::Usage(
                "a pixel and its numbers are needed".to_owned(),
            ));
        };
        let rest = opened.numbers.get(first as usize..).unwrap_or_default();
        let some = &rest[..rest.len().min(count as usize)];
        let pixel = [column as u32, row as u32];
        let rays = opened.scene.rays()?;
        let influences = sensitivity::influences(rays, &settings, pixel, some, &())?;
        let answers = influences.iter().map(influence);
        let (kinds, changes): (Vec<_>, Vec<_>) = answers.unzip();
        Ok(Answer::default()
            .with("kinds", kinds)
            .with("changes", changes.into_iter().flatten())
            .with("distances", influences.iter().map(distance)))
    })
}

/// The kind of a response: 0 none, 1 a slope, 2 an edge, 3 a kink, 4 a turning point, 5 an unknown
/// slope. Then its channels: the slope, the jump, the steeper slope of a kink, or the change by half a
/// pixel.
fn influence(influence: &Influence) -> (f64, Channels) {
    let largest = |channels: Channels| channels.into_iter().map(f64::abs).fold(0.0, f64::max);
    match &influence.response {
        Response::None | Response::Whole | Response::Fixed(_) => (0.0, [0.0; 3]),
        Response::Smooth { slope, .. } => (1.0, *slope),
        Response::Edge(edge) => (2.0, edge.jump),
        Response::Kink { below, above } if largest(*below) > largest(*above) => (3.0, *below),
        Response::Kink { above, .. } => (3.0, *above),
        Response::Turning { half_pixel, .. } => (4.0, *half_pixel),
        Response::Unknown(half_pixel) => (5.0, *half_pixel),
    }
}

/// How far an edge is from the number; 0 where there is none.
fn distance(influence: &Influence) -> f64 {
    match &influence.response {
        Response::Edge(edge) => edge.distance,
        _ => 0.0,
    }
}

/// How much each pixel of the picture changes when a number moves by a step that moves things by about
/// a pixel. Behind the settings stands the index of the number; without one, the picture is made for
/// later requests. The opacity of a pixel has its change in a logarithmic scale: 0 for none, 255 for a
/// change of 1 or more, 1 for a ten-thousandth or less.
pub fn changes(picture: &str, given: &[f64]) -> Answered {
    with_file(picture, |opened| {
        let settings = settings(&opened.scene.defaults, given)?;
        let Some(index) = given.get(10) else {
            opened.picture(&settings)?;
            return Ok(Answer::default());
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
        Ok(Answer {
            pixels: pixels.collect(),
            ..Answer::default()
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
