//! How far off the pixels are, by what their samples have shown.
//!
//! The estimate rests on three things:
//!
//! - Samples that differ. The plain variance of their mean, σ²/n, is too large
//!   for evenly spread samples.
//! - Two halves of the samples, spread independently of each other. A quarter
//!   of the squared difference of their means is the error squared, on average
//!   over many pixels; what it is of σ²/n over all pixels of n samples is the
//!   factor for each of them.
//! - Neighbours. Samples that agree may do so by luck, so half a sample of the
//!   neighbours' light is added to them: a corner of the pixel that the light
//!   of n samples misses is of the order of 1/n, and rare.

use a02_math::Lanes;
use common::{Color, Error, Image};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use super::{Order, Pixel, Row};

/// The share of σ²/n, for each binary logarithm of the number of samples,
/// that is the squared error of the mean.
type Factors = [f64; 32];

/// A sample in the middle of a pixel that a straight edge of height h crosses is
/// off by at most h/2. Two pixels see the edge, and of its square the estimate
/// takes half.
const FACTOR_OF_ONE: f64 = 0.25;

/// The errors of all pixels as far as they are known.
pub struct Estimate {
    width: usize,
    /// The estimated squares, summed over the channels.
    errors: Vec<f64>,
    known: [Known; 32],
}

/// What the pixels have shown of the variance that came to some number of samples,
/// for one binary logarithm of it.
#[derive(Clone, Copy, Debug, Default)]
struct Known {
    pixels: f64,
    /// The sum of their squared errors, by the two halves of their samples.
    errors: f64,
    /// The sum of σ²/n.
    variances: f64,
}

impl Estimate {
    /// Where each pixel has the one sample in its middle.
    pub fn of_middles(image: &Image, rows: &[Row]) -> Result<Self, Error> {
        let size = image.size();
        let mut errors = Vec::new();
        let memory = errors.try_reserve_exact(size.pixels());
        memory.map_err(|_| Error::Memory { size })?;
        errors.resize(size.pixels(), 0.0);
        let mut estimate = Self {
            width: size.width() as usize,
            errors,
            known: [Known::default(); 32],
        };
        estimate.look(image, rows, |_, columns| columns.fill(true));
        Ok(estimate)
    }

    #[cfg(test)]
    pub fn told(width: usize, errors: Vec<f64>) -> Self {
        Self {
            width,
            errors,
            known: [Known::default(); 32],
        }
    }

    /// How many pixels there are.
    pub const fn pixels(&self) -> usize {
        self.errors.len()
    }

    /// The estimated squares of the pixels' errors, summed over the channels, row by
    /// row.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.errors.chunks_exact(self.width)
    }

    /// The sum over all pixels.
    pub fn sum(&self) -> f64 {
        self.rows().map(|row| row.iter().sum::<f64>()).sum()
    }

    /// Looks again at the pixels that have got what was ordered, row by row, and
    /// at those around them; and at all with more than one sample, because more is
    /// known now of what such samples show.
    pub fn renew(&mut self, image: &Image, rows: &[Row], orders: &[Vec<Order>]) {
        for (row, orders) in rows.iter().zip(orders) {
            for order in orders {
                let pixel = row.pixel(order.column);
                self.known[pixel.samples.ilog2() as usize].learn(pixel);
            }
        }
        let width = self.width;
        self.look(image, rows, |y, columns| {
            for (column, chosen) in (0..).zip(&mut *columns) {
                *chosen = rows[y].pixel(column).samples > 1;
            }
            for y in around(y, orders.len()) {
                for order in &orders[y] {
                    let x = order.column as usize;
                    columns[x.saturating_sub(1)..width.min(x + 2)].fill(true);
                }
            }
        });
    }

    /// Estimates the errors of the pixels that `choose` marks in each row.
    fn look(&mut self, image: &Image, rows: &[Row], choose: impl Fn(usize, &mut [bool]) + Sync) {
        let factors = self.factors();
        let width = self.width;
        let colors: Vec<&[Color]> = image.rows().collect();
        let look_at_row = |(y, errors): (usize, &mut [f64])| {
            let mut chosen = vec![false; width];
            choose(y, &mut chosen);
            let around = around(y, colors.len()).map(|y| colors[y]);
            for x in (0..width).filter(|x| chosen[*x]) {
                errors[x] = squared_error(around, x, rows[y].pixel(x as u32), &factors);
            }
        };
        self.errors
            .par_chunks_exact_mut(width)
            .enumerate()
            .for_each(look_at_row);
    }

    fn factors(&self) -> Factors {
        let mut factors = self.known.map(|known| known.factor());
        factors[0] = FACTOR_OF_ONE;
        factors
    }
}

impl Known {
    fn learn(&mut self, pixel: &Pixel) {
        let n = f64::from(pixel.samples);
        let sum = |color: Color| color.channels().iter().sum::<f64>() / (n * n);
        self.pixels += 1.0;
        self.errors += sum(pixel.halves * pixel.halves);
        self.variances += sum(pixel.squares);
    }

    /// The share of σ²/n that is the squared error.
    fn factor(&self) -> f64 {
        // A few pixels may all be lucky: four are added that are not.
        let few = 4.0 / self.pixels;
        let factor = ((self.errors / self.variances).min(1.0) + few) / (1.0 + few);
        if factor.is_finite() { factor } else { 1.0 }
    }
}

/// The rows above, here and below, of so many.
fn around(y: usize, rows: usize) -> [usize; 3] {
    [y.saturating_sub(1), y, (y + 1).min(rows - 1)]
}

fn squared_error(around: [&[Color]; 3], x: usize, pixel: &Pixel, factors: &Factors) -> f64 {
    let (bend, shown_bend) = (
        squared_bend(around, x, |color| color),
        squared_bend(around, x, shown),
    );
    let squares = lanes(pixel.squares);
    let is_quiet = |lanes: Lanes| lanes.simd_eq(Lanes::ZERO).all();
    if is_quiet(shown_bend) && is_quiet(squares) {
        return 0.0;
    }
    let n = f64::from(pixel.samples);
    let factor = Lanes::splat(factors[pixel.samples.ilog2() as usize] / (n * n));
    // Light five times as bright as white shows five times its share, up to white.
    let mut error = (Lanes::splat(0.5) * factor * bend).min(shown_bend);
    if !is_quiet(squares) {
        // Of twice the deviation either way, what a screen shows: where a pixel is
        // brighter than white, its error may not be seen.
        let (mean, variance) = (lanes(around[1][x]), squares * factor);
        let twice = Lanes::splat(2.0) * variance.max(Lanes::ZERO).sqrt();
        let deviation = (shown(mean + twice) - shown(mean - twice)) * Lanes::splat(0.25);
        error += deviation * deviation;
    }
    let [r, g, b, _] = error.to_array();
    // With what is no number the passes would never end.
    (r + g + b).max(0.0)
}

/// Red, green and blue side by side, so that one instruction serves all.
fn lanes(color: Color) -> Lanes {
    Lanes::new([color.r, color.g, color.b, 0.0])
}

/// As a screen shows it.
fn shown(color: Lanes) -> Lanes {
    color.max(Lanes::ZERO).min(Lanes::ONE)
}

/// How far the pixel is from lying evenly between its neighbours, squared: in
/// the one of the four directions that shows most. An even slope has no bend,
/// for it takes no more than one sample.
fn squared_bend(
    [above, here, below]: [&[Color]; 3],
    x: usize,
    scale: impl Fn(Lanes) -> Lanes,
) -> Lanes {
    let (left, right) = (x.saturating_sub(1), (x + 1).min(here.len() - 1));
    let scaled = |color: Color| scale(lanes(color));
    let twice = scaled(here[x]) * Lanes::splat(2.0);
    let pairs = [
        (here[left], here[right]),
        (above[x], below[x]),
        (above[left], below[right]),
        (above[right], below[left]),
    ];
    pairs.into_iter().fold(Lanes::ZERO, |greatest, (a, b)| {
        let bend = scaled(a) + scaled(b) - twice;
        greatest.max(bend * bend)
    })
}

#[cfg(test)]
mod tests {
    use common::Size;

    use super::*;

    fn pixel(samples: u32, squares: f64, halves: f64) -> Pixel {
        Pixel {
            samples,
            squares: Color::gray(squares),
            halves: Color::gray(halves),
        }
    }

    /// Three rows of grey.
    fn around(rows: [[f64; 3]; 3]) -> [[Color; 3]; 3] {
        rows.map(|row| row.map(Color::gray))
    }

    /// The error squared of the pixel in the middle, in one channel.
    fn error(rows: [[f64; 3]; 3], pixel: &Pixel, factor: f64) -> f64 {
        let rows = around(rows);
        squared_error([&rows[0], &rows[1], &rows[2]], 1, pixel, &[factor; 32]) / 3.0
    }

    /// Squares of 0.5 in 4 samples are a variance of 0.5 / 4² of their mean; half
    /// of it counts, 0.125².
    #[test]
    fn samples_that_differ_are_off_by_their_share_of_the_variance() {
        let differing = pixel(4, 0.5, 0.0);
        assert_eq!(error([[0.5; 3]; 3], &differing, 0.5), 0.015_625);
        // Half of it is brighter than white, or all.
        assert_eq!(error([[1.0; 3]; 3], &differing, 0.5), 0.015_625 / 4.0);
        assert_eq!(error([[2.0; 3]; 3], &differing, 0.5), 0.0);
    }

    /// The neighbours are 0.25 brighter on both sides: together 0.5, of whose
    /// square half a sample is one part in 2 · 4², and half of that counts.
    #[test]
    fn neighbours_add_the_light_of_half_a_sample() {
        let alike = pixel(4, 0.0, 0.0);
        let (low, high) = (0.25, 0.5);
        for rows in [
            [[low; 3], [high, low, high], [low; 3]],
            [[low, high, low], [low; 3], [low, high, low]],
            [[high, low, low], [low; 3], [low, low, high]],
            [[low, low, high], [low; 3], [high, low, low]],
        ] {
            assert_eq!(error(rows, &alike, 0.5), 0.25 * 0.5 / 16.0 * 0.5);
        }
        let slope = [[0.0, 0.25, 0.5], [0.25, 0.5, 0.75], [0.5, 0.75, 1.0]];
        assert_eq!(error(slope, &alike, 0.5), 0.0, "an even slope");
        let glaring = [[10.0, 0.0, 10.0]; 3];
        assert_eq!(
            error(glaring, &pixel(1, 0.0, 0.0), 1.0),
            4.0,
            "no more than white"
        );
        assert_eq!(
            error([[f64::NAN; 3]; 3], &pixel(4, 0.5, 0.0), 0.5),
            0.0,
            "no number"
        );
    }

    /// One white pixel: all of its eight neighbours see it, at the border, too,
    /// where they are their own neighbours. Of one sample each 0.25 / 2 counts, of
    /// the square of 1 for the neighbours and of 2 for itself, in three channels.
    #[test]
    fn a_lone_pixel_is_seen_by_all_around_it() {
        let size = Size::new(5, 5).unwrap();
        for (x, y) in [(2, 2), (1, 1), (3, 3), (1, 3), (3, 1)] {
            let mut image = Image::black(size).unwrap();
            image.set(x, y, Color::WHITE);
            let rows = vec![Row::seen_once(5); 5];
            let estimate = Estimate::of_middles(&image, &rows).unwrap();
            let errors = estimate.rows().flatten();
            for (i, error) in (0..).zip(errors) {
                let expected = match (x.abs_diff(i % 5), y.abs_diff(i / 5)) {
                    (0, 0) => 1.5,
                    (0..=1, 0..=1) => 0.375,
                    _ => 0.0,
                };
                assert_eq!(*error, expected, "{x}, {y}: {i}");
            }
            assert_eq!(estimate.sum(), 1.5 + 8.0 * 0.375);
        }
    }

    /// A pixel has become white by four samples that agree: all around it see that,
    /// and of its own bend of 2 half a sample is 4 / (2 · 4²). Another one has, too,
    /// but nobody was told to look.
    #[test]
    fn only_what_has_new_samples_is_looked_at_again() {
        let mut image = Image::black(Size::new(6, 5).unwrap()).unwrap();
        let mut rows = vec![Row::seen_once(6); 5];
        let mut estimate = Estimate::of_middles(&image, &rows).unwrap();
        assert_eq!(estimate.sum(), 0.0);
        image.set(1, 1, Color::WHITE);
        image.set(4, 3, Color::WHITE);
        rows[1].pixel_mut(1).samples = 4;
        let mut orders = vec![Vec::new(); 5];
        orders[1].push(Order {
            column: 1,
            samples: 4,
        });
        estimate.renew(&image, &rows, &orders);
        assert_eq!(estimate.sum(), 8.0 * 0.375 + 3.0 * 4.0 / 32.0);
    }

    /// Four pixels of 4 samples, whose squared half differences are a quarter of
    /// their squares; four more that are taken for unlucky make it 5/8.
    #[test]
    fn the_factor_is_what_the_halves_show_of_the_variance() {
        let factor = |pixels: &[Pixel]| {
            let mut known = Known::default();
            for pixel in pixels {
                known.learn(pixel);
            }
            known.factor()
        };
        assert_eq!(factor(&[]), 1.0, "of nothing");
        assert_eq!(factor(&[pixel(4, 1.0, 0.5); 4]), 0.625);
        assert_eq!(factor(&[pixel(8, 1.0, 2.0)]), 1.0, "no more than all of it");
        // 2 of 4 and 2 of 6 samples: (1/16 + 4/36) / (4/16 + 8/36) = 25/68.
        let pixels = [pixel(4, 4.0, 1.0), pixel(6, 8.0, 2.0)];
        let expected = (25.0 / 68.0 + 2.0) / 3.0;
        assert!((factor(&pixels) - expected).abs() < 4.0 * f64::EPSILON);
    }

    /// Pixels that have come to 4 and to 16 samples; the others have factors that
    /// need no knowledge.
    #[test]
    fn every_number_of_samples_has_its_factor() {
        let image = Image::black(Size::new(2, 1).unwrap()).unwrap();
        let mut rows = [Row::seen_once(2)];
        let mut estimate = Estimate::of_middles(&image, &rows).unwrap();
        for (column, squares) in [(0, 1.0), (1, 4.0)] {
            *rows[0].pixel_mut(column) = pixel(4 << (2 * column), squares, 0.5);
        }
        let order = |column| Order { column, samples: 4 };
        estimate.renew(&image, &rows, &[vec![order(0), order(1)]]);
        let mut expected = [1.0; 32];
        (expected[0], expected[2], expected[4]) = (0.25, 4.25 / 5.0, 4.0625 / 5.0);
        assert_eq!(estimate.factors(), expected);
    }
}
