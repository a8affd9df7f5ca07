//! Pictures that a function makes of random numbers.

use common::{Color, Settings};
use engine::Renderer;

use crate::kinds::{Make, Position, picture};
use crate::rooms::room;
use crate::support::Numbers;

/// A kind of pictures.
pub struct Picture {
    pub name: &'static str,
    /// An upper bound of its light, infinite where none is known.
    pub brightest: f64,
    pub make: Make,
}

pub const PICTURES: [Picture; 7] = [
    Picture {
        name: "a lone shape",
        brightest: f64::INFINITY,
        make: |numbers, settings| room(numbers, settings, [1.0, 1.0], true),
    },
    Picture {
        name: "few shapes",
        brightest: f64::INFINITY,
        make: |numbers, settings| room(numbers, settings, [1.0, 4.0], false),
    },
    Picture {
        name: "few shapes and shadows",
        brightest: f64::INFINITY,
        make: |numbers, settings| room(numbers, settings, [2.0, 4.0], true),
    },
    Picture {
        name: "checkered floor to the horizon",
        brightest: 1.0,
        make: checkered_floor,
    },
    Picture {
        name: "fence thinner than a pixel",
        brightest: 1.0,
        make: fence,
    },
    Picture {
        name: "almost level edges",
        brightest: 1.0,
        make: level_edges,
    },
    Picture {
        name: "narrowing rings",
        brightest: 1.0,
        make: rings,
    },
];

/// The width of a pixel where 160 lie side by side.
const PIXEL: f64 = 1.0 / 160.0;

fn checkered_floor(numbers: &mut Numbers, settings: &Settings) -> Renderer<'static> {
    let (height, near) = (numbers.between(0.2, 0.5), numbers.between(0.05, 0.5));
    let turn = numbers.turn();
    let colors = [numbers.color(), numbers.color()];
    picture(settings, move |Position { x, y }| {
        if y >= height {
            return Color::new(0.5, 0.6, 0.9);
        }
        let far = near / (height - y);
        let aside = 4.0 * far * (x - 0.5);
        let column = (aside * turn.cos - far * turn.sin).floor();
        let row = (aside * turn.sin + far * turn.cos).floor();
        colors[(column + row).rem_euclid(2.0) as usize]
    })
}

fn fence(numbers: &mut Numbers, settings: &Settings) -> Renderer<'static> {
    let (pitch, covered) = (numbers.between(0.8, 6.0), numbers.between(0.05, 0.4));
    let (slant, color) = (numbers.between(-0.2, 0.2), numbers.color());
    let (top, bottom) = (numbers.between(0.4, 0.7), numbers.between(0.05, 0.3));
    picture(settings, move |Position { x, y }| {
        let in_posts = (x + slant * y) / (pitch * PIXEL);
        let is_post = in_posts.rem_euclid(1.0) < covered;
        if is_post && y < top && y > bottom {
            color
        } else {
            Color::gray(0.3 + 0.4 * y)
        }
    })
}

/// Everything below a line that is almost level.
struct Edge {
    low: f64,
    slope: f64,
    color: Color,
}

fn level_edges(numbers: &mut Numbers, settings: &Settings) -> Renderer<'static> {
    let mut edges = Vec::new();
    for _ in 0..numbers.count([1.0, 4.0]) {
        let slope = libm::pow(numbers.between(-0.1, 0.1), 3.0);
        edges.push(Edge {
            low: numbers.between(0.0, 0.75),
            slope,
            color: numbers.color(),
        });
    }
    edges.sort_by(|a, b| a.low.total_cmp(&b.low));
    picture(settings, move |Position { x, y }| {
        let above = edges.iter().find(|edge| y < edge.low + edge.slope * x);
        above.map_or(Color::gray(0.9), |edge| edge.color)
    })
}

fn rings(numbers: &mut Numbers, settings: &Settings) -> Renderer<'static> {
    let (center, rate) = (numbers.position(), numbers.between(50.0, 3000.0));
    picture(settings, move |Position { x, y }| {
        let (dx, dy) = (x - center.x, y - center.y);
        let squared = dx * dx + dy * dy;
        Color::gray(0.5 + 0.5 * libm::cos(rate * squared))
    })
}
