//! Steps of a transform.

pub use std::f64::consts::{FRAC_PI_2, TAU};
use std::str::SplitWhitespace;

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
    fn read_part(parts: &mut SplitWhitespace) -> Option<Self> {
        Some(match parts.next()? {
            "translate" => Self::Translate(Input::read_part(parts)?),
            "scale" => Self::Scale(Input::read_part(parts)?),
            "rotate" => {
                let axis = parts.next()?;
                let axis = ["x", "y", "z"].iter().position(|name| *name == axis)?;
                Self::Rotate(axis, Input::read_part(parts)?)
            }
            _ => return None,
        })
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
