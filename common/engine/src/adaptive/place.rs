//! `Place`: where cells have their corners.

use super::cell::PIXEL;
use crate::adaptive::random::PixelRandom;

/// A column and a row of corners in the picture, in units of the smallest cells.
pub type Place = (u32, u32);

/// Where a ray is sent for a place, in pixels from the upper left corner of the
/// picture: a hair beside it, to a side that the seed decides.
///
/// In many pictures an edge lies exactly between two rows of pixels. All corners there
/// would be on its one side, and one of the rows half a pixel off.
pub(super) fn beside((x, y): Place, seed: u64) -> (f64, f64) {
    let random = PixelRandom::new(seed, x, y);
    let near = |at: u32, n| (f64::from(at) + HAIR * (random.uniform(n) - 0.5)) / f64::from(PIXEL);
    (near(x, 0), near(y, 1))
}

/// So wide, in units of the smallest cells.
const HAIR: f64 = 0.5;

/// A place in one number. In the order of these, neighbours are mostly next to each
/// other, as the digits of both coordinates take turns (Morton, A Computer Oriented
/// Geodetic Data Base, 1966).
pub const fn number((x, y): Place) -> u64 {
    spread(x) | spread(y) << 1
}

/// The place of this number.
pub const fn of_number(number: u64) -> Place {
    (gather(number), gather(number >> 1))
}

/// One digit in two.
const fn spread(digits: u32) -> u64 {
    let x = digits as u64;
    let x = (x | x << 16) & 0x0000_FFFF_0000_FFFF;
    let x = (x | x << 8) & 0x00FF_00FF_00FF_00FF;
    let x = (x | x << 4) & 0x0F0F_0F0F_0F0F_0F0F;
    let x = (x | x << 2) & 0x3333_3333_3333_3333;
    (x | x << 1) & 0x5555_5555_5555_5555
}

/// Every second digit.
const fn gather(x: u64) -> u32 {
    let x = x & 0x5555_5555_5555_5555;
    let x = (x | x >> 1) & 0x3333_3333_3333_3333;
    let x = (x | x >> 2) & 0x0F0F_0F0F_0F0F_0F0F;
    let x = (x | x >> 4) & 0x00FF_00FF_00FF_00FF;
    let x = (x | x >> 8) & 0x0000_FFFF_0000_FFFF;
    (x | x >> 16) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest pictures have 2^15 pixels a side, and those 2^8 of the smallest
    /// cells.
    #[test]
    fn numbers_of_places_take_digits_of_both_in_turn_and_lead_back() {
        let digit = |of: u32, i: u32| u64::from(of >> i & 1);
        let powers = (0..24).map(|i| 1_u32 << i);
        let all: Vec<_> = powers.flat_map(|power| [power - 1, power]).collect();
        for x in all.iter().copied().chain([0xAA_AAAA, (1 << 24) - 1]) {
            for y in all.iter().copied().chain([0x55_5555, (1 << 24) - 1]) {
                let expected = (0..24).map(|i| digit(x, i) << (2 * i) | digit(y, i) << (2 * i + 1));
                assert_eq!(number((x, y)), expected.sum::<u64>(), "{x}, {y}");
                assert_eq!(of_number(number((x, y))), (x, y));
            }
        }
    }

    #[test]
    fn places_of_a_square_follow_each_other() {
        for (x, y) in [(0, 0), (6, 2), (1 << 20, 768)] {
            let square = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
            let first = number(square[0]);
            let next = [first, first + 1, first + 2, first + 3];
            assert_eq!(square.map(number), next);
        }
    }

    /// In units of the smallest cells.
    fn aside((x, y): Place, seed: u64) -> (f64, f64) {
        let (across, down) = beside((x, y), seed);
        (256.0 * across - f64::from(x), 256.0 * down - f64::from(y))
    }

    /// Each corner that is asked for is a hundredth of the square: that one of them has
    /// none of 1000 is less likely than 1 in 5000, and the seed is fixed.
    #[test]
    fn rays_pass_a_place_within_a_quarter_of_the_smallest_cell_on_all_sides() {
        let all: Vec<_> = (0..1000).map(|i| aside((700 * i, 31 * i), 1)).collect();
        let within = |(x, y): &(f64, f64)| x.abs() <= 0.25 && y.abs() <= 0.25;
        assert!(all.iter().all(within));
        for (right, down) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let corner = |(x, y): &(f64, f64)| x * right > 0.2 && y * down > 0.2;
            assert!(all.iter().any(corner), "{right} {down}");
        }
    }

    #[test]
    fn seed_and_place_decide_where_rays_pass() {
        let place = (256, 512);
        assert_eq!(beside(place, 1), beside(place, 1));
        assert_ne!(beside(place, 1), beside(place, 2));
        for other in [(257, 512), (256, 513)] {
            let (a, b) = (aside(place, 1), aside(other, 1));
            assert!((a.0 - b.0).abs() > 1e-6 && (a.1 - b.1).abs() > 1e-6);
        }
    }
}
