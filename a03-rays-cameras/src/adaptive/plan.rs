//! Which pixels shall have more samples: those whose error falls most for one.

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::estimate::Estimate;
use super::{FEW, Row};

/// So many samples the pixel in this column shall have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    pub column: u32,
    pub samples: u32,
}

/// Chooses how many samples pixels shall have, so that the errors squared are
/// expected to sum up to what is allowed; for each row, what will change.
pub fn plan(rows: &[Row], estimate: &Estimate, allowed: f64, most: u32) -> Vec<Vec<Order>> {
    // All pixels that are far too small to matter may have a hundredth of it.
    let small = 0.01 * allowed / estimate.pixels() as f64;
    let level = level(rows, estimate, small, allowed);
    let wanted = |now: u32, mut error: f64| {
        // Not far ahead of what is known: a few samples show little.
        let most = most.min(grown(now).max(4 * now.min(FEW)));
        let mut wanted = now;
        while error / f64::from(wanted) >= level && grown(wanted) <= most {
            (wanted, error) = (grown(wanted), error * fall(wanted));
        }
        wanted
    };
    let plan_row = |(row, errors): (&Row, &[f64])| {
        let orders = large(errors, small).filter_map(|(column, error)| {
            let now = row.pixel(column).samples;
            let samples = wanted(now, error);
            (samples > now).then_some(Order { column, samples })
        });
        orders.collect()
    };
    rows.par_iter()
        .zip(estimate.rows().collect::<Vec<_>>())
        .map(plan_row)
        .collect()
}

/// The columns of errors that matter.
fn large(errors: &[f64], small: f64) -> impl Iterator<Item = (u32, f64)> {
    let columns = (0..).zip(errors.iter().copied());
    columns.filter(move |(_, error)| *error > small)
}

/// The next number of samples.
const fn grown(samples: u32) -> u32 {
    if samples < FEW {
        FEW
    } else {
        samples.saturating_mul(2)
    }
}

/// What is expected to be left of the error by that many: squared, it falls with
/// n^(-3/2) where an edge crosses a pixel (Mitchell, Consequences of Stratified
/// Sampling in Graphics, 1996).
fn fall(samples: u32) -> f64 {
    if samples < FEW {
        1.0 / 8.0
    } else {
        0.5 * std::f64::consts::FRAC_1_SQRT_2
    }
}

/// The error squared per sample that all pixels must come down to.
///
/// Each step that a pixel may take is put into the bin of its error per sample,
/// with what it takes off the sum. Bins are then emptied from the top, until the
/// rest is allowed.
fn level(rows: &[Row], estimate: &Estimate, small: f64, allowed: f64) -> f64 {
    let mut bins = vec![0.0; bin(f64::INFINITY)];
    let mut sum = estimate.sum();
    for (row, errors) in rows.iter().zip(estimate.rows()) {
        for (column, mut error) in large(errors, small) {
            let mut samples = row.pixel(column).samples;
            while error > small && samples <= u32::MAX / 2 {
                let left = error * fall(samples);
                bins[bin(error / f64::from(samples))] += error - left;
                (samples, error) = (grown(samples), left);
            }
        }
    }
    let mut level = bins.len();
    while sum > allowed && level > 0 {
        level -= 1;
        sum -= bins[level];
    }
    lower_end(level)
}

/// Bins of positive numbers: each power of two has four, by the first two bits
/// behind the point.
const fn bin(number: f64) -> usize {
    (number.to_bits() >> 50) as usize
}

const fn lower_end(bin: usize) -> f64 {
    f64::from_bits((bin as u64) << 50)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pixels with these numbers of samples and errors, two in a row.
    fn estimated(pixels: &[(u32, f64)]) -> (Vec<Row>, Estimate) {
        let rows = pixels.chunks(2).map(|pixels| {
            let mut row = Row::seen_once(2);
            for (column, (samples, _)) in (0..).zip(pixels) {
                row.pixel_mut(column).samples = *samples;
            }
            row
        });
        let errors = pixels.iter().map(|(_, error)| *error).collect();
        (rows.collect(), Estimate::told(2, errors))
    }

    /// An eighth of the error by 4 samples instead of 1; then by 2^(-3/2) with
    /// each doubling, which is an eighth for four times as many.
    #[test]
    fn four_times_as_many_samples_leave_an_eighth_of_the_error() {
        assert_eq!([1, 4, 8].map(grown), [4, 8, 16]);
        assert_eq!(fall(1), 0.125);
        assert!((fall(4) * fall(8) - 0.125).abs() < f64::EPSILON);
    }

    #[test]
    fn bins_are_quarters_of_octaves() {
        for power in [f64::MIN_POSITIVE, 0.25, 1.0, 64.0] {
            for (quarter, end) in (0..).zip([1.0, 1.25, 1.5, 1.75]) {
                assert_eq!(bin(power * end), bin(power) + quarter);
                assert_eq!(bin((power * end).next_down()) + 1, bin(power) + quarter);
                assert_eq!(lower_end(bin(power * (end + 0.2))), power * end);
            }
        }
        assert_eq!(lower_end(bin(f64::INFINITY)), f64::INFINITY);
    }

    /// What is left if each pixel comes down to this error for a sample.
    fn left(pixels: &[(u32, f64)], level: f64) -> f64 {
        let come_down = |(samples, error): &(u32, f64)| {
            let (mut samples, mut error) = (*samples, *error);
            while error >= level * f64::from(samples) {
                (samples, error) = (grown(samples), error * fall(samples));
            }
            error
        };
        pixels.iter().map(come_down).sum()
    }

    /// The level is low enough, and the next one above is not.
    #[test]
    fn the_level_brings_errors_down_to_what_is_allowed_and_little_farther() {
        let samples = [1, 1, 4, 16, 1, 8, 4, 32];
        let pixel = |i: u32| {
            let error = 2.0 * f64::from(i * i) / 40_000.0;
            (samples[i as usize % samples.len()], error)
        };
        let pixels: Vec<_> = (0..200).map(pixel).collect();
        let (rows, estimate) = estimated(&pixels);
        let all = estimate.sum();
        for share in [0.9, 0.5, 0.1, 1e-3, 1e-6] {
            let allowed = share * all;
            let level = level(&rows, &estimate, 1e-12 * allowed, allowed);
            assert!(left(&pixels, level) <= allowed * (1.0 + 1e-9), "{share}");
            let above = lower_end(bin(level) + 1);
            assert!(left(&pixels, above) > allowed * (1.0 - 1e-9), "{share}");
        }
    }

    /// 99 pixels that nobody looks at are together just too much.
    #[test]
    fn what_is_too_small_to_be_looked_at_counts() {
        let level = |large: f64| {
            let mut pixels = [(1, 0.009 / 99.0); 100];
            pixels[50].1 = large;
            let (rows, estimate) = estimated(&pixels);
            level(&rows, &estimate, 0.01 / 100.0, 1.0)
        };
        assert_eq!(level(0.995), 0.875);
        assert_eq!(level(0.99), f64::INFINITY);
    }

    /// From 1 sample on 4 times, then 2 times as many are the most.
    #[test]
    fn a_plan_doubles_the_samples_where_the_error_is_large() {
        let orders = |errors: [f64; 4], now: u32, allowed: f64, most: u32| {
            let (rows, estimate) = estimated(&errors.map(|error| (now, error)));
            let orders = plan(&rows, &estimate, allowed, most);
            let told = |order: &Order| (order.column, order.samples);
            [0, 1].map(|row: usize| orders[row].iter().map(told).collect::<Vec<_>>())
        };
        let first = |samples| [vec![(0, samples)], vec![]];
        let none = [vec![], vec![]];
        let errors = [1.0, 0.0, 0.0, 0.0];
        assert_eq!(orders(errors, 4, 1.0, 99), none);
        assert_eq!(orders(errors, 4, 0.5, 99), first(8));
        assert_eq!(orders(errors, 4, 0.2, 99), first(16));
        assert_eq!(orders(errors, 4, 1e-9, 99), first(16), "no farther");
        assert_eq!(orders(errors, 32, 1e-9, 99), first(64));
        assert_eq!(orders(errors, 32, 1e-9, 63), none);
        assert_eq!(orders(errors, 1, 0.5, 99), first(4));
        assert_eq!(orders(errors, 1, 0.5, 3), none);
        let both = [vec![(0, 8)], vec![(1, 8)]];
        assert_eq!(orders([1.0, 0.0, 0.0, 1.0], 4, 1.0, 99), both);
    }
}
