//! The scene of this stage, drawn with the student's functions: `src/scenes.rs`, compiled
//! with another `Vector3`, which calls them.

use std::cell::Cell;
use std::ops::{Add, Deref, Neg};

use a02_math::{Direction, Normal3, Vector3 as Lesson};
use testing::exercises::Picture;

/// The functions that the vectors of the scene call.
#[derive(Clone, Copy)]
pub struct Functions {
    pub dot: fn(Lesson, Lesson) -> f64,
    pub cross: fn(Lesson, Lesson) -> Lesson,
    pub angle: fn(Lesson, Lesson) -> f64,
    pub reflected: fn(Lesson, Normal3) -> Lesson,
}

/// The functions of the lesson.
pub const LESSON: Functions = Functions {
    dot: |a, b| a.dot(b),
    cross: Lesson::cross,
    angle: Lesson::angle,
    reflected: Lesson::reflected_on,
};

thread_local!(static FUNCTIONS: Cell<Functions> = const { Cell::new(LESSON) });

/// The scene, with the functions that code of a student replaces.
pub fn scene<C: 'static>(functions: fn(&C) -> Functions) -> Picture<C> {
    Picture::scene("vectors", move |code, settings| {
        FUNCTIONS.set(functions(code));
        crate::scenes::vectors(settings.size)
    })
}

/// The vector of the scene.
#[derive(Clone, Copy, Default)]
pub struct Vector3(Lesson);

impl Vector3 {
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self(Lesson::new(x, y, z))
    }

    pub fn cross(self, other: Self) -> Self {
        Self((FUNCTIONS.get().cross)(self.0, other.0))
    }

    pub fn parallelogram_area(self, other: Self) -> f64 {
        self.cross(other).magnitude()
    }

    pub fn projected_on(self, other: Self) -> Option<Self> {
        let dot = FUNCTIONS.get().dot;
        let factor = dot(self.0, other.0) / dot(other.0, other.0);
        factor.is_finite().then(|| Self(other.0 * factor))
    }

    pub fn angle(self, other: Self) -> f64 {
        (FUNCTIONS.get().angle)(self.0, other.0)
    }

    pub fn reflected_on(self, n: Normal3) -> Self {
        Self((FUNCTIONS.get().reflected)(self.0, n))
    }
}

impl Deref for Vector3 {
    type Target = Lesson;

    fn deref(&self) -> &Lesson {
        &self.0
    }
}

impl Add for Vector3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Neg for Vector3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl From<Normal3> for Vector3 {
    fn from(normal: Normal3) -> Self {
        Self(normal.into())
    }
}
