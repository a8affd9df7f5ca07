//! `Things`: pictures of the rows of `things.md`.

use common::{Color, Settings};
use engine::Renderer;

use crate::kinds::{Position, Turn, picture};
use crate::support::{Numbers, numbers_in};

/// Things at random positions, turned by random angles, before light that changes evenly.
pub struct Things {
    pub name: &'static str,
    /// An upper bound of the light.
    pub brightest: f64,
    /// From which to which number of things.
    count: [f64; 2],
    /// The range of their extents in one direction.
    long: [f64; 2],
    /// The range of their extents in the other direction, in multiples of the first.
    flat: [f64; 2],
    brightness: Brightness,
}

/// The brightness of a thing at a position in units of its extents, or none outside of it.
type Brightness = fn(u: f64, v: f64) -> Option<f64>;

/// The rows of the table.
pub fn things() -> Vec<Things> {
    let mut things = Vec::new();
    for row in include_str!("things.md").lines().skip(2) {
        let name = row.split(" | ").next().unwrap_or_default();
        let name = name.trim_start_matches("| ");
        let numbers = numbers_in(row);
        let [brightest, a, b, c, d, e, f] = numbers[..].try_into().expect("7 numbers");
        things.push(Things {
            name,
            brightest,
            count: [a, b],
            long: [c, d],
            flat: [e, f],
            brightness: brightness(name),
        });
    }
    things
}

fn brightness(kind: &str) -> Brightness {
    match kind {
        "needles" => needle,
        "rims of spot lights" => |u, v| Some(disc(u, v)? - 0.5 * (u * u + v * v)),
        "foliage" => leaf,
        "crossing wires" => |_, v| if_covered(v.abs() < 1.0),
        "glaring highlights" => |u, v| {
            let lit = lit(u, v)?;
            Some(lit + 5.0 * libm::pow(lit, 1000.0))
        },
        "glints" => |u, v| Some(8.0 * disc(u, v)?),
        "a lone box" => square,
        "specks in a glaring light" => |u, v| Some(40.0 * square(u, v)?),
        _ => ball,
    }
}

fn if_covered(is_covered: bool) -> Option<f64> {
    is_covered.then_some(1.0)
}

fn needle(u: f64, v: f64) -> Option<f64> {
    if_covered(u > 0.0 && v.abs() < 1.0 - u)
}

fn leaf(u: f64, v: f64) -> Option<f64> {
    if_covered(u.abs() + v.abs() < 1.0)
}

fn square(u: f64, v: f64) -> Option<f64> {
    if_covered(u.abs().max(v.abs()) < 1.0)
}

fn disc(u: f64, v: f64) -> Option<f64> {
    if_covered(u * u + v * v < 1.0)
}

/// The light on a ball.
fn lit(u: f64, v: f64) -> Option<f64> {
    let height = (1.0 - u * u - v * v).sqrt();
    if height > 0.0 {
        Some((0.5 * u + 0.6 * v + 0.62 * height).max(0.0))
    } else {
        // Beside the ball the root is NaN.
        None
    }
}

fn ball(u: f64, v: f64) -> Option<f64> {
    let lit = lit(u, v)?;
    Some(0.1 + 0.8 * lit + libm::pow(lit, 60.0))
}

/// A thing in a picture.
struct Thing {
    center: Position,
    turn: Turn,
    /// The extents along and across.
    length: f64,
    width: f64,
    color: Color,
    brightness: Brightness,
}

impl Thing {
    /// The light at a position, or none outside of the thing.
    fn light(&self, at: Position) -> Option<Color> {
        let (dx, dy) = (at.x - self.center.x, at.y - self.center.y);
        let Turn { sin, cos } = self.turn;
        let along = dx * cos + dy * sin;
        let across = dy * cos - dx * sin;
        let brightness = (self.brightness)(along / self.length, across / self.width)?;
        Some(self.color * brightness)
    }
}

impl Things {
    fn thing(&self, numbers: &mut Numbers) -> Thing {
        let length = numbers.between(self.long[0], self.long[1]);
        let width = length * numbers.between(self.flat[0], self.flat[1]);
        Thing {
            center: numbers.position(),
            turn: numbers.turn(),
            length,
            width,
            color: numbers.color(),
            brightness: self.brightness,
        }
    }

    /// The picture of these random numbers.
    pub fn picture(&self, numbers: &mut Numbers, settings: &Settings) -> Renderer<'static> {
        let (low, high) = (numbers.color() * 0.3, numbers.color());
        let mut things = Vec::new();
        for _ in 0..numbers.count(self.count) {
            things.push(self.thing(numbers));
        }
        picture(settings, move |at| {
            let seen = things.iter().find_map(|thing| thing.light(at));
            seen.unwrap_or(low * (1.0 - at.y) + high * (at.y * at.y))
        })
    }
}
