//! The intersection of a line and a sphere.
//!
//! All formulas here have the same terms, and differ in how they take the roots: the lesson's,
//! which no cancellation spoils; the same with one term in twice as many digits; and the plain one,
//! for numbers that have digits to spare.

use measure::exact::DoubleDouble;

use crate::line::Line;
use crate::number::{Number, Triple, difference, dot};

/// A line towards a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereQuery<N = f64> {
    pub center: Triple<N>,
    pub radius: N,
    pub line: Line<N>,
}

impl SphereQuery {
    /// The query in numbers of another type.
    pub fn to<N: Number>(&self) -> SphereQuery<N> {
        SphereQuery {
            center: self.center.map(N::of),
            radius: N::of(self.radius),
            line: self.line.to(),
        }
    }
}

impl<N: Number> SphereQuery<N> {
    /// From the centre to the origin of the line.
    pub fn from_center(&self) -> Triple<N> {
        difference(&self.line.origin, &self.center)
    }
}

/// The numbers from which both roots follow.
#[derive(Clone, Copy, Debug)]
pub struct Terms<N> {
    /// The square of the direction's length, `d · d`.
    pub a: N,
    /// The `t` of the point that is nearest to the centre.
    pub middle: N,
    /// The square of the distance of this point from the centre, `l · l`.
    pub beside: N,
    /// `r² - l · l`: negative for a line that misses.
    pub discriminant: N,
}

/// The terms of a line in the direction `d` and a sphere of radius `r`, given the vector `f` from
/// the centre to the origin of the line.
///
/// The discriminant is small only where the line passes near the rim, from however far away: unlike
/// the usual one, `(f · d)² - d · d (f · f - r²)`, it is no difference of two numbers that are huge
/// far from the sphere (Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems, 2019, chapter 7).
pub fn terms<N: Number>(f: &Triple<N>, r: N, d: &Triple<N>) -> Terms<N> {
    let a = dot(d, d);
    let middle = -dot(f, d) / a;
    let l = [0, 1, 2].map(|axis| f[axis] + d[axis] * middle);
    let beside = dot(&l, &l);
    Terms {
        a,
        middle,
        beside,
        discriminant: r * r - beside,
    }
}

impl<N: Number> Terms<N> {
    /// Both roots in order, for a discriminant that is not negative. For a sphere that is huge or
    /// contains the origin, one of them is the difference of two numbers that are nearly equal.
    pub fn plain_roots(&self) -> [N; 2] {
        let half = (self.discriminant / self.a).sqrt();
        [self.middle - half, self.middle + half]
    }
}

impl Terms<f64> {
    /// The least positive root, given the power of the origin, `f · f - r²`. The root of greater
    /// magnitude is a sum; the other follows from the product of both, which is the power over `a`.
    fn stable_root(&self, power: f64) -> Option<f64> {
        if self.discriminant < 0.0 {
            return None;
        }
        let half = (self.discriminant / self.a).sqrt();
        let greater = if self.middle < 0.0 {
            self.middle - half
        } else {
            self.middle + half
        };
        let other = power / (self.a * greater);
        let (near, far) = if other < greater {
            (other, greater)
        } else {
            (greater, other)
        };
        [near, far].into_iter().find(|t| *t > 0.0)
    }
}

/// The formula of the lesson.
pub fn stable(query: &SphereQuery) -> Option<f64> {
    let (f, r) = (query.from_center(), query.radius);
    let power = dot(&f, &f) - r * r;
    terms(&f, r, &query.line.direction).stable_root(power)
}

/// The formula of the lesson with `f · f - r²` in twice as many digits: near a huge
/// sphere this is the difference of two huge numbers.
pub fn compensated(query: &SphereQuery) -> Option<f64> {
    let exact = query.to::<DoubleDouble>();
    let (f, r) = (exact.from_center(), exact.radius);
    let power = dot(&f, &f) - r * r;
    let rounded = f.map(DoubleDouble::value);
    terms(&rounded, query.radius, &query.line.direction).stable_root(power.value())
}
