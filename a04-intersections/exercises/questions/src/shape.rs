//! Asks shapes, ray by ray.

use std::fmt;
use std::sync::Arc;

use a02_math::arrays::{array, point, vector};
use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Triangle};
use testing::exercises::{Answer, Exercise, Form, Input, Made};

/// A shape of any type.
pub type Shape = Box<dyn Geometry>;

/// Makes a shape of some parameters.
pub type NewShape<P> = Arc<dyn Fn(P) -> Made<Shape> + Send + Sync>;

/// The code that makes shapes by this function.
pub fn new_shape<P, G: Geometry + 'static>(
    new: impl Fn(P) -> Made<G> + Send + Sync + 'static,
) -> NewShape<P> {
    Arc::new(move |parameters| Ok(Box::new(new(parameters)?)))
}

/// A shape whose hits a function finds.
pub struct OwnShape<F>(pub F);

impl<F> fmt::Debug for OwnShape<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Own")
    }
}

impl<F: Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'static> Geometry for OwnShape<F> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0(ray, within)
    }
}

/// A triangle at this height over z = 0 whose corners have a normal that is not its face's.
pub fn smooth_triangle(z: f64) -> Made<Triangle> {
    let corners = [(-2.0, -2.0), (2.0, -2.0), (0.0, 2.0)];
    let [a, b, c] = corners.map(|(x, y)| Point3::new(x, y, z));
    Triangle::new(a, b, c)?.with_normals([Normal3::new(4.0, 1.0, 1.0); 3])
}

/// A hit as an answer.
#[must_use]
pub fn hit_answer(hit: Option<Hit>) -> Answer {
    hit.map_or(Answer::words("no hit"), |hit| {
        Answer::named("t", hit.t)
            .and("normal", array(hit.normal))
            .and("geometric normal", array(hit.geometric_normal))
    })
}

/// The hits in the parts of an interval before and behind the shape's own hit, whichever `t` its
/// formula finds. The ends do not belong to an interval.
#[must_use]
fn parts_answer(shape: &dyn Geometry, ray: &Ray, within: Interval) -> Answer {
    let Some(Hit { t, .. }) = shape.hit(ray, within) else {
        return Answer::words("no hit");
    };
    let part = |min, max| shape.hit(ray, Interval { min, max }).map(|hit| hit.t);
    let ends_with_hit = part(within.min, t).is_some_and(|end| end >= t);
    let begins_with_hit = part(t, within.max).is_some_and(|end| end <= t);
    Answer::named("the hit within (min, t)", end_answer(ends_with_hit))
        .and("the hit within (t, max)", end_answer(begins_with_hit))
        .and("t within (min, 0.999 t)", part(within.min, t * 0.999))
        .and(
            "t within (1.000001 t, max)",
            part(t * (1.0 + 1e-6), within.max),
        )
}

fn end_answer(has_hit: bool) -> Answer {
    Answer::words(if has_hit { "one at t" } else { "none at t" })
}

/// Origin and direction of a ray, and the ends of the interval.
pub type RayWithin = ([f64; 3], [f64; 3], f64, f64);

/// The ray and the interval of an input.
#[must_use]
pub fn ray_within((o, d, min, max): RayWithin) -> (Ray, Interval) {
    (Ray::derived(point(o), vector(d)), Interval { min, max })
}

/// The hit of a ray ahead of its origin, for examples.
pub fn hit_from(o: [f64; 3], d: [f64; 3], shape: &dyn Geometry) -> Option<Hit> {
    let (ray, ahead) = ray_within((o, d, 0.0, f64::INFINITY));
    shape.hit(&ray, ahead)
}

/// An exercise whose file asks shapes of some parameters, ray by ray.
#[must_use]
pub fn shapes<P: Input + Default + 'static>() -> Exercise<NewShape<P>> {
    Exercise {
        forms: hits_and_parts(|new: &NewShape<P>, parameters| new(parameters)),
        ..Exercise::default()
    }
}

/// The answer of a shape about a ray in an interval.
type AnswerOf = fn(&dyn Geometry, &Ray, Interval) -> Answer;

/// The forms of questions that ask a shape of some parameters for its hit, and for the hits before and
/// behind it.
pub fn hits_and_parts<C: 'static, P: Input + Default + 'static>(
    shape: impl Fn(&C, P) -> Made<Shape> + Copy + 'static,
) -> Vec<Form<C>> {
    let hit: AnswerOf = |shape, ray, within| hit_answer(shape.hit(ray, within));
    let forms = [hit, parts_answer].map(|answer| {
        Form::new(move |code: &C, (parameters, ray): (P, RayWithin)| {
            let (ray, within) = ray_within(ray);
            Some(answer(&*shape(code, parameters).ok()?, &ray, within))
        })
    });
    forms.into()
}
