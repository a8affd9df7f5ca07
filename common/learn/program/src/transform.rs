//! `Transform`: a chain of steps, whose matrices your function multiplies.

use std::ops::Deref;

use crate::prelude::*;

/// A step of a transform.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    Translate([f64; 3]),
    Scale([f64; 3]),
    /// About the x, y or z axis, which has this number, by an angle in radians.
    Rotate(usize, f64),
}

impl Step {
    pub fn matrix(self) -> Mat4x4 {
        self.after(a07_transforms::Transform::IDENTITY).matrix()
    }

    pub fn inverse(self) -> Mat4x4 {
        self.after(a07_transforms::Transform::IDENTITY).inverse()
    }

    /// The workbook's transform with this step chained to it; without a step that it refuses.
    pub fn after(self, t: a07_transforms::Transform) -> a07_transforms::Transform {
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

#[derive(Debug)]
pub struct Transform {
    matrix: Mat4x4,
    inverse: Mat4x4,
    /// The same by the workbook, for its other functions.
    lesson: a07_transforms::Transform,
}

impl Transform {
    /// The transform by these steps, of which the last is applied first.
    pub fn new(steps: &[Step]) -> Self {
        let [matrix, inverse] = chain(steps);
        let identity = a07_transforms::Transform::IDENTITY;
        Self {
            matrix,
            inverse,
            lesson: steps.iter().fold(identity, |t, step| step.after(t)),
        }
    }

    pub fn matrix(&self) -> Mat4x4 {
        self.matrix
    }

    pub fn inverse(&self) -> Mat4x4 {
        self.inverse
    }

    pub fn ray_to_object(&self, ray: &Ray) -> Ray {
        ray_to_object(self, ray)
    }

    pub fn normal_from_object(&self, n: Normal3) -> Option<Normal3> {
        normal_from_object(self, n)
    }
}

impl Deref for Transform {
    type Target = a07_transforms::Transform;

    fn deref(&self) -> &a07_transforms::Transform {
        &self.lesson
    }
}
