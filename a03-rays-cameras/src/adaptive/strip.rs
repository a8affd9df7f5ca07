//! `Strip`: some rows of the picture, whose cells are divided by one thread.

use std::ops::Range;

use common::Color;

use super::View;
use super::block::Block;
use super::cell::{BLOCK, Cell, PIXEL_DEPTH, mean};
use super::crosses::{CELLS, crosses};
use super::experience::{ByDepth, Experience};
use super::lattice::{Lattice, middle};
use super::level::Level;

/// So many rows there are in a strip, and columns in each of its tiles.
pub const TILE: u32 = 16;

/// What is known of the rows.
pub struct Strip<'a> {
    /// The blocks of the picture.
    lattice: &'a Lattice,
    width: u32,
    rows: Range<u32>,
    /// The blocks of which more is known than their corners, ...
    blocks: Vec<Block>,
    /// ... and of each in the rows, row after row, which of these it is.
    known: Vec<Option<u32>>,
    /// The cells that may be divided.
    cells: Vec<Cell>,
    /// Of all cells, what they show and what they could hide.
    seen: ByDepth,
    hidden: ByDepth,
    experience: Experience,
    samples: u64,
    depth: u8,
}

impl<'a> Strip<'a> {
    /// Rows of the picture, of which nothing is known but the lattice.
    pub fn new(lattice: &'a Lattice, width: u32, rows: Range<u32>) -> Self {
        Self {
            lattice,
            width,
            rows,
            blocks: Vec::new(),
            known: vec![None; (TILE / BLOCK) as usize * lattice.cells_in_a_row()],
            cells: Vec::new(),
            seen: ByDepth::default(),
            hidden: ByDepth::default(),
            experience: Experience::default(),
            samples: 0,
            depth: PIXEL_DEPTH,
        }
    }

    /// How many pixels are in each row.
    pub fn width(&self) -> usize {
        self.width as usize
    }

    /// Which rows they are.
    pub fn rows(&self) -> Range<u32> {
        self.rows.clone()
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
        level.sum(&self.seen, &self.hidden)
    }

    /// The cells that may be divided.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Whether any cell is to be divided.
    pub fn is_due(&self, level: &Level) -> bool {
        self.cells.iter().any(|cell| level.is_due(cell))
    }

    /// Paints one of the rows.
    pub fn paint(&self, row: u32, pixels: &mut [Color]) {
        let below_top = row - self.rows.start;
        let known = &self.known[self.index(0, below_top)..];
        let sides = self.lattice.sides(row);
        for ((pixels, block), [left, right]) in
            pixels.chunks_mut(BLOCK as usize).zip(known).zip(sides)
        {
            let colors = match block {
                Some(block) => self.blocks[*block as usize].row(below_top % BLOCK),
                None => [0, 1, 2, 3].map(|pixel| middle(left, right, pixel)),
            };
            pixels.copy_from_slice(&colors[..pixels.len()]);
        }
    }

    /// Takes up the blocks; or smaller cells, where blocks may hide something.
    pub fn begin(&mut self, level: &Level, view: &impl View) {
        let rows = self.rows();
        let tiles = (0..self.width).step_by(TILE as usize);
        let may_hide = |x, depth| view.may_hide((x, rows.start), TILE, narrow(depth));
        let depths = |x| (0..PIXEL_DEPTH).find(|depth| !may_hide(x, *depth));
        let depths: Vec<_> = tiles.map(|x| depths(x).unwrap_or(PIXEL_DEPTH)).collect();

        let mut columns = 0..0;
        for tiles in depths.chunk_by(|a, b| a == b) {
            columns = columns.end..self.width.min(columns.end + TILE * tiles.len() as u32);
            let depth = tiles[0];
            if depth > 0 {
                let part = self.lattice.part(&columns, &rows, depth, view);
                self.samples += part.samples();
                part.for_each_cell(&rows, |cell| {
                    self.show(&cell);
                    self.take_up(cell, level);
                });
            }
        }
        self.lattice.for_each_cell(&rows, |block| {
            if depths[(block.pixel().0 / TILE) as usize] == 0 {
                self.take_up(block, level);
            }
        });
    }

    /// Divides the cells that are due, then those of their parts that are, and so on, so
    /// many times. Returns whether any was.
    pub fn divide(&mut self, times: u8, level: &Level, view: &impl View) -> bool {
        let (mut first, mut any) = (0, false);
        for _ in 0..times {
            let Some(parts) = self.divide_from(first, level, view) else {
                break;
            };
            (first, any) = (parts, true);
        }
        any
    }

    /// Divides those cells that are due from the first one on. Returns from where on their
    /// parts are, behind all others, if any was.
    fn divide_from(&mut self, first: usize, level: &Level, view: &impl View) -> Option<usize> {
        let (before, mut kept, mut any) = (self.cells.len(), first, false);
        let mut due = Vec::with_capacity(CELLS);
        for i in first..before {
            let cell = self.cells[i];
            if level.is_due(&cell) {
                any = true;
                due.push(cell);
            } else if level.keeps(&cell) {
                self.cells[kept] = cell;
                kept += 1;
            }
            if due.len() == CELLS {
                self.divide_all(&due, level, view);
                due.clear();
            }
        }
        self.divide_all(&due, level, view);
        self.cells.drain(kept..before);
        any.then_some(kept)
    }

    fn divide_all(&mut self, cells: &[Cell], level: &Level, view: &impl View) {
        if view.stopped() {
            return;
        }
        let (crosses, samples) = crosses(cells, view);
        self.samples += samples;
        let mut changes = Vec::with_capacity(CELLS);
        for (cell, cross) in cells.iter().zip(&crosses) {
            let parts = cell.divided(cross);
            changes.push((cell, self.show_parts(cell, &parts)));
            self.count(cell, -1.0);
            for part in parts {
                self.take_up(part, level);
            }
        }
        for of_pixel in changes.chunk_by(|(a, _), (b, _)| a.pixel() == b.pixel()) {
            self.experience.learn(of_pixel);
        }
    }

    /// Paints the parts of a cell. Returns by how much its light changes.
    fn show_parts(&mut self, cell: &Cell, parts: &[Cell; 4]) -> Color {
        let change = mean(parts.each_ref().map(Cell::light)) - cell.light();
        if cell.depth < PIXEL_DEPTH {
            for part in parts {
                self.show(part);
            }
        } else {
            let (block, pixel) = self.block(cell);
            *block.pixel(pixel) += change * cell.area();
        }
        self.depth = self.depth.max(cell.depth + 1);
        change
    }

    /// Paints a part of a block that is not smaller than a pixel.
    fn show(&mut self, cell: &Cell) {
        let (block, pixel) = self.block(cell);
        block.show(pixel, cell);
    }

    /// The pixels of the block that a cell lies in, and where it begins there.
    fn block(&mut self, cell: &Cell) -> (&mut Block, (u32, u32)) {
        let (column, row) = cell.pixel();
        let below_top = row - self.rows.start;
        let index = self.index(column / BLOCK, below_top);
        let block = *self.known[index].get_or_insert_with(|| {
            self.blocks.push(Block::default());
            self.blocks.len() as u32 - 1
        });
        let pixel = (column % BLOCK, below_top % BLOCK);
        (&mut self.blocks[block as usize], pixel)
    }

    /// The number of a block in its row, at this row below the top.
    fn index(&self, block: u32, below_top: u32) -> usize {
        (below_top / BLOCK) as usize * self.lattice.cells_in_a_row() + block as usize
    }

    fn take_up(&mut self, cell: Cell, level: &Level) {
        self.count(&cell, 1.0);
        if level.keeps(&cell) {
            self.cells.push(cell);
        }
    }

    /// Counts what a cell shows and could hide so many times.
    fn count(&mut self, cell: &Cell, times: f64) {
        let depth = usize::from(cell.depth);
        self.seen[depth] += times * f64::from(cell.seen);
        self.hidden[depth] += times * f64::from(cell.hidden);
    }
}

/// In pixels: what is so narrow may lie between the corners of all cells of this depth.
/// (A disc is met by one of them if it is the root of two wider than they are.)
fn narrow(depth: u8) -> f64 {
    1.5 * f64::from(BLOCK >> depth)
}

#[cfg(test)]
mod tests {
    use common::Size;

    use super::super::drawn::Drawn;
    use super::super::place::Place;
    use super::*;

    /// A picture of one strip, and what it shows.
    struct Picture<F> {
        view: Drawn<F>,
        strip: Strip<'static>,
    }

    impl<F: Fn(Place) -> Color + Sync> Picture<F> {
        fn new(width: u32, rows: Range<u32>, light: F) -> Self {
            let view = Drawn::new(light);
            let size = Size::new(width, rows.len() as u32).unwrap();
            let lattice = Lattice::new(size, rows.start, &view).unwrap();
            Self {
                view,
                strip: Strip::new(Box::leak(Box::new(lattice)), width, rows),
            }
        }

        fn begin(&mut self, level: &Level) {
            self.strip.begin(level, &self.view);
        }

        fn divide(&mut self, level: &Level) {
            self.strip.divide(1, level, &self.view);
        }

        fn painted(&self) -> Vec<Color> {
            let mut pixels = vec![Color::BLACK; self.strip.width() * self.strip.rows().len()];
            let rows = pixels.chunks_exact_mut(self.strip.width());
            for (row, pixels) in self.strip.rows().zip(rows) {
                self.strip.paint(row, pixels);
            }
            pixels
        }

        /// Checks each pixel by its column and row.
        fn assert_shows(&self, expected: impl Fn(u32, u32) -> Color) {
            let width = self.strip.width() as u32;
            let places = self.strip.rows();
            let places = places.flat_map(|y| (0..width).map(move |x| (x, y)));
            for (color, (x, y)) in self.painted().into_iter().zip(places) {
                assert_eq!(color, expected(x, y), "{x}, {y}");
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
    fn light_that_changes_evenly_is_painted_as_in_the_middles_of_pixels() {
        let ramp = |x: f64, y: f64| Color::new(x, y, 3.0 * x - y);
        let mut picture = Picture::new(37, 7..12, |place| {
            let (x, y) = pixels(place);
            ramp(x, y)
        });
        let expected = |x, y| ramp(f64::from(x) + 0.5, f64::from(y) + 0.5);
        picture.begin(&Level::unknown(1, 1.0));
        picture.assert_shows(expected);
        assert_eq!((picture.strip.samples(), picture.strip.depth()), (0, 2));
        let level = all_due(16);
        picture.begin(&level);
        for _ in 0..4 {
            picture.divide(&level);
            picture.assert_shows(expected);
        }
    }

    /// The trapezoidal rule with n parts gives x^2 between i and i + 1 as
    /// i^2 + i + 1/3 + 1/(6 n^2). What changes evenly is exact; it is there so that no two
    /// corners look the same.
    #[test]
    fn each_division_of_pixels_paints_the_mean_of_the_parts() {
        let mut picture = Picture::new(3, 4..7, |place| {
            let (x, y) = pixels(place);
            Color::new(x * x + 8.0 * x, y * y + 8.0 * y, x + y)
        });
        let level = all_due(64);
        picture.begin(&level);
        // A block has 5 places, 2 x 2 parts have 16, 4 x 4 pixels 56, and so on.
        let expected = [
            (None, 0, 1),
            (None, 5, 4),
            (Some(0.5), 5 + 16, 16),
            (Some(0.375), 5 + 16 + 56, 64),
            (Some(0.34375), 5 + 16 + 56 + 208, 256),
        ];
        for (depth, (rest, samples, cells)) in (0..).zip(expected) {
            if let Some(rest) = rest {
                let middle = |i: u32| f64::from(i) + 0.5;
                let square = |i: u32| f64::from(i * i + i) + rest + 8.0 * middle(i);
                picture
                    .assert_shows(|x, y| Color::new(square(x), square(y), middle(x) + middle(y)));
            }
            assert_eq!(picture.strip.samples(), samples);
            assert_eq!(picture.strip.depth(), depth.max(2));
            assert_eq!(picture.strip.cells().len(), cells);
            assert!(picture.strip.cells().iter().all(|cell| cell.depth == depth));
            assert!(picture.strip.is_due(&level));
            picture.divide(&level);
        }
        // More cells than are divided together.
        let square = |i: u32| f64::from(i * i + 9 * i) + 1.0 / 3.0 + 1.0 / 384.0 + 4.0;
        let painted = picture.painted();
        for (i, color) in (0_u32..).zip(&painted) {
            assert_eq!(
                *color,
                Color::new(square(i % 3), square(4 + i / 3), color.b)
            );
        }
        assert!(!picture.strip.is_due(&level), "a pixel has 64 samples");
        picture.divide(&level);
        assert_eq!(picture.painted(), painted);
        assert_eq!(picture.strip.cells().len(), 1024);
    }

    /// Corners of blocks are at 0 and 4, those of their parts at 2 as well, and between
    /// them x^2 is taken for what lies evenly there.
    #[test]
    fn blocks_and_their_parts_are_painted_evenly_between_their_corners() {
        let mut picture = Picture::new(4, 0..4, |place| {
            let (x, _) = pixels(place);
            Color::gray(x * x)
        });
        let level = all_due(64);
        picture.begin(&level);
        picture.assert_shows(|x, _| Color::gray([2.0, 6.0, 10.0, 14.0][x as usize]));
        picture.divide(&level);
        picture.assert_shows(|x, _| Color::gray([1.0, 3.0, 7.0, 13.0][x as usize]));
    }

    /// Only the right of two blocks is divided.
    #[test]
    fn blocks_that_are_not_divided_show_the_lattice_beside_those_that_are() {
        let mut picture = Picture::new(8, 0..4, |(x, _)| {
            Color::gray(if x > 1024 + 512 { 1.0 } else { 0.0 })
        });
        let mut level = Level::unknown(64, 0.0);
        picture.begin(&level);
        level.come_down(picture.strip.cells().iter(), 100.0, 99.0);
        picture.divide(&level);
        let row = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25, 0.75];
        picture.assert_shows(|x, _| Color::gray(row[x as usize]));
        assert_eq!(picture.strip.samples(), 5);
    }

    /// Black at the corners of blocks and white at all others.
    fn between_blocks((x, y): Place) -> Color {
        Color::gray(if x % 1024 == 0 && y % 1024 == 0 {
            0.0
        } else {
            1.0
        })
    }

    /// One corner of four is black of 2 x 2 pixels, and then in a quarter of all pixels.
    #[test]
    fn where_something_may_hide_cells_are_smaller_and_pixels_if_it_is_narrow() {
        let level = Level::unknown(1, 1.0);
        let one_black = Cell::block(0, 0, [0.0, 1.0, 1.0, 1.0].map(Color::gray), 0.0).light();
        for (narrow, samples) in [(4.0, 9 * 9 - 25), (2.0, 17 * 17 - 25)] {
            let mut picture = Picture::new(48, 0..16, between_blocks);
            picture.view.hiding = vec![(16, narrow)];
            picture.begin(&level);
            let painted = picture.painted();
            for (i, color) in (0_u32..).zip(&painted) {
                let (x, y) = (i % 48, i / 48);
                let beside = |i: u32| [0, 3].contains(&(i % 4));
                let expected = match (16..32).contains(&x) {
                    false => Color::BLACK,
                    true if narrow == 2.0 && beside(x) && beside(y) => one_black,
                    true if narrow == 2.0 => Color::WHITE,
                    // Evenly between the corners of 2 x 2 pixels, of which one is black.
                    true => {
                        let share = |i: u32| if beside(i) { 0.75 } else { 0.25 };
                        Color::gray(1.0 - share(x) * share(y))
                    }
                };
                assert_eq!(*color, expected, "{x}, {y}");
            }
            assert_eq!(picture.strip.samples(), samples);
            assert_eq!(picture.strip.depth(), 2);
        }
        // A quarter of another tile.
        let mut picture = Picture::new(20, 0..16, between_blocks);
        picture.view.hiding = vec![(0, 4.0), (16, 4.0)];
        picture.begin(&level);
        assert_eq!(picture.strip.samples(), 11 * 9 - 6 * 5);
    }

    #[test]
    fn what_is_narrow_is_half_as_wide_again_as_cells() {
        assert_eq!([0, 1, 2].map(narrow), [6.0, 3.0, 1.5]);
    }

    #[test]
    fn nothing_is_divided_once_the_picture_is_not_wanted() {
        let mut picture = Picture::new(4, 0..4, between_blocks);
        let level = all_due(16);
        picture.begin(&level);
        picture.view.stopped = true;
        picture.divide(&level);
        picture.assert_shows(|_, _| Color::BLACK);
        assert_eq!(picture.strip.samples(), 0);
    }

    /// Black on the left, white on the right: (1/12 + 4/120) for 3 channels of 16 pixels,
    /// as a picture may bend by twice that at its ends.
    #[test]
    fn errors_count_of_cells_that_are_remembered_and_of_others() {
        let near = |error: f64, expected: f64| (error - expected).abs() < 1e-14 * expected;
        for (fair, cells) in [(0.0, 1), (1e3, 0)] {
            let level = Level::unknown(16, fair);
            let mut picture = Picture::new(4, 0..4, |(x, _)| Color::gray(f64::from(x / 1024)));
            picture.begin(&level);
            assert_eq!(picture.strip.cells().len(), cells);
            assert!(near(picture.strip.error(&level), 5.6));
        }
    }

    /// White on the right. Divided three times, the edge crosses 8 cells, and light bends
    /// around those on its left.
    #[test]
    fn errors_stay_the_same_when_cells_are_forgotten() {
        let mut picture = Picture::new(4, 0..4, |(x, _)| Color::gray(f64::from(x / 1024)));
        let level = all_due(16);
        picture.begin(&level);
        for _ in 0..3 {
            picture.divide(&level);
        }
        let error = picture.strip.error(&level);
        assert_eq!(picture.strip.cells().len(), 64);
        let cells = picture.strip.cells().iter();
        let sum: f64 = cells.map(|cell| level.error(cell)).sum();
        assert!((error - sum).abs() < 1e-14);
        // Eight cells of a quarter of a pixel, together by the root of two.
        let seen = std::f64::consts::SQRT_2 * 8.0 * 3.0 / 16.0 / 12.0;
        assert!(error > seen && error < 1.5 * seen, "{error} {seen}");
        picture.divide(&Level::unknown(16, 1e3));
        assert!(picture.strip.cells().is_empty());
        assert!((picture.strip.error(&level) - error).abs() < 1e-14);
    }

    /// The first corners bend by twice 1/16 at the end, then by 1/16, 7/8 and 15/16, and the
    /// others are white. The third block shows as much as it bends.
    #[test]
    fn only_cells_that_err_enough_are_divided_and_the_least_forgotten() {
        let near = |error: f64, expected: f64| (error - expected).abs() < 1e-14;
        let mut picture = Picture::new(20, 0..4, |(x, _)| {
            Color::gray([0.0, 0.0, 0.0625, 1.0, 1.0, 1.0][x as usize / 1024])
        });
        let mut level = Level::unknown(16, 0.0);
        picture.begin(&level);
        let (left, right) = (
            1.0 / 160.0 + 4.0 / 256.0 + 49.0 / 160.0,
            225.0 / 256.0 * 4.4,
        );
        assert!(near(picture.strip.error(&level), left + right));

        level.come_down(picture.strip.cells().iter(), left + right, 2.5);
        assert!(picture.strip.is_due(&level));
        picture.divide(&level);
        assert_eq!(picture.strip.samples(), 5);
        // Its corners and its middles bend by 15/16, too. Its left parts are even, and are
        // forgotten as the blocks on its left are: below a quarter of what is divided.
        let places = |strip: &Strip| -> Vec<_> {
            let cells = strip.cells().iter();
            cells.map(|cell| (cell.depth, cell.pixel())).collect()
        };
        let parts = [(1, (10, 0)), (1, (10, 2))];
        assert_eq!(places(&picture.strip), parts);
        let part = 12.0 * 225.0 / 256.0 / 120.0;
        let sum = left + 2.0 * part + 2.0 * 11.0 * part;
        assert!(near(picture.strip.error(&level), sum));
        assert!(!picture.strip.is_due(&level));

        // Nothing is due.
        let level = Level::unknown(16, 2.0);
        picture.divide(&level);
        assert_eq!(places(&picture.strip), parts);
        assert!(near(picture.strip.error(&level), sum));
        assert_eq!(picture.strip.samples(), 5);
    }

    /// White from the middle of the lowest pixels on: each division changes what lies
    /// there by 1/4, and of the parts the lower half.
    #[test]
    fn what_divided_cells_show_is_learnt_pixel_by_pixel() {
        let mut picture = Picture::new(4, 0..4, |(_, y)| {
            Color::gray(if y >= 1024 - 128 { 1.0 } else { 0.0 })
        });
        let level = all_due(16);
        picture.begin(&level);
        for _ in 0..4 {
            picture.divide(&level);
        }
        let factors = Experience::factors([*picture.strip.experience()].iter());
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-14;
        assert!(factors.seen.iter().all(|seen| near(*seen, 1.0 / 12.0)));
        // Weighted by 16 and 4 pixels, cells that look even are, and no more than the
        // upper half bends, each time by half: (48/120) / (48 + 3 x 12 x 2).
        assert!(near(factors.hidden[0], 1.0 / 120.0));
        assert!(factors.hidden[1] < 1.0 / 120.0 && factors.hidden[2] < factors.hidden[1]);
        // (r + 4 x 3/4) / (1 + 4 x 3/8) with the root r of two.
        let step = (std::f64::consts::SQRT_2 + 3.0) / 2.5;
        let level_edge = (step - std::f64::consts::SQRT_2) / (2.0 - std::f64::consts::SQRT_2);
        assert!(near(factors.together[0], 1.0 + 2.0 * level_edge));
    }
}
