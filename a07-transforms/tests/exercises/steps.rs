//! Steps of a transform.

pub use std::f64::consts::{FRAC_PI_2, TAU};

use crate::prelude::*;

/// A step of a transform: the transform alone.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    Translate([f64; 3]),
    Scale([f64; 3]),
    /// About the x, y or z axis, which has this number.
    Rotate(usize, f64),
}

impl Step {
    /// The matrix of the step.
    pub fn matrix(self) -> Mat4x4 {
        self.after(Transform::IDENTITY).matrix()
    }

    /// The matrix that undoes the step.
    pub fn inverse(self) -> Mat4x4 {
        self.after(Transform::IDENTITY).inverse()
    }

    /// A transform with this step chained to it.
    pub fn after(self, t: Transform) -> Transform {
        let chained = match self {
            Self::Translate(to) => t.translate(point(to)),
            Self::Scale([x, y, z]) => t.scale(x, y, z),
            Self::Rotate(0, angle) => t.rotate_x(angle),
            Self::Rotate(1, angle) => t.rotate_y(angle),
            Self::Rotate(_, angle) => t.rotate_z(angle),
        };
        chained.unwrap_or(t)
    }

    /// Four steps.
    pub fn random(random: &mut Random) -> Vec<Self> {
        let mut steps = Vec::new();
        for _ in 0..4 {
            let angle = random.between(-3.0, 3.0);
            steps.push(match random.below(5) {
                0 => Self::Translate(random.triple(3.0)),
                1 => Self::Scale([(); 3].map(|()| random.between(0.3, 3.0))),
                axis => Self::Rotate(axis as usize - 2, angle),
            });
        }
        steps
    }
}

impl Input for Step {
    fn for_each_number(&mut self, f: &mut dyn FnMut(&mut f64)) {
        match self {
            Self::Translate(xyz) | Self::Scale(xyz) => xyz.for_each_number(f),
            Self::Rotate(_, angle) => f(angle),
        }
    }

    fn words(&self) -> Vec<String> {
        vec![match self {
            Self::Translate(by) => format!("translate by {}", by.words().concat()),
            Self::Scale(by) => format!("scale by {}", by.words().concat()),
            Self::Rotate(axis, angle) => {
                let axis = ["x", "y", "z"][*axis];
                format!("rotate about {axis} by {}", angle.words().concat())
            }
        }]
    }
}

/// The transform of a chain of steps.
pub fn transform(steps: &[Step]) -> Transform {
    let mut transform = Transform::IDENTITY;
    for step in steps {
        transform = step.after(transform);
    }
    transform
}
