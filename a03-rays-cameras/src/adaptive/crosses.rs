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
