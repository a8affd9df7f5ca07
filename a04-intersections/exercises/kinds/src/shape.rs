//! Asks shapes, ray by ray.

use std::fmt;
use std::sync::Arc;

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Triangle};
use a04_lab::search::{INPUTS, SUBJECTS, Subject};
use common::Error;
use testing::exercises::{
    Answer, Exercise, Input, Made, Questions, Random, Variant, random, searched,
};

use crate::rays::{self, Found, RAY, RayWithin, ray_within};

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
            .and("normal", hit.normal.to_glam().to_array())
            .and(
                "geometric normal",
                hit.geometric_normal.to_glam().to_array(),
            )
    })
}

/// The hit with its normals turned, if this one of them looks along the ray.
#[must_use]
pub fn turned(mut hit: Hit, by: Normal3, ray: &Ray) -> Hit {
    if by.dot(ray.direction()) > 0.0 {
        (hit.normal, hit.geometric_normal) = (-hit.normal, -hit.geometric_normal);
    }
    hit
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
    /// Random parameters.
    pub any: fn(&mut Random) -> P,
}

impl<P: Input> Shapes<P> {
    /// The first shape, and eight others.
    fn all(&self) -> Vec<P> {
        let mut all = vec![self.first.clone()];
        all.extend(random(self.any).into_iter().take(8));
        all
    }
}

/// Asks the first shape with simple rays, and all with rays from everywhere; and the mistakes that
/// all shapes may have.
pub fn shapes<P: Input + Send + Sync + 'static>(shapes: Shapes<P>) -> Exercise<NewShape<P>> {
    let all = shapes.all();
    let find = move |new: &NewShape<P>| {
        let mut numbers = Vec::new();
        for (index, parameters) in all.iter().enumerate() {
            let shape = new(parameters.clone());
            for found in shape.iter().flat_map(|shape| Found::search(&**shape)) {
                numbers.push(index as f64);
                numbers.extend(found.numbers());
            }
        }
        numbers
    };
    let ask = move |numbers: &[f64]| {
        let mut others = Vec::new();
        for (index, parameters) in shapes.all().into_iter().enumerate() {
            let of_shape = numbers.as_chunks::<4>().0.iter();
            let of_shape = of_shape.filter(|[of, ..]| *of as usize == index);
            let found: Vec<_> = of_shape
                .map(|[_, attempt, t, border]| Found::of_numbers([*attempt, *t, *border]))
                .collect();
            let rays = rays::from_everywhere(&found).into_iter();
            others.extend(rays.map(|ray| (parameters.clone(), ray)));
        }
        let simple = rays::simple().into_iter();
        let questions = Questions {
            words: format!("{}; {RAY}", shapes.words),
            simple: simple.map(|ray| (shapes.first.clone(), ray)).collect(),
            others,
            answer: |new: &NewShape<P>, (parameters, ray): (P, RayWithin)| {
                let (ray, within) = ray_within(ray);
                Some(hit_answer(new(parameters).ok()?.hit(&ray, within)))
            },
        };
        questions.asked()
    };
    Exercise {
        questions: vec![searched(find, ask)],
        usual: vec![
            mistake("the interval decides, no epsilon", |shape, ray, within| {
                shape.hit(
                    ray,
                    Interval {
                        min: 1e-6,
                        ..within
                    },
                )
            }),
            mistake("a short direction is not parallel", |shape, ray, within| {
                let is_long = ray.direction().magnitude() > 1e-6;
                shape.hit(ray, within).filter(|_| is_long)
            }),
            mistake("t counts steps, not lengths", |shape, ray, within| {
                let mut hit = shape.hit(ray, within)?;
                hit.t *= ray.direction().magnitude();
                Some(hit)
            }),
            mistake("a normal does not turn to the ray", |shape, ray, within| {
                let hit = shape.hit(ray, within)?;
                Some(turned(hit, hit.geometric_normal, ray))
            }),
            mistake("a shape has a far side, too", |shape, ray, within| {
                let is_front = |hit: &Hit| hit.geometric_normal.dot(ray.direction()) < 0.0;
                shape.hit(ray, within).filter(is_front)
            }),
        ],
        ..Exercise::default()
    }
}

type Flaw = fn(&dyn Geometry, &Ray, Interval) -> Option<Hit>;

fn mistake<P: 'static>(about: &'static str, hit: Flaw) -> Variant<NewShape<P>> {
    Variant::from_right(about, move |right: NewShape<P>| changed(right, hit))
}

/// Shapes whose hits a function finds with those of other shapes.
pub fn changed<P: 'static>(
    shapes: NewShape<P>,
    hit: impl Fn(&dyn Geometry, &Ray, Interval) -> Option<Hit> + Copy + Send + Sync + 'static,
) -> NewShape<P> {
    new_shape(move |parameters| {
        let shape = shapes(parameters)?;
        Ok(own(move |ray: &Ray, within| hit(&*shape, ray, within)))
    })
}

/// The parameters of a box between two corners.
pub type Corners = ([f64; 3], [f64; 3]);

/// Boxes between two corners.
pub const BOXES: Shapes<Corners> = Shapes {
    words: "box from {} to {}",
    first: ([-1.5; 3], [1.5; 3]),
    any: |r| {
        let lbf = r.triple(5.0);
        (lbf, lbf.map(|low| low + r.between(0.1, 3.0)))
    },
};

/// A remark: the worst ray and shape for a formula, whose shape some numbers describe.
pub fn search(name: &str, new: &dyn Fn(&[f64]) -> Made<Shape>) -> Result<String, Error> {
    let subject = Subject::named(&SUBJECTS, name)?;
    let t = |x: &[f64], ray: &Ray| Some(new(x).ok()?.hit(ray, Interval::AHEAD)?.t);
    // A learner waits for it.
    Ok(subject.in_words("your formula", &subject.worst(&t, INPUTS / 10)))
}
