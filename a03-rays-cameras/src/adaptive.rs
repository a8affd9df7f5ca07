//! Adaptive sampling: few samples where light changes evenly, and many at edges and
//! highlights, until the picture is as exact as it was asked to be.
//!
//! The picture is parted into cells, squares whose light is taken for the mean of
//! that at their corners: first into blocks of 2 x 2 pixels. Those cells that err
//! most are divided into four, and their parts again, as far as it takes. Neighbours
//! share corners, so that a pixel takes about one sample for its four.
//!
//! (To look at the corners and to divide where they differ is Whitted's way, An
//! Improved Illumination Model for Shaded Display, 1980; to begin with blocks larger
//! than a pixel is that of Akimoto, Mase and Suenaga, Pixel-Selected Ray Tracing,
//! 1991.)
//!
//! What no corner shows is not found: an object that lies between the corners of all
//! pixels is missing from the picture, and so is the tip of a needle.

mod cell;
mod crosses;
mod experience;
mod lattice;
mod level;
mod place;
mod strip;

use common::{Color, Error, Image, Progress, Sampled, Settings};

use lattice::Lattice;
use level::Level;
pub use place::{Place, beside};
use strip::{Pixels, Strip, TILE};

use crate::render::for_each_strip;

/// What the scene looks like.
pub trait View: Sync {
    /// The light at some places.
    fn light(&self, places: &[Place], light: &mut Vec<Color>);
    /// Whether something may hide between the corners of blocks in a square tile, whose
    /// upper left pixel is in this column and row.
    fn may_hide(&self, tile: (u32, u32), side: u32) -> bool;
    /// True once the picture is not wanted any more.
    fn stopped(&self) -> bool;
}

/// In pixels: what is so narrow may lie between the corners of all blocks. (A disc is
/// met by one of them if it is the root of two wider than a block.)
pub const NARROW: f64 = 3.0;

/// Of the squared error allowed so much is aimed at: what is estimated errs, too.
const AIM: f64 = 0.6;

/// Renders the rows that are wanted into a picture of them. Each part of a picture
/// comes to the bound alone, and so the whole does.
pub fn render(
    image: &mut Image,
    max_error: f64,
    settings: &Settings,
    view: &impl View,
    progress: &dyn Progress,
) -> Result<(), Error> {
    let (size, wanted) = (image.size(), settings.rows());
    let fair = AIM * 3.0 * max_error * max_error;
    // Summed over pixels and channels.
    let allowed = fair * size.pixels() as f64;
    let mut level = Level::unknown(settings.samples, fair);

    let lattice = Lattice::new(size, wanted.start, view)?;
    let tops = wanted.clone().step_by(TILE as usize);
    let mut strips: Vec<_> = tops
        .map(|top| Strip::new(top..wanted.end.min(top + TILE)))
        .collect();
    let width = size.width();
    let begin = |first_row, colors: &mut [Color], strip: &mut Strip| {
        let mut pixels = Pixels {
            first_row,
            width,
            colors,
        };
        strip.begin(&lattice, &mut pixels, &level, view);
        !view.stopped()
    };
    for_each_strip(image, wanted.start, TILE, &mut strips, progress, begin)?;

    let error = loop {
        level.learn(strips.iter().map(Strip::experience));
        let error = strips.iter().map(|strip| strip.error(&level)).sum();
        if error <= allowed {
            break error;
        }
        let cells = strips.iter().flat_map(Strip::cells);
        level.come_down(cells, error, allowed);
        let due = strips.iter().filter(|strip| strip.is_due(&level));
        let rows = due.map(|strip| strip.rows().len() as u32).sum();
        if rows == 0 {
            break error;
        }
        progress.more_rows(rows);
        let divide = |first_row, colors: &mut [Color], strip: &mut Strip| {
            let mut pixels = Pixels {
                first_row,
                width,
                colors,
            };
            let is_due = strip.is_due(&level);
            if is_due {
                strip.divide(&mut pixels, &level, view);
            }
            is_due && !view.stopped()
        };
        for_each_strip(image, wanted.start, TILE, &mut strips, progress, divide)?;
    };

    let samples: u64 = strips.iter().map(Strip::samples).sum();
    let depth = strips.iter().map(Strip::depth).max().unwrap_or(1);
    progress.sampled(&Sampled {
        pixels: size.pixels() as u64,
        samples: samples + lattice.len() as u64,
        most: 1 << (2 * (depth - 1)),
        squared_error: error / 3.0,
    });
    Ok(())
}

/// What tests look at.
#[cfg(test)]
mod drawn {
    use std::sync::Mutex;

    use common::Color;

    use super::{Place, View};

    /// A function of the place, in units of the smallest cells.
    pub struct Drawn<F> {
        light: F,
        /// The tiles that may hide something begin in these columns.
        pub hiding: Vec<u32>,
        pub stopped: bool,
        /// What was looked at together.
        asked: Mutex<Vec<Vec<Place>>>,
    }

    impl<F: Fn(Place) -> Color> Drawn<F> {
        pub fn new(light: F) -> Self {
            Self {
                light,
                hiding: Vec::new(),
                stopped: false,
                asked: Mutex::default(),
            }
        }

        /// Where it was looked at, in order, and at how many places at once, at most.
        pub fn asked(&self) -> (Vec<Place>, usize) {
            let asked = self.asked.lock().unwrap();
            let mut places = asked.concat();
            places.sort_unstable();
            (places, asked.iter().map(Vec::len).max().unwrap_or(0))
        }
    }

    impl<F: Fn(Place) -> Color + Sync> View for Drawn<F> {
        fn light(&self, places: &[Place], light: &mut Vec<Color>) {
            light.clear();
            light.extend(places.iter().map(|place| (self.light)(*place)));
            self.asked.lock().unwrap().push(places.to_vec());
        }

        fn may_hide(&self, (x, _): (u32, u32), _: u32) -> bool {
            self.hiding.contains(&x)
        }

        fn stopped(&self) -> bool {
            self.stopped
        }
    }
}
