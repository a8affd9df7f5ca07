//! Tests of `strip`.

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
            picture.assert_shows(|x, y| Color::new(square(x), square(y), middle(x) + middle(y)));
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
