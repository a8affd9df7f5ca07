//! The rays of a trace as the camera sees them, for the picture.

use a02_math::{Direction, Point3, Vector3};
use common::steps::Step;
use common::{SeenLine, Size};

use super::drawing::Lines;
use crate::{Camera, View};

/// The pieces of a ray; each is drawn straight, and as hidden or not.
const PIECES: u32 = 24;

/// Most steps of Newton's method. It doubles the right digits in each.
const STEPS: usize = 12;

impl View {
    /// The rays of the first sample of these steps after the camera's, as the camera sees them.
    #[must_use]
    pub fn seen_rays(&self, size: Size, steps: &[Step]) -> Vec<SeenLine> {
        let Lines { lines, named } = Lines::new(steps);
        let eye = named.get("eye").copied();
        let mut seen = Vec::new();
        for line in lines {
            let [from, to] = line.ends;
            if Some(from) == eye {
                continue;
            }
            let point = |i| from + (to - from) * (f64::from(i) / f64::from(PIECES));
            let places: Vec<_> = (0..=PIECES).map(|i| place(self, size, point(i))).collect();
            seen.extend(places.windows(2).filter_map(|ends| {
                let (a, b) = (ends[0]?, ends[1]?);
                Some(SeenLine {
                    ends: [a.0, b.0],
                    is_hidden: a.1 || b.1,
                })
            }));
        }
        seen
    }
}

/// The place of a point in the picture, and whether an object lies before it; none if it is
/// behind the camera.
///
/// Newton's method finds the camera coordinates whose ray comes nearest to the point, for a
/// camera of any type.
fn place(view: &View, size: Size, point: Point3) -> Option<([f64; 2], bool)> {
    let [width, height] = [size.width(), size.height()].map(f64::from);
    let (mut x, mut y) = ((width - 1.0) / 2.0, (height - 1.0) / 2.0);
    let ray_for = |x, y| view.camera.ray_for(size, x, y);
    for _ in 0..STEPS {
        let ray = ray_for(x, y);
        let distance = (point - ray.origin()).dot(ray.direction());
        if distance.is_nan() || distance <= 0.0 {
            return None;
        }
        let at = |x, y| ray_for(x, y).at(distance);
        let error = point - at(x, y);
        if error.magnitude() < 1e-6 * distance {
            // The surface where a ray begins is not before it.
            let nearest = view.world.nearest(&ray);
            let is_hidden = nearest.is_some_and(|(_, t)| t < distance * (1.0 - 1e-4));
            return Some(([x + 0.5, height - 0.5 - y], is_hidden));
        }
        let (right, up): (Vector3, Vector3) =
            (at(x + 1.0, y) - at(x, y), at(x, y + 1.0) - at(x, y));
        let [a, b, c] = [right.dot(right), right.dot(up), up.dot(up)];
        let [r, u] = [right.dot(error), up.dot(error)];
        let determinant = a * c - b * b;
        x += (c * r - b * u) / determinant;
        y += (a * u - b * r) / determinant;
    }
    None
}
