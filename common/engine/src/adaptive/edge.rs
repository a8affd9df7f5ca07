//! `Edge`: where to look in a cell that an edge crosses.
//!
//! Two corners that look the same lie on one side of it, and so does what is between
//! them. The edge is looked for only where they differ.

use common::Color;

use super::cell::{Cell, Cross, PIXEL_DEPTH, greatest_channel, lanes, mean};

/// What tells one side of an edge from the other.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    corners: [Color; 4],
    /// Lights that differ by less, in all channels, are of the same side.
    same: f32,
}

/// Where a cell is looked at: a bit for each place of its cross.
pub type Places = u8;
/// All of them.
pub const EVERYWHERE: Places = 0b11111;

const ABOVE: usize = 0;
const LEFT: usize = 1;
const MIDDLE: usize = 2;
const RIGHT: usize = 3;
const BELOW: usize = 4;

/// Of what the corners differ by.
const SAME: f32 = 0.25;
/// Smooth light differs by more than it bends, and an edge by as much.
const SMOOTH: f32 = 2.0;
/// Of what could hide in a cell, the corners show at least so much if an edge crosses it.
///
/// Around an edge light bends by the contrast, and corners show the square of that, or half
/// where one is alone. Along a line narrower than cells it bends twice as far, down and up
/// again, and they show no more than a quarter of the square: a line may pass between any
/// two that look the same.
const SHOWN: f32 = 0.3;

impl Edge {
    /// The edge across a pixel, or a part of one, if nothing else is to be seen there.
    pub fn across(cell: &Cell) -> Option<Self> {
        let contrast = cell.contrast();
        let is_smooth = contrast > SMOOTH * cell.bend;
        if cell.depth < PIXEL_DEPTH || is_smooth || cell.seen < SHOWN * cell.hidden {
            return None;
        }
        Some(Self {
            corners: cell.corners,
            same: SAME * contrast,
        })
    }

    // ANCHOR: sides
    /// Where to look first: at sides whose ends differ. The others get the mean.
    pub fn sides(&self, cross: &mut Cross) -> Places {
        let mut places = 0;
        for (side, [one, other]) in self.ends() {
            cross[side] = (one + other) * 0.5;
            places |= Places::from(!self.is_same(one, other)) << side;
        }
        places
    }
    // ANCHOR_END: sides

    /// Where to look once the sides are known.
    ///
    /// At the middle, unless two sides that face each other agree on it. And at sides
    /// whose ends look the same, but nothing beside them: an edge that runs along a side
    /// may have left its ends where they are by chance.
    pub fn rest(&self, cross: &mut Cross) -> Places {
        let [above, left, _, right, below] = *cross;
        let mut places = 0;
        for (side, [one, other]) in self.ends() {
            let beside = match side {
                ABOVE | BELOW => [left, right],
                _ => [above, below],
            };
            let is_alone = beside.iter().all(|next| !self.is_same(*next, cross[side]));
            places |= Places::from(is_alone && self.is_same(one, other)) << side;
        }
        cross[MIDDLE] = match [(above, below), (left, right)].map(|(a, b)| self.is_same(a, b)) {
            [true, true] => mean([above, left, right, below]),
            [true, false] => (above + below) * 0.5,
            [false, true] => (left + right) * 0.5,
            [false, false] => return places | 1 << MIDDLE,
        };
        places
    }

    /// The ends of each side.
    fn ends(&self) -> [(usize, [Color; 2]); 4] {
        let [a, b, c, d] = self.corners;
        [
            (ABOVE, [a, b]),
            (LEFT, [a, c]),
            (RIGHT, [b, d]),
            (BELOW, [c, d]),
        ]
    }

    fn is_same(&self, one: Color, other: Color) -> bool {
        greatest_channel((lanes(one) - lanes(other)).abs()) < self.same
    }
}

#[cfg(test)]
mod tests {
    use super::super::cell::PIXEL;
    use super::super::place::Place;
    use super::*;
    use crate::adaptive::random::PixelRandom;

    /// A pixel, or a part of it, around which light bends by so much.
    fn cell(depth: u8, corners: [f64; 4], bend: f32) -> Cell {
        Cell::new((8, 12), depth, corners.map(Color::gray), bend)
    }

    #[test]
    fn edges_are_looked_for_where_corners_show_as_much_as_light_bends() {
        let is_edge = |depth, corners, bend| Edge::across(&cell(depth, corners, bend)).is_some();
        let (upright, one_corner) = ([0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 0.0, 1.0]);
        for corners in [upright, one_corner] {
            assert!(is_edge(PIXEL_DEPTH, corners, 1.0));
            assert!(is_edge(PIXEL_DEPTH + 3, corners, 1.0));
            assert!(!is_edge(PIXEL_DEPTH - 1, corners, 1.0), "not a pixel");
            assert!(!is_edge(PIXEL_DEPTH, corners, 2.0), "maybe a line");
            assert!(is_edge(PIXEL_DEPTH, corners, 0.5));
            assert!(!is_edge(PIXEL_DEPTH, corners, 0.49), "smooth");
        }
        assert!(!is_edge(PIXEL_DEPTH, [0.5; 4], 1.0), "nothing to be seen");
    }

    /// What is looked at of this edge first, and then if that shows these.
    fn looks(corners: [f64; 4], sides: [f64; 4]) -> (Places, [f64; 4], Places, f64) {
        let contrast = cell(PIXEL_DEPTH, corners, 1.0).contrast();
        let edge = Edge::across(&cell(PIXEL_DEPTH, corners, contrast)).unwrap();
        let mut cross = Cross::default();
        let first = edge.sides(&mut cross);
        let [above, left, _, right, below] = cross.map(|color| color.r);
        let guessed = [above, left, right, below];
        for (side, (seen, guessed)) in [ABOVE, LEFT, RIGHT, BELOW]
            .into_iter()
            .zip(sides.into_iter().zip(guessed))
        {
            cross[side] = Color::gray(if first >> side & 1 != 0 {
                seen
            } else {
                guessed
            });
        }
        let rest = edge.rest(&mut cross);
        (first, guessed, rest, cross[MIDDLE].r)
    }

    const UPRIGHT: Places = 1 << ABOVE | 1 << BELOW;

    #[test]
    fn sides_are_looked_at_whose_ends_differ_and_the_others_get_their_mean() {
        // Shades of the same side: a fifth of what differs most.
        let (first, guessed, ..) = looks([0.0, 1.0, 0.2, 0.8], [0.0; 4]);
        assert_eq!((first, guessed[1], guessed[2]), (UPRIGHT, 0.1, 0.9));
        // A quarter of it differs, and so do two fifths.
        let (first, ..) = looks([0.0, 1.0, 0.25, 0.75], [0.0; 4]);
        assert_eq!(first, UPRIGHT | 1 << LEFT | 1 << RIGHT);
        let (first, ..) = looks([0.0, 0.5, 0.2, 0.3], [0.0; 4]);
        assert_eq!(first, 1 << ABOVE | 1 << LEFT | 1 << RIGHT);
        let (first, guessed, ..) = looks([1.0, 0.0, 0.0, 0.0], [1.0; 4]);
        assert_eq!(first, 1 << ABOVE | 1 << LEFT);
        assert_eq!(guessed[2..], [0.0, 0.0]);
    }

    #[test]
    fn the_middle_is_looked_at_unless_two_sides_agree_on_it() {
        let upright = [0.0, 1.0, 0.0, 1.0];
        let (.., rest, _) = looks(upright, [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(rest, 1 << MIDDLE, "slanted");
        let corner = [1.0, 0.0, 0.0, 0.0];
        let (.., rest, _) = looks(corner, [1.0, 1.0, 0.0, 0.0]);
        assert_eq!(rest, 1 << MIDDLE, "as far as the middles of both sides");
        for sides in [[0.0; 4], [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]] {
            let (.., rest, middle) = looks(corner, sides);
            assert_eq!((rest, middle), (0, 0.0), "{sides:?}");
        }
    }

    #[test]
    fn a_side_that_an_edge_may_run_along_is_looked_at() {
        for (dark, side) in [(0.0, RIGHT), (1.0, LEFT)] {
            let (.., rest, middle) = looks([0.0, 1.0, 0.0, 1.0], [dark, 0.0, 0.0, dark]);
            assert_eq!((rest, middle), (1 << side, dark));
        }
        for (dark, side) in [(0.0, BELOW), (1.0, ABOVE)] {
            let (.., rest, middle) = looks([0.0, 0.0, 1.0, 1.0], [0.0, dark, dark, 0.0]);
            assert_eq!((rest, middle), (1 << side, dark));
        }
    }

    /// What lies on one side of a straight line has no gaps.
    #[test]
    fn of_straight_edges_nothing_is_guessed_wrong() {
        let random = PixelRandom::new(1, 0, 0);
        let (x, y) = (8 * PIXEL, 12 * PIXEL);
        let (mut edges, mut looked) = (0, 0);
        for i in 0..2_000 {
            let [a, b, c] = [0, 1, 2].map(|n| random.uniform(3 * i + n) - 0.5);
            let light = |(px, py): Place| {
                let at = |p: u32, from: u32| f64::from(p - from) / f64::from(PIXEL) - 0.5;
                Color::gray(f64::from(a * at(px, x) + b * at(py, y) > 0.7 * c))
            };
            let ends = [
                (x, y),
                (x + PIXEL, y),
                (x, y + PIXEL),
                (x + PIXEL, y + PIXEL),
            ];
            let cell = Cell::new((8, 12), PIXEL_DEPTH, ends.map(light), 1.0);
            let Some(edge) = Edge::across(&cell) else {
                continue;
            };
            let seen = cell.places().map(light);
            let mut cross = Cross::default();
            for look in [Edge::sides, Edge::rest] {
                let places = look(&edge, &mut cross);
                looked += places.count_ones();
                for place in (0..5).filter(|place| places >> place & 1 != 0) {
                    cross[place] = seen[place];
                }
            }
            assert_eq!(cross, seen);
            edges += 1;
        }
        assert!(edges > 1_000, "{edges}");
        assert!(looked < 3 * edges, "{looked} of {edges}");
    }
}
