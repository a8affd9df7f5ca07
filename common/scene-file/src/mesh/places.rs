//! `places`: one number for corners that are at the same place, or so near to each other that
//! rounding alone keeps them apart.

use glam::DVec3;

use super::corner_tree::CornerTree;

/// Two corners are one place within this part of the shortest side that begins or ends at them.
const NEAR: f64 = 1e-3;

/// Sides that are shorter than this part of their triangle's longest side are rounding: the
/// corners at the pole of a globe, which a program computed one by one.
const TINY: f64 = 1e-6;

/// The first corner along this direction takes those near it to its place, so that places do not
/// depend on the order of corners. Its coordinates are in no simple proportion, so that few corners
/// of a grid are beside each other.
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
        // The sum makes 0 of -0, which would be sorted before it.
        .map(|corner| (at(corner).dot(ALONG) + 0.0, corner))
        .collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));

    let none = u32::MAX;
    let mut place_of = vec![none; corners.len()];
    let tree = CornerTree::new(corners, order.iter().map(|(_, corner)| *corner).collect());
    for (_, first) in order {
        if place_of[first as usize] != none {
            continue;
        }
        place_of[first as usize] = first;
        let reach_of_first = reach[first as usize];
        tree.for_each_near(corners[first as usize], reach_of_first, &mut |next| {
            let within = reach_of_first.min(reach[next as usize]);
            if place_of[next as usize] == none && at(first).distance(at(next)) <= within {
                place_of[next as usize] = first;
            }
        });
    }
    place_of
}
