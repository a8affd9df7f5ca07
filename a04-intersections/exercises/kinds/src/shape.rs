//! Asks shapes, ray by ray.

use std::fmt;
use std::sync::Arc;

use a02_math::arrays::array;
use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Triangle};
use testing::exercises::{
    Answer, CodeQuestion, Exercise, Input, Made, Questions, Random, all, random,
};

use crate::rays::{self, RAY, RayWithin, ray_within};

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

/// A shape whose hits this function finds.
pub fn own<F: Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'static>(hit: F) -> OwnShape<F> {
    OwnShape(hit)
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

/// The words for the parts of a ray in [`parts_answer`].
const PARTS: &str = "the parts of it before and behind the hit";

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
    Answer::named("the part that ends there", end_answer(ends_with_hit))
        .and("the part that begins there", end_answer(begins_with_hit))
        .and("the part that ends before, t", part(within.min, t * 0.999))
        .and(
            "the part from just behind, t",
            part(t * (1.0 + 1e-6), within.max),
        )
}

fn end_answer(has_hit: bool) -> Answer {
    Answer::words(if has_hit {
        "a hit at its end"
    } else {
        "no hit at its end"
    })
}

/// The hit of a ray ahead of its origin, for examples.
pub fn hit_from(o: [f64; 3], d: [f64; 3], shape: &dyn Geometry) -> Option<Hit> {
    let (ray, ahead) = ray_within((o, d, 0.0, f64::INFINITY));
    shape.hit(&ray, ahead)
}

/// Shapes of some parameters.
pub struct Shapes<P> {
    /// The parameters in words, with `{}` instead of each.
    pub words: &'static str,
    /// Parameters of round numbers, of a shape near the origin.
    pub first: P,
    /// Further parameters of round numbers, such as of a flat shape along each plane of two axes.
    pub further: Vec<P>,
    /// Points exactly on the first shape. Of a shape whose hits are found by steps, none: there
    /// rounding decides whether a ray from its surface hits it.
    pub on_surface: Vec<[f64; 3]>,
    /// Shapes and rays to them of round numbers, beside those to all shapes.
    pub own_rays: Vec<(P, RayWithin)>,
    /// A point near which a shape of these parameters is.
    pub middle: fn(&P) -> [f64; 3],
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

/// How many random shapes are asked, beside the first one.
const RANDOM: usize = 5;

/// How many times random rays are asked of a shape.
const TIMES: usize = 5;

/// Asks the first shape with simple rays, and some random ones.
pub fn shapes<P: Input + Send + Sync + 'static>(shapes: Shapes<P>) -> Exercise<NewShape<P>> {
    Exercise {
        questions: shapes.questions(),
        ..Exercise::default()
    }
}

impl<P: Input + 'static> Shapes<P> {
    /// Simple rays: to the first shape, the shape's own, from its surface, and to the further shapes.
    fn simple(&self) -> Vec<(P, RayWithin)> {
        let mut simple = Vec::new();
        let mut add = |shape: &P, rays: &[RayWithin]| {
            for ray in rays {
                simple.push((shape.clone(), *ray));
            }
        };
        add(&self.first, &rays::simple());
        for (shape, ray) in &self.own_rays {
            add(shape, &[*ray]);
        }
        add(&self.first, &rays::from_points(&self.on_surface));
        for shape in &self.further {
            add(shape, &rays::few());
        }
        simple
    }

    fn questions(self) -> Vec<CodeQuestion<NewShape<P>>> {
        let Self { words, middle, .. } = self;
        let mut random_rays = Vec::new();
        let mut r = Random::new(2);
        let mut shapes = vec![self.first.clone()];
        shapes.extend(random(self.any).into_iter().take(RANDOM));
        for shape in shapes {
            for _ in 0..TIMES {
                for ray in rays::around(middle(&shape), &mut r) {
                    random_rays.push((shape.clone(), ray));
                }
            }
        }
        let simple = self.simple();
        let hits = Questions {
            words: format!("{words}; {RAY}").leak(),
            simple: simple.clone(),
            others: random_rays.clone(),
            answer: |new: &NewShape<P>, (parameters, ray): (P, RayWithin)| {
                let (ray, within) = ray_within(ray);
                Some(hit_answer(new(parameters).ok()?.hit(&ray, within)))
            },
        };
        let parts = Questions {
            words: format!("{words}; {RAY}, and {PARTS}").leak(),
            simple: simple.into_iter().step_by(3).take(40).collect(),
            others: random_rays.into_iter().step_by(3).collect(),
            answer: |new: &NewShape<P>, (parameters, ray): (P, RayWithin)| {
                let (ray, within) = ray_within(ray);
                Some(parts_answer(&*new(parameters).ok()?, &ray, within))
            },
        };
        all([hits.into(), parts.into()])
    }
}
