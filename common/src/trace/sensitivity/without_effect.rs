//! Numbers without an effect on a pixel, which most numbers of a large scene are. Those of many objects
//! are moved together: if no colour and no decision changes, none of them has an effect.

use std::collections::BTreeMap;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::State;
use super::bracket::{differ, margin_of, vertex};
use super::edge::changes;
use super::moved::Moved;
use crate::Progress;

/// A parabola that comes nearer to 0 than this fraction of its ends may change its sign after all.
const NEAR: f64 = 0.5;

/// The numbers that may have an effect; the others have none.
pub(super) fn effective<'a>(
    center: &State,
    numbers: Vec<Moved<'a>>,
    progress: &dyn Progress,
) -> Vec<Moved<'a>> {
    // The same key of different objects: the decisions about an object do not know the others.
    let mut groups: BTreeMap<String, Vec<Moved>> = BTreeMap::new();
    for moved in numbers {
        let number = moved.number;
        let table = number.table.replace(|c: char| c.is_ascii_digit(), "");
        let group = groups.entry(table + &number.key).or_default();
        group.push(moved);
    }
    let groups = groups.into_values().collect::<Vec<_>>().into_par_iter();
    let effective = groups.flat_map(|group| effective_of(center, group, progress));
    effective.collect()
}

/// Those of a group, by halves.
fn effective_of<'a>(
    center: &State,
    mut group: Vec<Moved<'a>>,
    progress: &dyn Progress,
) -> Vec<Moved<'a>> {
    if progress.stopped() {
        return group;
    }
    let ends = [-1.0, 1.0].map(|side| state(&group, side));
    if let [Some(below), Some(above)] = ends
        && is_calm(center, [&below, &above], group[0].moves_things)
    {
        return Vec::new();
    }
    if group.len() > 1 {
        let second = group.split_off(group.len() / 2);
        let (first, second) = rayon::join(
            || effective_of(center, group, progress),
            || effective_of(center, second, progress),
        );
        group = first;
        group.extend(second);
    }
    group
}

/// The pixel after all numbers of a group have been moved by their reach on one side.
fn state(group: &[Moved], side: f64) -> Option<State> {
    let mut values = Vec::new();
    for Moved { number, reach, .. } in group {
        values.push((*number, number.value + side * reach));
    }
    let first = group.first()?;
    first.state_in(&*first.scene.with(first.settings, &values)?)
}

/// Whether colour and decisions are those of the value itself at both ends, and each margin is so far
/// from 0 that they are also in between.
fn is_calm(center: &State, [below, above]: [&State; 2], moves_things: bool) -> bool {
    if changes(center, below) || changes(center, above) {
        return false;
    }
    if !moves_things {
        return true;
    }
    center.margins.iter().all(|margin| {
        let values = [below, above].map(|state| margin_of(state, margin.decision));
        let [Some(at_below), Some(at_above)] = values else {
            return false;
        };
        let points = [(-1.0, at_below), (0.0, margin.value), (1.0, at_above)];
        let least = points
            .iter()
            .map(|(_, value)| value.abs())
            .fold(f64::INFINITY, f64::min);
        if points.iter().any(|(_, value)| differ(*value, margin.value)) {
            return false;
        }
        let Some((offset, expected)) = vertex(points) else {
            return true;
        };
        let is_inside = offset.abs() < 1.0;
        !is_inside || !differ(expected, margin.value) && expected.abs() >= NEAR * least
    })
}
