//! Adaptive sampling: one sample where a pixel needs no more, and many at
//! edges and highlights, until the picture is as exact as it was asked to be.
//!
//! Pass by pass every pixel's error is estimated, and those whose error falls
//! most for a sample get more of them.
//!
//! What no sample and no neighbour shows is not found: an object that lies
//! between the middles of all pixels is missing from the picture.

mod estimate;
mod plan;
mod row;

use common::{Color, Error, Image, Progress, Sampled, Settings};

use estimate::Estimate;
use plan::{Order, plan};
use row::{Pixel, Row};

use crate::render::{TOGETHER, for_each_row};
use crate::{NestedSamples, PixelRandom};

/// The least number of samples of a pixel for which one is too few.
const FEW: u32 = 4;

/// A place in the pixel in some column.
pub type Place = (u32, (f64, f64));

/// Renders the rows that are wanted into a black picture of them; `light` comes
/// from some places in a row. Each part of a picture comes to the bound alone, and
/// so the whole does.
pub fn render(
    image: &mut Image,
    max_error: f64,
    settings: &Settings,
    light: impl Fn(u32, &[Place], &mut Vec<Color>) + Sync,
    progress: &dyn Progress,
) -> Result<(), Error> {
    let (size, first_row) = (image.size(), settings.rows().start);
    let mut rows = vec![Row::seen_once(size.width()); size.height() as usize];

    let paint_middles = |row, colors: &mut [Color], _: &mut Row| {
        let (mut middles, mut seen) = (Vec::new(), Vec::new());
        let mut columns = 0..;
        for colors in colors.chunks_mut(TOGETHER) {
            if progress.stopped() {
                return false;
            }
            middles.clear();
            let columns = columns.by_ref().take(colors.len());
            middles.extend(columns.map(|column| (column, (0.5, 0.5))));
            light(row, &middles, &mut seen);
            colors.copy_from_slice(&seen);
        }
        true
    };
    for_each_row(image, first_row, &mut rows, progress, paint_middles)?;

    // Summed over pixels and channels.
    let allowed = max_error * max_error * 3.0 * size.pixels() as f64;
    let mut estimate = Estimate::of_middles(image, &rows)?;
    while estimate.sum() > allowed {
        let orders = plan(&rows, &estimate, allowed, settings.samples);
        let changing = orders.iter().filter(|row| !row.is_empty()).count();
        if changing == 0 {
            break;
        }
        progress.more_rows(changing as u32);
        let paint_more = |y, colors: &mut [Color], row: &mut Row| {
            let orders = &orders[(y - first_row) as usize];
            let random = |column| PixelRandom::new(settings.seed, column, y);
            let light = |places: &[Place], seen: &mut Vec<Color>| light(y, places, seen);
            paint_orders(orders, colors, row, random, light, progress)
        };
        for_each_row(image, first_row, &mut rows, progress, paint_more)?;
        estimate.renew(image, &rows, &orders);
    }

    let more = rows.iter().flat_map(Row::seen_often).map(|p| p.samples);
    progress.sampled(&Sampled {
        pixels: size.pixels() as u64,
        // The sample in the middle was taken of every pixel.
        samples: size.pixels() as u64 + more.clone().map(u64::from).sum::<u64>(),
        most: more.max().unwrap_or(1),
        squared_error: estimate.sum() / 3.0,
    });
    Ok(())
}

/// Takes the samples that are ordered in a row, those of some pixels together.
/// Returns whether it has any.
fn paint_orders(
    orders: &[Order],
    colors: &mut [Color],
    row: &mut Row,
    random: impl Fn(u32) -> PixelRandom,
    light: impl Fn(&[Place], &mut Vec<Color>),
    progress: &dyn Progress,
) -> bool {
    let (mut places, mut seen) = (Vec::new(), Vec::new());
    let mut orders = orders.iter().peekable();
    let mut changes = false;
    while orders.peek().is_some() {
        if progress.stopped() {
            return false;
        }
        places.clear();
        let mut ends = Vec::new();
        while let Some(order) = orders.next_if(|_| places.len() < TOGETHER) {
            let now = row.pixel(order.column).samples;
            let new = new_places(now, order.samples, random(order.column));
            places.extend(new.map(|place| (order.column, place)));
            ends.push((order, places.len()));
        }
        light(&places, &mut seen);
        let mut start = 0;
        for (order, end) in ends {
            let color = &mut colors[order.column as usize];
            add_samples(color, row.pixel_mut(order.column), &seen[start..end]);
            start = end;
        }
        changes = true;
    }
    changes
}

/// Where the samples of a pixel lie that are wanted and not there yet: one of the
/// first half and one of the second in turn.
fn new_places(samples: u32, wanted: u32, random: PixelRandom) -> impl Iterator<Item = (f64, f64)> {
    let sets = [0, 1].map(|set| NestedSamples::new(&random, set));
    let indices = known(samples) / 2..wanted / 2;
    indices.flat_map(move |index| [sets[0].place(index), sets[1].place(index)])
}

/// How many of a pixel's samples stay: the one in the middle has no half to be in.
const fn known(samples: u32) -> u32 {
    if samples < FEW { 0 } else { samples }
}

/// Adds what was seen at new places to a pixel. All sums are of differences
/// from the mean so far, so that equal samples have a variance of exactly 0.
fn add_samples(color: &mut Color, pixel: &mut Pixel, seen: &[Color]) {
    let mut sum = Color::BLACK;
    let (pairs, _) = seen.as_chunks();
    for [a, b] in pairs {
        let (a, b) = (*a - *color, *b - *color);
        sum += a + b;
        pixel.squares += a * a + b * b;
        pixel.halves += a - b;
    }
    pixel.samples = known(pixel.samples) + seen.len() as u32;
    let n = f64::from(pixel.samples);
    let step = sum.map(|channel| channel / n);
    pixel.squares = pixel.squares - step * step * n;
    *color += step;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of these values all sums are exact. The first of each pair belongs to the
    /// one half, the second to the other.
    #[test]
    fn samples_are_added_to_mean_squares_and_halves() {
        let values = [
            1.0, 0.0, 0.5, 0.25, 0.0, 1.0, 1.0, 0.75, 0.5, 0.0, 0.25, 0.25, 1.0, 0.5, 1.0, 0.5,
        ];
        let random = PixelRandom::new(1, 2, 3);
        let mut places = Vec::new();
        // The sample in the middle, which 0.25 comes from, does not stay.
        let mut color = Color::gray(0.25);
        let mut pixel = Pixel {
            samples: 1,
            ..Pixel::default()
        };
        for (wanted, halves) in [(4, 1.5 - 0.25), (8, 2.5 - 2.0), (16, 5.25 - 3.25)] {
            let known = places.len();
            places.extend(new_places(pixel.samples, wanted, random));
            let seen: Vec<_> = values[known..places.len()]
                .iter()
                .map(|x| Color::gray(*x))
                .collect();
            add_samples(&mut color, &mut pixel, &seen);
            let values = &values[..wanted as usize];
            let mean = values.iter().sum::<f64>() / f64::from(wanted);
            let squares = values.iter().map(|x| (x - mean) * (x - mean)).sum();
            assert_eq!(color, Color::gray(mean));
            assert_eq!(pixel.squares, Color::gray(squares));
            assert_eq!(pixel.halves, Color::gray(halves));
            assert_eq!(pixel.samples, wanted);
        }
        let sets = [0, 1].map(|set| NestedSamples::new(&random, set));
        let expected: Vec<_> = (0..8).flat_map(|i| sets.map(|set| set.place(i))).collect();
        assert_eq!(places, expected);
    }

    /// A pixel shows the number of its column; so many samples come together that
    /// those of some pixels are asked for at once, and of the others later.
    #[test]
    fn every_pixel_gets_the_samples_of_its_own_places() {
        let random = |column| PixelRandom::new(7, column, 0);
        let mut row = Row::seen_once(40);
        let orders: Vec<_> = (0..40)
            .filter(|column| column % 3 != 0)
            .map(|column| Order {
                column,
                samples: if column % 2 == 0 { 4 } else { 16 },
            })
            .collect();
        let mut colors = [Color::BLACK; 40];
        let light = |places: &[Place], seen: &mut Vec<Color>| {
            assert!(places.len() < TOGETHER + 16, "{}", places.len());
            seen.clear();
            seen.extend(
                places
                    .iter()
                    .map(|(column, _)| Color::gray((*column).into())),
            );
        };
        assert!(paint_orders(
            &orders,
            &mut colors,
            &mut row,
            random,
            light,
            &()
        ));
        for (column, color) in (0..).zip(colors) {
            let (shown, samples) = match column % 6 {
                0 | 3 => (0, 1),
                2 | 4 => (column, 4),
                _ => (column, 16),
            };
            assert_eq!(color, Color::gray(shown.into()));
            assert_eq!(row.pixel(column).samples, samples);
            assert_eq!(row.pixel(column).squares, Color::BLACK);
        }
        assert_eq!(row.seen_often().len(), orders.len());
        assert!(!paint_orders(
            &[],
            &mut colors,
            &mut row,
            random,
            light,
            &()
        ));
    }
}
