//! `Strip`: some rows of the picture, whose cells are divided by one thread.

use std::mem;
use std::ops::Range;

use common::Color;

use super::View;
use super::cell::{Cell, Cross, mean};
use super::crosses::{CELLS, crosses};
use super::experience::{ByDepth, Experience};
use super::lattice::Lattice;
use super::level::Level;

/// So many rows there are in a strip, and columns in each of its tiles.
pub const TILE: u32 = 16;

/// What is known of the rows.
pub struct Strip {
    rows: Range<u32>,
    /// The cells that may be divided, ...
    cells: Vec<Cell>,
    /// ... and of the others the errors of what they show, and of what they could hide.
    seen: ByDepth,
    hidden: ByDepth,
    experience: Experience,
    samples: u64,
    depth: u8,
}

/// The pixels of a strip.
pub struct Pixels<'a> {
    pub first_row: u32,
    pub width: u32,
    pub colors: &'a mut [Color],
}

impl Pixels<'_> {
    /// The pixel in this column and row of the picture, if there is one.
    fn get_mut(&mut self, (x, y): (u32, u32)) -> Option<&mut Color> {
        let index = (y - self.first_row) as usize * self.width as usize + x as usize;
        self.colors.get_mut(index).filter(|_| x < self.width)
    }
}

impl Strip {
    /// Rows of the picture: an even number of them, unless they are the last.
    pub fn new(rows: Range<u32>) -> Self {
        Self {
            rows,
            cells: Vec::new(),
            seen: ByDepth::default(),
            hidden: ByDepth::default(),
            experience: Experience::default(),
            samples: 0,
            depth: 1,
        }
    }

    /// Which rows they are.
    pub fn rows(&self) -> &Range<u32> {
        &self.rows
    }

    /// What divided cells have shown.
    pub fn experience(&self) -> &Experience {
        &self.experience
    }

    /// How many places were looked at.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// The depth of the smallest cells.
    pub fn depth(&self) -> u8 {
        self.depth
    }

    /// The estimated squared error of the pixels, summed over them and the channels.
    pub fn error(&self, level: &Level) -> f64 {
        let kept: f64 = self.cells.iter().map(|cell| level.error(cell)).sum();
        level.sum(&self.seen, &self.hidden) + kept
    }

    /// The cells that may be divided.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Whether any cell is to be divided.
    pub fn is_due(&self, level: &Level) -> bool {
        self.cells.iter().any(|cell| level.is_due(cell))
    }

    /// Paints the blocks, as the light at their corners is. Those that may hide
    /// something are divided.
    pub fn begin(
        &mut self,
        lattice: &Lattice,
        pixels: &mut Pixels,
        level: &Level,
        view: &impl View,
    ) {
        let rows = self.rows.clone();
        let tiles = (0..pixels.width).step_by(TILE as usize);
        let may_hide: Vec<_> = tiles
            .map(|x| view.may_hide((x, rows.start), TILE))
            .collect();
        let mut hiding = Vec::with_capacity(CELLS);
        lattice.for_each_block(&rows, |block| {
            let (x, y) = block.pixel();
            if may_hide[(x / TILE) as usize] {
                hiding.push(block);
                if hiding.len() == CELLS {
                    self.divide_all(&hiding, pixels, level, view);
                    hiding.clear();
                }
                return;
            }
            let middle = block.mean();
            for (i, (x, y)) in [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)]
                .into_iter()
                .enumerate()
            {
                if let Some(pixel) = pixels.get_mut((x, y)) {
                    // Light that changes evenly: the corners of a pixel are one of the
                    // block, the middles of two sides, and that of the block.
                    let corner = block.corners[i];
                    let sides = [i ^ 1, i ^ 2].map(|next| (corner + block.corners[next]) * 0.5);
                    *pixel = mean([corner, middle, sides[0], sides[1]]);
                }
            }
            self.keep(block, level);
        });
        self.divide_all(&hiding, pixels, level, view);
    }

    /// Divides the cells that are due.
    pub fn divide(&mut self, pixels: &mut Pixels, level: &Level, view: &impl View) {
        let mut cells = mem::take(&mut self.cells);
        let mut due = Vec::with_capacity(CELLS);
        cells.retain(|cell| {
            if !level.is_due(cell) {
                return self.is_kept(cell, level);
            }
            due.push(*cell);
            if due.len() == CELLS {
                self.divide_all(&due, pixels, level, view);
                due.clear();
            }
            false
        });
        self.divide_all(&due, pixels, level, view);
        // The parts.
        cells.append(&mut self.cells);
        self.cells = cells;
    }

    fn divide_all(&mut self, cells: &[Cell], pixels: &mut Pixels, level: &Level, view: &impl View) {
        if view.stopped() {
            return;
        }
        let (crosses, samples) = crosses(cells, view);
        self.samples += samples;
        let changes: Vec<_> = (cells.iter().zip(&crosses))
            .map(|(cell, cross)| (cell, self.divide_one(cell, cross, pixels, level)))
            .collect();
        for of_pixel in changes.chunk_by(|(a, _), (b, _)| a.pixel() == b.pixel()) {
            self.experience.learn(of_pixel);
        }
    }

    /// Divides a cell and paints what it shows. Returns by how much its light changes.
    fn divide_one(
        &mut self,
        cell: &Cell,
        cross: &Cross,
        pixels: &mut Pixels,
        level: &Level,
    ) -> Color {
        let parts = cell.divided(cross);
        let change = mean(parts.each_ref().map(Cell::mean)) - cell.mean();
        if cell.depth == 0 {
            for part in &parts {
                if let Some(pixel) = pixels.get_mut(part.pixel()) {
                    *pixel = part.mean();
                }
            }
        } else if let Some(pixel) = pixels.get_mut(cell.pixel()) {
            *pixel += change * cell.area();
        }
        self.depth = self.depth.max(cell.depth + 1);
        for part in parts {
            self.keep(part, level);
        }
        change
    }

    fn keep(&mut self, cell: Cell, level: &Level) {
        if self.is_kept(&cell, level) {
            self.cells.push(cell);
        }
    }

    /// Whether a cell is remembered; of one that is never divided, its error is.
    fn is_kept(&mut self, cell: &Cell, level: &Level) -> bool {
        let is_kept = level.keeps(cell);
        if !is_kept {
            let depth = usize::from(cell.depth);
            self.seen[depth] += f64::from(cell.seen);
            self.hidden[depth] += f64::from(cell.hidden);
        }
        is_kept
    }
}

#[cfg(test)]
mod tests {
    use common::Size;

    use super::super::drawn::Drawn;
    use super::super::place::Place;
    use super::*;

    /// A picture of one strip, and how it is painted.
    struct Picture<F> {
        view: Drawn<F>,
        strip: Strip,
        first_row: u32,
        width: u32,
        colors: Vec<Color>,
    }

    impl<F: Fn(Place) -> Color + Sync> Picture<F> {
        fn new(width: u32, rows: Range<u32>, light: F) -> Self {
            Self {
                view: Drawn::new(light),
                first_row: rows.start,
                width,
                colors: vec![Color::BLACK; width as usize * rows.len()],
                strip: Strip::new(rows),
            }
        }

        fn begin(&mut self, level: &Level) {
            let size = Size::new(self.width, self.strip.rows().len() as u32).unwrap();
            let lattice = Lattice::new(size, self.first_row, &self.view).unwrap();
            self.paint(|strip, pixels, view| strip.begin(&lattice, pixels, level, view));
        }

        fn divide(&mut self, level: &Level) {
            self.paint(|strip, pixels, view| strip.divide(pixels, level, view));
        }

        fn paint(&mut self, paint: impl Fn(&mut Strip, &mut Pixels, &Drawn<F>)) {
            let mut pixels = Pixels {
                first_row: self.first_row,
                width: self.width,
                colors: &mut self.colors,
            };
            paint(&mut self.strip, &mut pixels, &self.view);
        }

        /// Checks each pixel by its column and row.
        fn assert_shows(&self, expected: impl Fn(u32, u32) -> Color) {
            let places = self.strip.rows().clone();
            let places = places.flat_map(|y| (0..self.width).map(move |x| (x, y)));
            for (color, (x, y)) in self.colors.iter().zip(places) {
                assert_eq!(*color, expected(x, y), "{x}, {y}");
            }
        }
    }

    /// In pixels.
    fn pixels((x, y): Place) -> (f64, f64) {
        (f64::from(x) / 256.0, f64::from(y) / 256.0)
    }

    /// All cells are due as long as they may be divided.
    fn all_due(samples: u32) -> Level {
        let mut level = Level::unknown(samples, 0.0);
        level.come_down([].iter(), 1.0, 0.0);
        level
    }

    #[test]
    fn a_strip_has_the_pixels_of_its_rows() {
        let mut colors: Vec<_> = (0..6).map(|i| Color::gray(i.into())).collect();
        let mut pixels = Pixels {
            first_row: 10,
            width: 3,
            colors: &mut colors,
        };
        let mut at = |x, y| pixels.get_mut((x, y)).map(|color| color.r);
        assert_eq!([at(0, 10), at(2, 10), at(0, 11)], [0.0, 2.0, 3.0].map(Some));
        assert_eq!([at(3, 10), at(3, 11), at(0, 12)], [None; 3]);
    }

    #[test]
    fn light_that_changes_evenly_is_painted_as_in_the_middles_of_pixels() {
        let ramp = |x: f64, y: f64| Color::new(x, y, 3.0 * x - y);
        let mut picture = Picture::new(37, 7..12, |place| {
            let (x, y) = pixels(place);
            ramp(x, y)
        });
        picture.begin(&Level::unknown(1, 1.0));
        picture.assert_shows(|x, y| ramp(f64::from(x) + 0.5, f64::from(y) + 0.5));
        assert_eq!((picture.strip.samples(), picture.strip.depth()), (0, 1));
    }

    /// The trapezoidal rule with n parts gives x^2 between i and i + 1 as
    /// i^2 + i + 1/3 + 1/(6 n^2). A block is half a part. What is even in x and in y
    /// is exact.
    #[test]
    fn each_division_paints_the_mean_of_the_parts() {
        let mut picture = Picture::new(3, 4..7, |place| {
            let (x, y) = pixels(place);
            Color::new(x * x, y * y, x * y)
        });
        let level = all_due(64);
        picture.begin(&level);
        // 2 x 2 blocks have 16 places, 4 x 4 pixels 56, and so on.
        let expected = [
            (1.0, 0, 4),
            (0.5, 16, 16),
            (0.375, 16 + 56, 64),
            (0.34375, 16 + 56 + 208, 256),
        ];
        for (depth, (rest, samples, cells)) in (0..).zip(expected) {
            let square = |i: u32| f64::from(i * i + i) + rest;
            let middle = |i: u32| f64::from(i) + 0.5;
            picture.assert_shows(|x, y| Color::new(square(x), square(y), middle(x) * middle(y)));
            assert_eq!(picture.strip.samples(), samples);
            assert_eq!(picture.strip.depth(), depth.max(1));
            assert_eq!(picture.strip.cells().len(), cells);
            assert!(picture.strip.cells().iter().all(|cell| cell.depth == depth));
            assert!(picture.strip.is_due(&level));
            picture.divide(&level);
        }
        // More cells than are divided together.
        let square = |i: u32| f64::from(i * i + i) + 1.0 / 3.0 + 1.0 / 384.0;
        for (i, color) in (0_u32..).zip(&picture.colors) {
            assert_eq!(
                *color,
                Color::new(square(i % 3), square(4 + i / 3), color.b)
            );
        }
        assert!(!picture.strip.is_due(&level), "a pixel has 64 samples");
        let painted = picture.colors.clone();
        picture.divide(&level);
        assert_eq!(picture.colors, painted);
        assert_eq!(picture.strip.cells().len(), 1024);
    }

    /// Black at the corners of blocks and white at the others of pixels, of which
    /// each pixel has three.
    fn between_blocks((x, y): Place) -> Color {
        Color::gray(if x % 512 == 0 && y % 512 == 0 {
            0.0
        } else {
            1.0
        })
    }

    #[test]
    fn tiles_that_may_hide_something_are_divided_at_once() {
        let level = Level::unknown(1, 1.0);
        let mut picture = Picture::new(48, 0..16, between_blocks);
        picture.view.hiding = vec![16];
        picture.begin(&level);
        let in_tile = |x: u32| (16..32).contains(&x);
        picture.assert_shows(|x, _| Color::gray(if in_tile(x) { 0.75 } else { 0.0 }));
        // As many as 8 x 8 blocks have.
        assert_eq!(picture.strip.samples(), 208);

        // Two more columns of blocks.
        let mut picture = Picture::new(20, 0..16, between_blocks);
        picture.view.hiding = vec![0, 16];
        picture.begin(&level);
        picture.assert_shows(|_, _| Color::gray(0.75));
        assert_eq!(picture.strip.samples(), 208 + 58);
        assert_eq!(picture.strip.depth(), 1);
    }

    #[test]
    fn nothing_is_divided_once_the_picture_is_not_wanted() {
        let mut picture = Picture::new(2, 0..2, between_blocks);
        let level = all_due(16);
        picture.begin(&level);
        picture.view.stopped = true;
        picture.divide(&level);
        picture.assert_shows(|_, _| Color::BLACK);
        assert_eq!(picture.strip.samples(), 0);
    }

    /// Black on the left, white on the right: (1/12 + 1/120) for 3 channels of 4 pixels.
    #[test]
    fn errors_count_of_cells_that_are_remembered_and_of_others() {
        let near = |error: f64, expected: f64| (error - expected).abs() < 1e-14 * expected;
        for (fair, cells) in [(0.0, 1), (1e3, 0)] {
            let level = Level::unknown(16, fair);
            let mut picture = Picture::new(2, 0..2, |(x, _)| Color::gray(f64::from(x / 512)));
            picture.begin(&level);
            assert_eq!(picture.strip.cells().len(), cells);
            assert!(near(picture.strip.error(&level), 1.1));
        }
    }

    /// Divided twice, the same edge crosses 4 of 16 cells of 1/16. Light bends by 1
    /// around the 8 of its pixels and by 1/2 around the others:
    /// (4/12 + (8 + 8/4)/120) 3/16, and together by the root of two more.
    #[test]
    fn errors_stay_the_same_when_cells_are_forgotten() {
        let mut picture = Picture::new(2, 0..2, |(x, _)| Color::gray(f64::from(x / 512)));
        let level = all_due(16);
        picture.begin(&level);
        picture.divide(&level);
        picture.divide(&level);
        for cells in [16, 0] {
            assert_eq!(picture.strip.cells().len(), cells);
            let off = picture.strip.error(&level) - std::f64::consts::SQRT_2 * 5.0 / 64.0;
            assert!(off.abs() < 1e-14);
            picture.divide(&Level::unknown(16, 1e3));
        }
    }

    /// Three even columns, two pixels wide. Corners bend by 7/8, and the right block
    /// shows as much: it errs by 49/64 x 1.1. The left one shows 1/16.
    #[test]
    fn only_cells_that_err_enough_are_divided_and_the_least_forgotten() {
        let near = |error: f64, expected: f64| (error - expected).abs() < 1e-14;
        let mut picture = Picture::new(4, 0..2, |(x, _)| {
            Color::gray([0.0, 0.0625, 1.0][x as usize / 512])
        });
        let mut level = Level::unknown(16, 0.0);
        picture.begin(&level);
        let (left, right) = (1.0 / 256.0 + 49.0 / 640.0, 49.0 / 64.0 * 1.1);
        assert!(near(picture.strip.error(&level), left + right));

        level.come_down(picture.strip.cells().iter(), left + right, 0.5);
        assert!(picture.strip.is_due(&level));
        picture.divide(&level);
        assert_eq!(picture.strip.samples(), 5);
        let row = [1.0 / 64.0, 3.0 / 64.0, 1.0 / 16.0, 17.0 / 32.0];
        picture.assert_shows(|x, _| Color::gray(row[x as usize]));
        // The corners of the right block and its middles bend by 15/16. Its left parts
        // are even, and are forgotten: below a 32nd of 3/4.
        let places = |strip: &Strip| -> Vec<_> {
            let cells = strip.cells().iter();
            cells.map(|cell| (cell.depth, cell.pixel())).collect()
        };
        let parts = [(1, (3, 0)), (1, (3, 1))];
        assert_eq!(
            places(&picture.strip),
            [&[(0, (0, 0))], &parts[..]].concat()
        );
        let part = 3.0 * 225.0 / 256.0 / 120.0;
        let sum = left + 2.0 * part + 2.0 * 11.0 * part;
        assert!(near(picture.strip.error(&level), sum));
        assert!(!picture.strip.is_due(&level));

        // Nothing is due, and the left block errs by less than a fifth.
        let level = Level::unknown(16, 1.0);
        picture.divide(&level);
        assert_eq!(places(&picture.strip), parts);
        assert!(near(picture.strip.error(&level), sum));
        assert_eq!(picture.strip.samples(), 5);
    }

    /// White from the middle of the lower pixels on. The block changes by 1/4, and so do
    /// these pixels, and of the four cells of each the upper two.
    #[test]
    fn what_divided_cells_show_is_learnt_pixel_by_pixel() {
        let mut picture = Picture::new(2, 0..2, |(_, y)| {
            Color::gray(if y >= 384 { 1.0 } else { 0.0 })
        });
        let level = all_due(16);
        picture.begin(&level);
        for _ in 0..3 {
            picture.divide(&level);
        }
        let factors = Experience::factors([*picture.strip.experience()].iter());
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-14;
        assert!(factors.seen.iter().all(|seen| near(*seen, 1.0 / 12.0)));
        // The two upper pixels look even, and are: (12/120) / (12 + 6).
        assert!(near(factors.hidden[0], 1.0 / 120.0));
        assert!(near(factors.hidden[1], 1.0 / 180.0));
        // (r + 2 x 3/4) / (1 + 2 x 3/8) with the root r of two is 3/7 of the way from r
        // to 2.
        assert!(near(factors.together[0], 1.0 + 2.0 * 3.0 / 7.0));
    }
}
