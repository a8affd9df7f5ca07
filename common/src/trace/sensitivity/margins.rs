//! The margins of the decisions behind a pixel: smooth functions of the numbers of its scene, which
//! change their sign where the lesson decides otherwise.
//!
//! Shapes and lights write theirs into the steps of a trace: how far a ray passes inside of an
//! outline, or a hit inside of a cone of light. Others follow from the values in the steps: which of
//! two hits is nearer, and on which side of a surface the light is.

use crate::steps::{Outcome, Step, StepKind};

/// The margin of a decision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// The decision: by which ray and about what, after which hits. It is the same in the traces of
    /// two scenes that differ in a number, as far as they decide alike.
    pub decision: u64,
    /// Its sign is the decision.
    pub value: f64,
    /// Whether the slope of the colour may jump where the sign changes, and the colour not.
    pub bends: bool,
}

/// Numbers of the parts of a decision, which no object or light has.
const CAMERA: usize = usize::MAX;
const REFLECTED: usize = usize::MAX - 1;
const LIGHT: usize = usize::MAX - 2;
const NEARER: usize = usize::MAX - 3;
const SIDE: usize = usize::MAX - 4;
const MIRRORED: usize = usize::MAX - 5;

/// A decision, and one more part of it. (The hash is Fowler, Noll and Vo's, of whole numbers.)
fn part(decision: u64, number: usize) -> u64 {
    (decision ^ number as u64).wrapping_mul(0x0000_0100_0000_01B3) ^ decision >> 29
}

/// The margins of all decisions of a trace, sorted by the decisions.
#[must_use]
pub fn margins(steps: &[Step]) -> Vec<Margin> {
    let mut walk = Walk::default();
    for step in steps {
        walk.add(step);
    }
    walk.margins.sort_by_key(|margin| margin.decision);
    walk.margins
}

/// What is known of a trace up to a step.
#[derive(Default)]
struct Walk {
    margins: Vec<Margin>,
    /// The rays and hits from the camera on.
    path: u64,
    /// The ray of the tests that follow, and the `t` at which it ends at a light.
    ray: u64,
    end: Option<f64>,
    /// The tests around the present one, with their levels.
    around: Vec<(usize, u64)>,
    /// The tests of the path's last ray that have found a hit, and the nearest of them.
    hits: Vec<(u64, f64)>,
    nearest: u64,
}

impl Walk {
    fn add(&mut self, step: &Step) {
        let number = step.number.unwrap_or(0);
        match step.kind {
            StepKind::Sample => self.path = part(0xCBF2_9CE4_8422_2325, number),
            StepKind::CameraRay => self.follow(CAMERA),
            StepKind::ReflectedRay => self.follow(REFLECTED),
            StepKind::Test => self.add_test(step, number),
            StepKind::Hit => self.add_hit(step),
            StepKind::Light => {
                self.begin_ray(part(part(self.path, LIGHT), number));
                self.add_all(self.ray, &step.margins);
                if let Some([cosine]) = step.value("n·l") {
                    self.push(part(self.ray, SIDE), cosine, true);
                }
            }
            StepKind::ShadowRay => self.end = step.value("end").map(|[end]| end),
            StepKind::ReflectedLight => {
                if let Some([cosine]) = step.value("e·r") {
                    self.push(part(self.ray, MIRRORED), cosine, true);
                }
            }
            _ => (),
        }
    }

    /// Goes on with a ray of the path.
    fn follow(&mut self, kind: usize) {
        self.path = part(self.path, kind);
        self.begin_ray(self.path);
        self.hits.clear();
        self.nearest = 0;
    }

    /// The tests that follow are of this ray.
    fn begin_ray(&mut self, ray: u64) {
        (self.ray, self.end) = (ray, None);
        self.around.clear();
    }

    fn add_test(&mut self, step: &Step, number: usize) {
        self.around.retain(|(level, _)| *level < step.level);
        let outer = self.around.last().map_or(self.ray, |(_, test)| *test);
        let test = part(outer, number);
        self.around.push((step.level, test));
        self.add_all(test, &step.margins);
        let is_ahead = matches!(
            step.outcome,
            Outcome::Hit | Outcome::FartherHit | Outcome::BeyondInterval
        );
        let Some([t]) = step.value("t").filter(|_| is_ahead) else {
            return;
        };
        if let Some(end) = self.end {
            self.push(part(test, NEARER), t - end, false);
            return;
        }
        self.hits.push((test, t));
        let is_in_nearest = outer == self.ray || outer == self.nearest;
        if step.outcome == Outcome::Hit && is_in_nearest {
            self.nearest = test;
        }
    }

    /// The nearest hit: other objects lie behind it.
    fn add_hit(&mut self, step: &Step) {
        let Some([nearest]) = step.value("t") else {
            return;
        };
        for (test, t) in std::mem::take(&mut self.hits) {
            if t != nearest {
                self.push(
                    part(part(test, NEARER), self.nearest as usize),
                    t - nearest,
                    false,
                );
            }
        }
        self.path = part(self.path, self.nearest as usize);
    }

    fn add_all(&mut self, decision: u64, margins: &[f64]) {
        for (index, margin) in margins.iter().enumerate() {
            self.push(part(decision, index), *margin, false);
        }
    }

    fn push(&mut self, decision: u64, value: f64, bends: bool) {
        self.margins.push(Margin {
            decision,
            value,
            bends,
        });
    }
}
