//! `bvh`: boxes, and triangles in both directions, because it culls those that are seen from behind. Rays in
//! the plane of a face of a box are not asked: its documentation says that they miss.

use bvh::aabb::Aabb;
use bvh::ray::Ray;
use corpus::{CASES, Found, Question, Shape};
use nalgebra::{Point3, Vector3};

use crate::{Adapter, nearest, within};

pub const ADAPTER: Adapter = Adapter {
    name: "bvh",
    title: "`bvh` 0.13.0 in doubles, without SIMD",
    cases: CASES,
    ask,
};

fn ask(question: &Question) -> Option<Found> {
    if !question.under.is_empty() {
        return None;
    }
    let (o, d) = (question.origin, question.direction);
    let ray = Ray::new(Point3::from(o), Vector3::from(d));
    // Its distances are lengths.
    let length = Vector3::from(d).norm();
    match &question.shape {
        Shape::Box { low, high } => {
            let is_in_face = |i: usize| d[i] == 0.0 && (o[i] == low[i] || o[i] == high[i]);
            if (0..3).any(is_in_face) {
                return None;
            }
            let aabb = Aabb::with_bounds(Point3::from(*low), Point3::from(*high));
            let ends = ray.intersection_slice_for_aabb(&aabb);
            // From inside, the first of both is 0.
            let surface = ends.map(|(enter, leave)| if enter > 0.0 { enter } else { leave });
            Some(within(question, surface.map(|distance| distance / length)))
        }
        Shape::Triangles(all) => Some(nearest(all.iter().map(|corners| {
            let [a, b, c] = corners.map(Point3::from);
            let front = ray.intersects_triangle(&a, &b, &c).distance;
            let back = ray.intersects_triangle(&a, &c, &b).distance;
            let distance = Some(front.min(back)).filter(|distance| *distance != f64::INFINITY);
            within(question, distance.map(|distance| distance / length))
        }))),
        _ => None,
    }
}
