//! `across`: which sides of triangles continue each other.
//!
//! Side `3 t + i` goes from corner `i` of triangle `t` to the next one, and has the number of the
//! corner where it begins.

use glam::DVec3;

use super::NONE;

/// Two faces with a smaller angle between them, by its cosine, lie on each other: they are the
/// two sides of a sheet, and no surface goes on from one to the other.
const FOLDED: f64 = 0.9;

/// Where more faces than this meet in a side, no two of them continue each other.
const MAX_FACES: usize = 8;

/// For each side the one by which the surface goes on, or [`NONE`]. `places` are those of the
/// corners, whose positions `at` gives; triangles that are none have no sides.
pub(super) fn across(places: &[Option<[u32; 3]>], at: impl Fn(u32) -> DVec3) -> Vec<u32> {
    let mut sides = Vec::new();
    for (triangle, places) in (0..).zip(places) {
        let Some([a, b, c]) = *places else {
            continue;
        };
        for (side, from, to, third) in [(0, a, b, c), (1, b, c, a), (2, c, a, b)] {
            sides.push(Side {
                ends: [from.min(to), from.max(to)],
                number: 3 * triangle + side,
                is_ascending: from < to,
                third,
            });
        }
    }
    sides.sort_unstable_by_key(|side| (side.ends, side.number));
    let mut across = vec![NONE; 3 * places.len()];
    for meeting in sides.chunk_by(|a, b| a.ends == b.ends) {
        if (2..=MAX_FACES).contains(&meeting.len()) {
            pair(meeting, &at, &mut across);
        }
    }
    across
}

/// A side of a triangle between two places.
struct Side {
    ends: [u32; 2],
    number: u32,
    /// Whether it goes from the first of its ends to the second.
    is_ascending: bool,
    /// The place of the corner that it does not touch.
    third: u32,
}

/// Pairs sides between the same ends, first the two whose faces go on most evenly. The
/// direction in which they go round decides only between equals.
fn pair(meeting: &[Side], at: &impl Fn(u32) -> DVec3, across: &mut [u32]) {
    // From the side into the face, perpendicular to the side.
    let into_face = |side: &Side| {
        let [from, to] = side.ends.map(at);
        let along = (to - from).normalize();
        let to_third = at(side.third) - from;
        (to_third - along * to_third.dot(along)).normalize()
    };
    loop {
        let mut best: Option<(f64, u32, u32)> = None;
        for (i, a) in meeting.iter().enumerate() {
            for b in &meeting[i + 1..] {
                if across[a.number as usize] != NONE || across[b.number as usize] != NONE {
                    continue;
                }
                let cosine = into_face(a).dot(into_face(b));
                let goes_the_same_way = a.is_ascending == b.is_ascending;
                let rank = cosine + if goes_the_same_way { 1e-6 } else { 0.0 };
                if cosine < FOLDED && best.is_none_or(|best| rank < best.0) {
                    best = Some((rank, a.number, b.number));
                }
            }
        }
        let Some((_, a, b)) = best else {
            return;
        };
        across[a as usize] = b;
        across[b as usize] = a;
    }
}
