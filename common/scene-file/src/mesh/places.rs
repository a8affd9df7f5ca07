//! `places`: one number for corners that are at the same place, or so near to each other that
//! rounding alone keeps them apart.

use glam::DVec3;

/// Two corners are one place within this part of the shortest side that begins or ends at them.
const NEAR: f64 = 1e-3;

/// Sides that are shorter than this part of their triangle's longest side are rounding: the
/// corners at the pole of a globe, which a program computed one by one.
const TINY: f64 = 1e-6;

/// Corners are compared with those that are near along this direction, of length 1. Its
/// coordinates are in no simple proportion, so that few corners of a grid are beside each other.
const ALONG: DVec3 = DVec3::new(0.726_504, 0.548_422, 0.413_991);

/// For each corner of these triangles the number of its place.
pub(super) fn places(corners: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<u32> {
    let at = |corner: u32| DVec3::from(corners[corner as usize]);
    let mut reach = vec![f64::INFINITY; corners.len()];
    for [a, b, c] in triangles {
        let sides = [(*a, *b), (*b, *c), (*c, *a)];
        let lengths = sides.map(|(from, to)| at(from).distance(at(to)));
        let longest = lengths.into_iter().fold(0.0, f64::max);
        for ((from, to), length) in sides.into_iter().zip(lengths) {
            if length > TINY * longest {
                for corner in [from, to] {
                    let reach = &mut reach[corner as usize];
                    *reach = reach.min(NEAR * length);
                }
            }
        }
    }
    let mut order: Vec<_> = (0..corners.len() as u32)
        .filter(|corner| reach[*corner as usize].is_finite())
        .map(|corner| (at(corner).dot(ALONG), corner))
        .collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));

    let none = u32::MAX;
    let mut place_of = vec![none; corners.len()];
    for (i, (along, first)) in order.iter().enumerate() {
        if place_of[*first as usize] != none {
            continue;
        }
        place_of[*first as usize] = *first;
        let reach_of_first = reach[*first as usize];
        for (next_along, next) in &order[i + 1..] {
            // A little more, because both products are rounded.
            if next_along - along > 1.01 * reach_of_first {
                break;
            }
            let within = reach_of_first.min(reach[*next as usize]);
            if place_of[*next as usize] == none && at(*first).distance(at(*next)) <= within {
                place_of[*next as usize] = *first;
            }
        }
    }
    place_of
}
