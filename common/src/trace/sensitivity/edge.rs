//! The nearest edge beside a number: where a decision changes and the colour jumps.
//!
//! A margin of a decision is smooth, and over half a pixel nearly a parabola. So few places show
//! where it changes its sign, also twice between two of them: a thing that is far thinner than a
//! pixel is found. Where it changes its sign, the colours on both sides are asked whether they jump.

use super::bracket::{Bracket, differ, margin_of, vertex};
use super::{Channels, Margin, Pixel, State, difference, magnitude, minus};

/// A place beside the value of a number at which the colour jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// How far it is from the value: what has to be added to reach it.
    pub distance: f64,
    /// The colour beyond the edge minus the colour before it, seen from the value.
    pub jump: Channels,
}

/// What is known of one side of a value.
pub(super) struct Side {
    /// The farthest displacement; negative on the side of the smaller values.
    pub reach: f64,
    /// The colour there.
    pub far: Channels,
    /// Whether the colour changes on the way.
    pub changes: bool,
    /// The nearest edge.
    pub edge: Option<Edge>,
    /// The displacement of the nearest place at which the slope may jump.
    pub bend: Option<f64>,
}

/// A state at a displacement from the value.
struct Probe {
    offset: f64,
    state: State,
}

/// Places on each side at which margins are looked at.
const PROBES: u32 = 4;
/// How often the search is repeated before an edge that was found.
const SEARCHES: u32 = 4;
/// As many decisions are followed, the nearest ones. More of them change only in coarse pictures, where
/// half a pixel is as wide as objects.
const DECISIONS: usize = 8;
/// The distance from an edge at which the colours are asked for, relative to the reach.
const BESIDE: f64 = 1e-7;
/// A jump of at most this fraction of the colour is none: a byte has 255 steps.
const MIN_JUMP: f64 = 1e-6;
/// A change of at most this fraction of the colour is rounding. It allows some hundred roundings,
/// which a grazing ray can make larger.
const ROUNDING: f64 = 1e-12;

/// Looks at one side of a value, up to a displacement at which the colour is known.
pub(super) fn side(value: f64, center: &State, far: (f64, State), pixel: &dyn Pixel) -> Side {
    let (reach, state) = far;
    let mut side = Side {
        reach,
        far: state.color,
        changes: false,
        edge: None,
        bend: None,
    };
    let search = Search {
        value,
        beside: (BESIDE * reach.abs()).max(16.0 * f64::EPSILON * value.abs()),
        pixel,
    };
    let mut limit = reach;
    for _ in 0..SEARCHES {
        let mut probes = vec![Probe {
            offset: 0.0,
            state: center.clone(),
        }];
        for i in 1..=PROBES {
            let offset = limit * f64::from(i) / f64::from(PROBES);
            if let Some(state) = pixel.state(value + offset) {
                probes.push(Probe { offset, state });
            }
        }
        side.changes |= probes.iter().any(|probe| changes(center, &probe.state));
        let Some(edge) = search.nearest_edge(&probes, &mut side.bend) else {
            break;
        };
        side.edge = Some(edge);
        // Beyond the edge other rays decide. Nearer ones are compared once more.
        limit = edge.distance - search.beside.copysign(reach);
        if limit * reach <= 0.0 {
            break;
        }
    }
    side
}

/// Whether the colours of two states differ by more than rounding.
pub(super) fn changes(a: &State, b: &State) -> bool {
    let scale = magnitude(a.color).max(magnitude(b.color));
    difference(a.color, b.color) > ROUNDING * scale
}

/// A search for places at which margins change their sign.
struct Search<'a> {
    value: f64,
    beside: f64,
    pixel: &'a dyn Pixel,
}

impl Search<'_> {
    /// The nearest edge between the probes; `bend` becomes the nearest place of a bend.
    fn nearest_edge(&self, probes: &[Probe], bend: &mut Option<f64>) -> Option<Edge> {
        let nearest_first = |a: &Bracket, b: &Bracket| a.nearest().total_cmp(&b.nearest());
        let mut brackets = self.brackets(probes);
        brackets.sort_by(nearest_first);
        brackets.truncate(DECISIONS);
        brackets.extend(self.jump_of_color(probes));
        brackets.sort_by(nearest_first);
        let mut nearest: Option<Edge> = None;
        for bracket in brackets {
            let limit = nearest.map_or(f64::INFINITY, |edge| edge.distance.abs());
            if bracket.nearest() >= limit {
                break;
            }
            let offset = self.root(&bracket);
            if bracket.bends && bend.is_none_or(|bend| offset.abs() < bend.abs()) {
                *bend = Some(offset);
            }
            if offset.abs() < limit
                && let Some(edge) = self.edge_at(offset, bracket.ends[1].0)
            {
                nearest = Some(edge);
            }
        }
        nearest
    }

    /// The changes of sign between the probes, also those of margins that change it twice between
    /// two of them.
    fn brackets(&self, probes: &[Probe]) -> Vec<Bracket> {
        let mut brackets = Vec::new();
        for i in 1..probes.len() {
            let [near, far] = [&probes[i - 1], &probes[i]];
            // The third place of the parabola.
            let third = if i > 1 {
                &probes[i - 2]
            } else {
                probes.get(2).unwrap_or(near)
            };
            for margin in &near.state.margins {
                let Some(at_far) = margin_of(&far.state, margin.decision) else {
                    continue;
                };
                let ends = [(near.offset, margin.value), (far.offset, at_far)];
                if differ(margin.value, at_far) {
                    brackets.push(Bracket::new(margin, ends));
                } else if let Some(at_third) = margin_of(&third.state, margin.decision)
                    && let Some(peak) = self.peak(margin, ends, (third.offset, at_third))
                {
                    brackets.push(Bracket::new(margin, [ends[0], peak]));
                    brackets.push(Bracket::new(margin, [peak, ends[1]]));
                }
            }
        }
        brackets
    }

    /// The place between two ends at which a margin has the other sign, as far as the parabola through
    /// a third place shows it.
    fn peak(
        &self,
        margin: &Margin,
        ends: [(f64, f64); 2],
        third: (f64, f64),
    ) -> Option<(f64, f64)> {
        let mut points = [ends[0], ends[1], third];
        for _ in 0..3 {
            let (offset, expected) = vertex(points)?;
            let is_inside = (offset - ends[0].0) * (offset - ends[1].0) < 0.0;
            let least = ends[0].1.abs().min(ends[1].1.abs());
            if !is_inside || !(differ(expected, ends[0].1) || expected.abs() < 0.1 * least) {
                return None;
            }
            let value = self.margin(offset, margin.decision)?;
            if differ(value, ends[0].1) {
                return Some((offset, value));
            }
            points = [ends[0], (offset, value), ends[1]];
        }
        None
    }

    /// The displacement at which the margin of a bracket changes its sign, by halving and by the
    /// line between both ends in turn.
    fn root(&self, bracket: &Bracket) -> f64 {
        let [mut near, mut far] = bracket.ends;
        let shortest = self.beside / 1024.0;
        for i in 0..80 {
            if (far.0 - near.0).abs() <= shortest {
                break;
            }
            let mut offset = near.0 + (far.0 - near.0) / 2.0;
            if i % 3 != 2 && (near.1 - far.1).is_normal() {
                let line = near.0 + (far.0 - near.0) * near.1 / (near.1 - far.1);
                // A little beyond the root, so that the next interval is short.
                let line =
                    line + (shortest / 2.0).copysign(if i % 3 == 0 { far.0 } else { -far.0 });
                if (line - near.0) * (line - far.0) < 0.0 {
                    offset = line;
                }
            }
            let Some(value) = self.margin(offset, bracket.decision) else {
                break;
            };
            if differ(value, near.1) {
                far = (offset, value);
            } else {
                near = (offset, value);
            }
        }
        near.0 + (far.0 - near.0) / 2.0
    }

    /// The edge at a displacement, seen from 0 in the direction of `far`, if the colour jumps there. A
    /// smooth colour, and that of a root, changes as much a little farther on.
    fn edge_at(&self, offset: f64, far: f64) -> Option<Edge> {
        let step = self.beside.copysign(far);
        let color = |times: f64| self.pixel.color(self.value + offset + times * step);
        let [before, at_near, at_far, behind] =
            [color(-3.0)?, color(-1.0)?, color(1.0)?, color(3.0)?];
        let jump = minus(at_far, at_near);
        let scale = magnitude(at_near).max(magnitude(at_far));
        let around = difference(at_near, before) + difference(behind, at_far);
        let is_jump = magnitude(jump) > MIN_JUMP * scale && magnitude(jump) > 2.0 * around;
        is_jump.then_some(Edge {
            distance: offset,
            jump,
        })
    }

    /// The greatest change of colour between two probes, followed while it stays as great in one
    /// half: a jump of which no margin tells, such as that of a shape of one's own.
    fn jump_of_color(&self, probes: &[Probe]) -> Option<Bracket> {
        let change = |pair: &[Probe]| difference(pair[0].state.color, pair[1].state.color);
        let pairs = probes.windows(2).map(|pair| (change(pair), pair));
        let (greatest, pair) = pairs.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let scale = magnitude(pair[0].state.color).max(magnitude(pair[1].state.color));
        if greatest <= MIN_JUMP * scale {
            return None;
        }
        let mut near = (pair[0].offset, pair[0].state.color);
        let mut far = (pair[1].offset, pair[1].state.color);
        while (far.0 - near.0).abs() > self.beside / 1024.0 {
            let offset = near.0 + (far.0 - near.0) / 2.0;
            let color = self.pixel.color(self.value + offset)?;
            let [left, right] = [difference(near.1, color), difference(color, far.1)];
            if left.max(right) < (greatest / 16.0).max(MIN_JUMP * scale) {
                return None;
            }
            if left >= right {
                far = (offset, color);
            } else {
                near = (offset, color);
            }
        }
        // Equal values end the search for the root at once.
        Some(Bracket {
            decision: 0,
            bends: false,
            ends: [(near.0, 0.0), (far.0, 0.0)],
        })
    }

    fn margin(&self, offset: f64, decision: u64) -> Option<f64> {
        margin_of(&self.pixel.state(self.value + offset)?, decision)
    }
}
