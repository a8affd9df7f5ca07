//! `sensitivity`: how the colour of a pixel changes with the numbers of its scene file.
//!
//! A number is moved a little, and the pixel is traced again. A trace knows each decision of the
//! lesson and by which margin it was taken ([`margins`]): so the nearest edge is found from the
//! margins, and the slope between the edges by differences ([`Response`]).

mod bracket;
mod edge;
mod margins;
mod moved;
mod response;
mod slope;
mod without_effect;

use std::collections::HashMap;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::{Error, PixelTrace, Progress, Renderer, Settings, Traced};

pub use edge::Edge;
pub use margins::{Margin, margins};
use moved::Moved;
pub use response::Response;
use without_effect::effective;

/// The channels of a linear colour.
pub type Channels = [f64; 3];

/// The unit of a number of a scene, from which the step follows that moves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// A length, or a coordinate of a place, in the unit of the scene.
    Length,
    /// An angle in degrees.
    Degree,
    /// A coordinate of a direction of this length, which has no unit.
    Direction(f64),
    /// A factor or an exponent, which has no unit.
    Factor,
    /// A factor by which shapes are stretched.
    Scale,
    /// A channel of a colour, in linear light: 1 is the brightest that a picture shows.
    Channel,
    /// A whole number, such as a number of copies. A colour has no derivative by it.
    Whole,
}

/// A number of a scene file, and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberPlace {
    /// Its line, from 1.
    pub line: usize,
    /// Its columns, in characters from 1, without the one behind it. A colour in a text has three
    /// numbers: those of digits have two columns each, or one, and those of a name have the whole
    /// name.
    pub columns: Range<usize>,
    /// Its bytes in the text of the file.
    pub bytes: Range<usize>,
    /// The first byte of its value, which may be a list of several numbers.
    pub at: usize,
    /// Which of these numbers it is, from 0.
    pub index: usize,
    /// Its table, such as `[[sphere]] #2`: the second one in the file, or in its group.
    pub table: String,
    /// Its key, and which of the numbers of this key it is, such as `center x`.
    pub key: String,
    /// Its value; of a colour in a text, the channel in linear light.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
    /// The least and the greatest number that its key allows.
    pub allowed: [f64; 2],
}

/// How large a pixel is where its objects are.
#[derive(Clone, Copy, Debug)]
pub struct Footprint {
    /// Its width, in the unit of the scene.
    pub width: f64,
    /// The angle between the rays of neighbouring pixels, in radians; of parallel rays, the angle
    /// under which its width is seen from the object.
    pub angle: f64,
    /// The same angle seen from the origin of the world, if it is larger there, for what rotates
    /// objects and lights.
    pub angle_of_world: f64,
}

/// By how much colours and factors are moved, of their size, but at least of 1.
const OF_SIZE: f64 = 1.0 / 256.0;
/// A number is moved by at least this fraction of its size, so that rounding does not hide it.
const LEAST: f64 = 1e-9;

impl Footprint {
    /// By how much a number is moved, so that things move by about a fraction of a pixel.
    #[must_use]
    pub fn reach(self, number: &NumberPlace, fraction: f64) -> f64 {
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
            Unit::Scale => fraction * angle * size,
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

/// A number, and how a pixel changes with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    /// The number.
    pub number: NumberPlace,
    /// How the pixel changes.
    pub response: Response,
}

/// Sorts influences: the edges first, by the size of the jump, then by the largest change of a
/// channel per unit, then in the order of the file.
pub fn sort_by_strength(influences: &mut [Influence]) {
    influences.sort_by(|a, b| {
        let [left, right] = [a, b].map(|influence| influence.response.strength());
        right
            .partial_cmp(&left)
            .unwrap_or(std::cmp::Ordering::Equal)
    });
}

/// Edges are looked for so far that things move by this fraction of a pixel.
const PIXEL: f64 = 0.5;

/// How the linear colour of a pixel, the mean of its samples before it is clamped, changes with some
/// numbers of its scene file, in their order. Stops with [`Error::Stopped`].
pub fn influences(
    scene: &dyn Traced,
    settings: &Settings,
    pixel: [u32; 2],
    numbers: &[NumberPlace],
    progress: &dyn Progress,
) -> Result<Vec<Influence>, Error> {
    let settings = &Settings {
        renderer: Renderer::Lesson,
        ..settings.clone()
    };
    let footprint = scene.footprint(settings, Some(pixel))?;
    let Some(center) = State::of(&scene.trace(settings, pixel)?) else {
        let reason = "its pixel is no finite colour";
        let response = Response::Fixed(reason.to_owned());
        return Ok(with_response(numbers, |_| response.clone()));
    };
    progress.done(0.0);
    let moved = numbers.iter().filter(|number| number.unit != Unit::Whole);
    let moved = moved.map(|number| Moved::new(scene, settings, pixel, number, footprint));
    let effective = effective(&center, moved.collect(), progress);
    let tried = AtomicUsize::new(0);
    let responses = effective.par_iter().map(|moved| {
        if progress.stopped() {
            return Err(Error::Stopped);
        }
        let number = moved.number;
        let response = Response::of(number.value, moved.reach, &center, moved);
        let tried = 1 + tried.fetch_add(1, Ordering::Relaxed);
        progress.done(tried as f64 / effective.len() as f64);
        Ok(((number.at, number.index), response))
    });
    let responses: HashMap<_, _> = responses.collect::<Result<_, Error>>()?;
    Ok(with_response(numbers, |number| {
        if number.unit == Unit::Whole {
            return Response::Whole;
        }
        let found = responses.get(&(number.at, number.index));
        found.cloned().unwrap_or(Response::None)
    }))
}

fn with_response(
    numbers: &[NumberPlace],
    response: impl Fn(&NumberPlace) -> Response,
) -> Vec<Influence> {
    let influences = numbers.iter().map(|number| Influence {
        number: number.clone(),
        response: response(number),
    });
    influences.collect()
}

/// A pixel while one number of its scene is moved.
trait Pixel {
    /// Its colour with a value of the number; none where it has no finite colour.
    fn color(&self, value: f64) -> Option<Channels>;

    /// Its colour, and the margins of the decisions behind it.
    fn state(&self, value: f64) -> Option<State>;
}

/// A pixel with one value of a number.
#[derive(Clone, Debug)]
struct State {
    color: Channels,
    /// Sorted by the decisions.
    margins: Vec<Margin>,
}

impl State {
    /// The state of a trace; none where it has no finite colour.
    fn of(trace: &PixelTrace) -> Option<Self> {
        trace.color.is_finite().then(|| Self {
            color: trace.color.channels(),
            margins: margins(&trace.steps),
        })
    }
}

fn minus(a: Channels, b: Channels) -> Channels {
    std::array::from_fn(|i| a[i] - b[i])
}

fn magnitude(a: Channels) -> f64 {
    a.into_iter().map(f64::abs).fold(0.0, f64::max)
}

fn difference(a: Channels, b: Channels) -> f64 {
    magnitude(minus(a, b))
}
