//! Looking at where cells are divided. Neighbours share places, and each is looked at
//! once.

use super::View;
use super::cell::{Cell, Cross};
use super::place::{number, of_number};
use crate::render::TOGETHER;

/// So many cells are divided together: enough that most neighbours are among them,
/// and few enough for the fastest memory.
pub const CELLS: usize = 64;

/// The crosses of up to [`CELLS`] cells, and how many places that took.
pub fn crosses(cells: &[Cell], view: &impl View) -> (Vec<Cross>, u64) {
    // A place in the upper bits, and who wants it in the lowest 16.
    let mut wanted = Vec::with_capacity(5 * cells.len());
    for (i, cell) in (0_u64..).zip(cells) {
        for (j, place) in (0..).zip(cell.places()) {
            wanted.push(number(place) << 16 | (5 * i + j));
        }
    }
    wanted.sort_unstable();

    let mut crosses = vec![Cross::default(); cells.len()];
    let colors = crosses.as_flattened_mut();
    let (mut places, mut seen) = (Vec::new(), Vec::new());
    let mut samples = 0;
    let by_place: Vec<&[u64]> = wanted.chunk_by(|a, b| a >> 16 == b >> 16).collect();
    for together in by_place.chunks(TOGETHER) {
        places.clear();
        places.extend(together.iter().map(|same| of_number(same[0] >> 16)));
        view.light(&places, &mut seen);
        samples += places.len() as u64;
        for (same, color) in together.iter().zip(&seen) {
            for wanted in *same {
                colors[usize::from(*wanted as u16)] = *color;
            }
        }
    }
    (crosses, samples)
}

#[cfg(test)]
mod tests {
    use super::super::drawn::Drawn;
    use super::super::place::Place;
    use super::*;
    use common::Color;

    fn light((x, y): Place) -> Color {
        Color::new(x.into(), y.into(), 0.5)
    }

    /// Checks the crosses of blocks that touch, from this column and row on, and how
    /// many places they have.
    fn check(columns: u32, rows: u32, from: u32, places: usize) {
        let blocks =
            (0..columns).flat_map(|x| (0..rows).map(move |y| (from + 4 * x, from + 4 * y)));
        let blocks: Vec<_> = blocks
            .map(|(x, y)| Cell::block(x, y, [Color::BLACK; 4], 0.0))
            .collect();
        let view = Drawn::new(light);
        let (crosses, samples) = crosses(&blocks, &view);
        assert_eq!(crosses.len(), blocks.len());
        for (cross, block) in crosses.iter().zip(&blocks) {
            assert_eq!(*cross, block.places().map(light));
        }
        let (mut asked, together) = view.asked();
        assert_eq!((asked.len(), samples), (places, places as u64));
        assert!(together <= TOGETHER);
        asked.dedup();
        assert_eq!(asked.len(), places, "none twice");
    }

    /// n x m blocks have n m middles, n (m + 1) level sides and (n + 1) m upright ones.
    #[test]
    fn places_that_neighbours_share_are_looked_at_once() {
        check(0, 0, 0, 0);
        check(1, 1, 0, 5);
        check(2, 2, 0, 16);
        check(8, 8, 0, 64 + 72 + 72);
        check(64, 1, 0, 64 + 128 + 65);
    }

    #[test]
    fn crosses_are_right_in_the_far_corner_of_the_largest_picture() {
        check(2, 2, (1 << 15) - 8, 16);
    }
}
