//! Looking at where cells are divided. Neighbours share places, and each is looked at
//! once.

use common::Color;

use super::View;
use super::cell::{Cell, Cross};
use super::edge::{EVERYWHERE, Edge, Places};
use super::place::{number, of_number};
use crate::BATCH;

/// So many cells are divided together: enough that most neighbours are among them,
/// and few enough for the fastest memory.
pub const CELLS: usize = 64;

/// The crosses of up to [`CELLS`] cells, and how many places that took.
pub fn crosses(cells: &[Cell], view: &impl View) -> (Vec<Cross>, u64) {
    let mut crosses = vec![Cross::default(); cells.len()];
    let edges: Vec<_> = cells.iter().map(Edge::across).collect();
    let mut samples = 0;
    let first: fn(&Edge, &mut Cross) -> Places = Edge::sides;
    for (of_edge, of_others) in [(first, EVERYWHERE), (Edge::rest, 0)] {
        let of_cells = edges.iter().zip(&mut crosses);
        let places = of_cells.map(|(edge, cross)| match edge {
            Some(edge) => of_edge(edge, cross),
            None => of_others,
        });
        let wanted = wanted(cells, places);
        samples += look(wanted, crosses.as_flattened_mut(), view);
    }
    (crosses, samples)
}

/// Which places of their crosses the cells want to know: each in the upper bits, and who
/// wants it in the lowest 16.
fn wanted(cells: &[Cell], places: impl Iterator<Item = Places>) -> Vec<u64> {
    let mut wanted = Vec::with_capacity(5 * cells.len());
    for ((i, cell), places) in (0..).step_by(5).zip(cells).zip(places) {
        for (j, place) in (0..).zip(cell.places()) {
            if places >> j & 1 != 0 {
                wanted.push(number(place) << 16 | (i + j));
            }
        }
    }
    wanted
}

/// Looks at all these places, and tells everybody who wants to know. Returns how many
/// they are.
fn look(mut wanted: Vec<u64>, colors: &mut [Color], view: &impl View) -> u64 {
    wanted.sort_unstable();
    let (mut places, mut seen) = (Vec::new(), Vec::new());
    let mut samples = 0;
    let by_place: Vec<&[u64]> = wanted.chunk_by(|a, b| a >> 16 == b >> 16).collect();
    for together in by_place.chunks(BATCH) {
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
    samples
}

#[cfg(test)]
mod tests {
    use super::super::cell::{PIXEL, PIXEL_DEPTH};
    use super::super::drawn::Drawn;
    use super::super::place::Place;
    use super::*;

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
        assert!(together <= BATCH);
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

    /// An upright edge through four pixels, left of their middles: five level sides show
    /// that, and then their left sides are looked at.
    #[test]
    fn cells_with_an_edge_are_looked_at_where_it_may_be() {
        let light = |(x, _): Place| Color::gray(f64::from(x > 8 * PIXEL + PIXEL / 3));
        let corners = [0.0, 1.0, 0.0, 1.0].map(Color::gray);
        let cells = [12, 13, 14, 15].map(|y| Cell::new((8, y), PIXEL_DEPTH, corners, 1.0));
        let view = Drawn::new(light);
        let (crosses, samples) = crosses(&cells, &view);
        for (cross, cell) in crosses.iter().zip(&cells) {
            assert_eq!(*cross, cell.places().map(light));
        }
        assert_eq!((view.asked().0.len(), samples), (5 + 4, 5 + 4));
    }

    #[test]
    fn crosses_are_right_in_the_far_corner_of_the_largest_picture() {
        check(2, 2, (1 << 15) - 8, 16);
    }
}
