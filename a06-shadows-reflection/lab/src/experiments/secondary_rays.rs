//! Wrong decisions of rays that leave a surface: acne, where it shades itself, and leaks, where
//! a ray passes through an object near it.

use std::ops::RangeInclusive;
use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a04_lab::support::Numbers;
use common::Error;
use measure::Effort;
use measure::experiment::{Axis, Curve, ErrorBound, Experiment, TaskSet, Unit};

use crate::lit_points::{AIM, Aim, Look, SEED, Trial, looks, trials};
use crate::policy::{
    Policy, above_a_thousandth, above_zero, error_bounds, offset, relative, relative_to_t, single,
    stepped,
};
use crate::surface::{SHAPES, Shape, cuboid, plane, sphere, triangle};

pub fn experiments() -> Vec<Experiment<'static>> {
    [
        WrongDecisions {
            name: "acne",
            opposite: Some("leaks"),
            question: "Which rays keep a surface out of its own shadow?",
            parameter: "scene size (units)",
            sets: by_size,
            ..ACNE
        },
        WrongDecisions {
            name: "leaks",
            opposite: Some("acne"),
            question: "Which rays find an object near the surface?",
            parameter: "scene size (units)",
            sets: by_size,
            ..LEAKS
        },
        WrongDecisions {
            name: "acne-of-large-shapes",
            opposite: Some("leaks-of-large-shapes"),
            question: "How large may a shape be?",
            parameter: "size of the shape (sizes of the view)",
            sets: by_ratio,
            ..ACNE
        },
        WrongDecisions {
            name: "leaks-of-large-shapes",
            opposite: Some("acne-of-large-shapes"),
            question: "Which rays find an object near the surface of a large shape?",
            parameter: "size of the shape (sizes of the view)",
            sets: by_ratio,
            // The scale of the triangle is some hundred times this size, and the offset 1e-9 of the
            // view for a scale of 7e4.
            promised: 0.0..=1e2,
            ..LEAKS
        },
        WrongDecisions {
            name: "acne-from-afar",
            opposite: Some("leaks-from-afar"),
            question: "From how far away may the eye look?",
            parameter: "distance of the eye (sizes of the scene)",
            sets: by_distance,
            ..ACNE
        },
        WrongDecisions {
            name: "leaks-from-afar",
            opposite: Some("acne-from-afar"),
            question: "How far away may the eye be?",
            parameter: "distance of the eye (sizes of the scene)",
            sets: by_distance,
            // The offset is 1e-9 sizes at a distance of 7e4.
            promised: 0.0..=1e4,
            ..LEAKS
        },
        WrongDecisions {
            name: "acne-of-needles",
            opposite: Some("leaks-of-needles"),
            question: "How thin may a triangle be?",
            parameter: "longest edge / least height",
            sets: by_aspect,
            ..ACNE
        },
        WrongDecisions {
            name: "leaks-of-needles",
            opposite: Some("acne-of-needles"),
            question: "Which rays find an object near the surface of a needle?",
            parameter: "longest edge / least height",
            sets: by_aspect,
            // The offset is 1e-9 for a scale of 7e4, and a random triangle's is some times this ratio.
            promised: 0.0..=1e2,
            ..LEAKS
        },
    ]
    .map(WrongDecisions::experiment)
    .into()
}

/// Values of the parameter, each with lit points.
pub type Sets = Vec<TaskSet<Trial>>;

/// An experiment on a kind of wrong decision.
pub struct WrongDecisions {
    pub name: &'static str,
    pub question: &'static str,
    pub parameter: &'static str,
    /// Measures at which values of the parameter, and at which points.
    pub sets: fn(Effort) -> Sets,
    pub error: &'static str,
    pub exact: &'static str,
    /// The experiment with the opposite mistake at the same points.
    pub opposite: Option<&'static str>,
    /// The fraction of wrong decisions for a point and a policy.
    pub wrong: fn(&Trial, Policy) -> f64,
    /// The methods that are compared, ours at the end.
    pub methods: &'static [Method],
    /// The parameters at which our rays are never wrong.
    pub promised: RangeInclusive<f64>,
}

/// A rule for rays that leave a hit, with its name.
pub struct Method {
    pub name: &'static str,
    pub policy: Policy,
}

/// The shape is convex and the light outside, but a ray to it hits the shape.
pub const ACNE: WrongDecisions = WrongDecisions {
    name: "",
    question: "",
    parameter: "",
    sets: |_| Vec::new(),
    error: "fraction of shadow rays that hit their own surface",
    exact: "where light arrives",
    opposite: None,
    wrong: |trial, policy| f64::from(trial.shades_itself(policy)),
    methods: &METHODS,
    promised: 0.0..=f64::INFINITY,
};

/// A ray to the light misses an object at one of the distances [`NEAR`].
pub const LEAKS: WrongDecisions = WrongDecisions {
    error: "fraction of shadow rays that miss an object",
    exact: "1e-4 or 1e-9 sizes away",
    wrong: |trial, policy| {
        let leaks = NEAR.map(|near| f64::from(trial.leaks(policy, near)));
        leaks.iter().sum::<f64>() / NEAR.len() as f64
    },
    ..ACNE
};

/// Distances of an object before the light, in sizes of the scene.
pub const NEAR: [f64; 2] = [1e-4, 1e-9];

const THOUSANDTH: Method = Method {
    name: "above 1e-3 (protocol)",
    policy: above_a_thousandth,
};
const ZERO: Method = Method {
    name: "above 0",
    policy: above_zero,
};
const RELATIVE: Method = Method {
    name: "above 1e-9 of the largest",
    policy: relative,
};
const RELATIVE_TO_T: Method = Method {
    name: "above 2e-12 t (pbrt 2)",
    policy: relative_to_t,
};
const STEPPED: Method = Method {
    name: "steps (Wächter, Binder)",
    policy: stepped,
};
const ERROR_BOUNDS: Method = Method {
    name: "error bounds (pbrt 4)",
    policy: error_bounds,
};
const SINGLE: Method = Method {
    name: "offset (single)",
    policy: single,
};
const OURS: Method = Method {
    name: "offset (ours)",
    policy: offset,
};

const METHODS: [Method; 8] = [
    THOUSANDTH,
    ZERO,
    RELATIVE,
    RELATIVE_TO_T,
    STEPPED,
    ERROR_BOUNDS,
    SINGLE,
    OURS,
];

/// The methods for shapes that cannot reproject a point.
pub const FOR_EVERY_SHAPE: [Method; 6] = [THOUSANDTH, ZERO, RELATIVE, RELATIVE_TO_T, STEPPED, OURS];

impl WrongDecisions {
    pub fn experiment(self) -> Experiment<'static> {
        let name = self.name;
        Experiment {
            question: self.question,
            parameter: self.parameter,
            work: "shadow rays",
            against: Axis::Parameter,
            error: self.error,
            unit: Unit::Fraction,
            exact: self.exact,
            opposite: self.opposite,
            seeds: &[SEED],
            curves: Box::new(move |effort| self.curves(effort)),
            ..Experiment::new(name)
        }
    }

    fn curves(&self, effort: Effort) -> Vec<Curve<'static>> {
        let (sets, wrong) = ((self.sets)(effort), self.wrong);
        let mut curves = Vec::new();
        for Method { name, policy } in self.methods {
            let shades_itself = |trial: &Trial| trial.shades_itself(*policy);
            let wrong = |trial: &Trial, _| wrong(trial, *policy);
            curves.push(Curve::of_decisions(name, &sets, shades_itself, wrong));
        }
        if let Some(ours) = curves.last_mut() {
            ours.bound = Some(ErrorBound {
                error: 0.0,
                between: self.promised.clone(),
            });
        }
        curves
    }
}

fn by_size(effort: Effort) -> Sets {
    let mut sets = Vec::new();
    for size in [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6, 1e9] {
        sets.push(TaskSet {
            parameter: size,
            tasks: points(&SHAPES, size, size, AIM, effort),
        });
    }
    sets
}

fn by_ratio(effort: Effort) -> Sets {
    // From above a surface through the origin.
    let above = Aim {
        middle: [0.0, 6.0, 0.0],
        distance: 5.0,
        within: 7.0,
    };
    let mut sets = Vec::new();
    for ratio in [1.0, 1e1, 1e2, 1e3, 1e4, 1e6, 1e9] {
        sets.push(TaskSet {
            parameter: ratio,
            tasks: points(&LARGE, ratio, 1.0, above, effort),
        });
    }
    sets
}

fn by_distance(effort: Effort) -> Sets {
    let mut sets = Vec::new();
    for distance in [5.0, 1e2, 1e4, 1e6, 1e8] {
        let aim = Aim { distance, ..AIM };
        sets.push(TaskSet {
            parameter: distance,
            tasks: points(&SHAPES, 1.0, 1.0, aim, effort),
        });
    }
    sets
}

fn by_aspect(effort: Effort) -> Sets {
    let count = effort.choose(1_024, 16_384);
    let mut sets = Vec::new();
    for aspect in [1.0, 1e2, 1e4, 1e6, 1e8, 1e10] {
        let points = trials(count, SEED, 1.0, |numbers| needle(numbers, aspect));
        sets.push(TaskSet {
            parameter: aspect,
            tasks: points.unwrap_or_default().into(),
        });
    }
    sets
}

/// A look at a point of a needle, which leans or lies along an axis.
fn needle(numbers: &mut Numbers, aspect: f64) -> Result<Look, Error> {
    let (mut along, mut across) = (numbers.direction(), numbers.direction());
    if numbers.below(2) == 0 {
        along = Vector3::new(1.0, 0.0, 0.0);
        across = Vector3::new(0.0, 0.0, 1.0);
    }
    let a = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let tip = along * numbers.between(0.0, 1.0) + across * (1.0 / aspect);
    let (beta, gamma) = (numbers.between(0.0, 0.5), numbers.between(0.0, 0.5));
    let target = a + along * beta + tip * gamma;
    let eye = target + numbers.direction() * 3.0;
    Ok(Look {
        surface: triangle([a, a + along, a + tip])?,
        eye,
        target,
    })
}

/// Lit points of some shapes of a size in a scene of a size; none where a shape fails.
fn points(shapes: &[Shape], size: f64, scene: f64, aim: Aim, effort: Effort) -> Rc<[Trial]> {
    let count = effort.choose(1_024, 16_384);
    let mut points = Vec::new();
    for shape in shapes {
        let of_shape =
            looks(*shape, size, scene, aim).and_then(|look| trials(count, SEED, scene, look));
        match of_shape {
            Ok(of_shape) => points.extend(of_shape),
            Err(_) => return Rc::new([]),
        }
    }
    points.into()
}

/// Surfaces through the origin, of shapes of any size: slanted, and perpendicular to an axis.
const LARGE: [Shape; 6] = [
    |r| sphere(Point3::ORIGIN - NORMAL * r, r),
    |r| plane(Point3::ORIGIN + ALONG * r, NORMAL.as_normal()),
    |r| {
        let up = Vector3::new(0.0, 1.0, 0.0);
        plane(Point3::new(r, 0.0, r), up.as_normal())
    },
    |r| cuboid([-r, -r, -r], [r, 0.1, r]),
    |r| {
        let corners = [ALONG - ACROSS, ALONG + ACROSS, ALONG * -2.0];
        triangle(corners.map(|v| Point3::ORIGIN + v * (20.0 * r)))
    },
    |r| {
        let corners = [[-20.0, -20.0], [20.0, -20.0], [0.0, 20.0]];
        triangle(corners.map(|[x, z]| Point3::new(x * r, 0.0, z * r)))
    },
];

/// Three directions at right angles.
const NORMAL: Vector3 = Vector3::new(2.0 / 7.0, 6.0 / 7.0, 3.0 / 7.0);
const ALONG: Vector3 = Vector3::new(6.0 / 7.0, -3.0 / 7.0, 2.0 / 7.0);
const ACROSS: Vector3 = Vector3::new(3.0 / 7.0, 2.0 / 7.0, -6.0 / 7.0);
