//! Compares shapes: with rays of all lengths, from outside, from inside and from far away,
//! just inside and just outside of borders, and in intervals that end at hits.

use std::f64::consts::FRAC_PI_4;
use std::{fmt, iter};

use crate::prelude::*;

pub type Shape = Box<dyn Geometry>;

pub fn boxed(shape: Made<impl Geometry>) -> Made<Shape> {
    Ok(Box::new(shape?))
}

/// Origin and direction of a ray, and the ends of the interval.
pub type RayWithin = ([f64; 3], [f64; 3], f64, f64);

/// The words for a ray in messages.
pub const RAY: &str = "ray from {} along {}, t from {} to {}";

/// A shape whose hits a function finds.
pub struct Own<F>(pub F);

#[expect(clippy::unnecessary_wraps, reason = "a constructor returns a result")]
pub fn own(hit: impl Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'static) -> Made<Shape> {
    Ok(Box::new(Own(hit)))
}

impl<F> fmt::Debug for Own<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Own")
    }
}

impl<F: Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'static> Geometry for Own<F> {
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

/// The ray and the interval of an input.
pub fn ray_within((o, d, min, max): RayWithin) -> (Ray, Interval) {
    (Ray::derived(point(o), vector(d)), Interval { min, max })
}

pub fn answer(hit: Option<Hit>) -> Answer {
    hit.map_or(Answer::words("no hit"), |hit| {
        Answer::named("t", hit.t)
            .and("normal", hit.normal.to_glam().to_array())
            .and("face", hit.face.to_glam().to_array())
    })
}

/// The hit with its normals turned, if this one of them looks along the ray.
pub fn turned(mut hit: Hit, by: Normal3, ray: &Ray) -> Hit {
    if by.dot(ray.direction()) > 0.0 {
        (hit.normal, hit.face) = (-hit.normal, -hit.face);
    }
    hit
}

/// The hit of a ray ahead of its origin, for examples.
pub fn hit_from(o: [f64; 3], d: [f64; 3], shape: &dyn Geometry) -> Option<Hit> {
    shape.hit(&Ray::derived(point(o), vector(d)), Interval::AHEAD)
}

type Flaw = fn(&dyn Geometry, &Ray, Interval) -> Option<Hit>;

/// Mistakes that any shape may have.
const USUAL: [(&str, Flaw); 5] = [
    ("the interval decides, no epsilon", |shape, ray, i| {
        shape.hit(ray, Interval { min: 1e-6, ..i })
    }),
    ("a short direction is not parallel", |shape, ray, i| {
        let is_long = ray.direction().magnitude() > 1e-6;
        shape.hit(ray, i).filter(|_| is_long)
    }),
    ("t counts steps, not lengths", |shape, ray, i| {
        let mut hit = shape.hit(ray, i)?;
        hit.t *= ray.direction().magnitude();
        Some(hit)
    }),
    ("a normal does not turn to the ray", |shape, ray, i| {
        let hit = shape.hit(ray, i)?;
        Some(turned(hit, hit.face, ray))
    }),
    ("a shape has a far side, too", |shape, ray, i| {
        let is_front = |hit: &Hit| hit.face.dot(ray.direction()) < 0.0;
        shape.hit(ray, i).filter(is_front)
    }),
];

/// Simple rays to a shape around the origin: along each axis, in longer steps, from inside,
/// away from it, and aslant.
fn simple() -> impl Iterator<Item = [[f64; 3]; 2]> {
    let places = [0.0, 0.5, 1.0, 2.0, 3.0].into_iter();
    let places = places.flat_map(|x| [0.0, 0.5, 1.0, 2.0].map(|y| [x, y]));
    let axes = places.flat_map(|[x, y]| {
        [
            [[x, y, 4.0], [0.0, 0.0, -1.0]],
            [[x, 4.0, y], [0.0, -2.0, 0.0]],
            [[x, y, 0.25], [0.0, 0.0, 1.0]],
            [[x, -4.0, y], [0.0, -1.0, 0.0]],
        ]
    });
    axes.chain([[[3.0, 0.0, 0.0], [-1.0, 0.0, 1.0]]])
}

/// Compares shapes with the lesson's, whose words have `{}` in the place of each parameter:
/// the `first` one, near the origin and of round numbers, with simple rays, and eight of `any`
/// parameters with rays from everywhere.
pub fn compare<P: Input>(
    check: &mut Check,
    words: &str,
    first: P,
    any: fn(&mut Random) -> P,
    lesson: &dyn Fn(P) -> Made<Shape>,
    yours: &dyn Fn(P) -> Made<Shape>,
) {
    let mistake = check.usual(&USUAL).unwrap_or(Geometry::hit);
    let shapes = iter::once(first.clone()).chain(random(any).take(8));
    let mut from_everywhere = Vec::new();
    for shape in shapes {
        let rays = || lesson(shape.clone()).map_or(Vec::new(), |shape| rays(&*shape));
        let rays = check.recorded(rays).into_iter();
        from_everywhere.extend(rays.map(|ray| (shape.clone(), ray)));
    }
    check.compare(
        &format!("{words}; {RAY}"),
        simple().map(move |[o, d]| (first.clone(), (o, d, 0.0, f64::INFINITY))),
        from_everywhere,
        [(lesson, Geometry::hit as Flaw), (yours, mistake)],
        |(new, hit), (shape, ray)| {
            let (ray, within) = ray_within(ray);
            Some(answer(hit(&*new(shape).ok()?, &ray, within)))
        },
    );
}

/// Compares boxes between two corners.
pub fn compare_boxes(
    check: &mut Check,
    lesson: &dyn Fn(Point3, Point3) -> Made<Shape>,
    yours: &dyn Fn(Point3, Point3) -> Made<Shape>,
) {
    compare(
        check,
        "box from {} to {}",
        ([-1.5; 3], [1.5; 3]),
        |r| {
            let lbf = r.triple(5.0);
            (lbf, lbf.map(|low| low + r.between(0.1, 3.0)))
        },
        &|(lbf, run)| lesson(point(lbf), point(run)),
        &|(lbf, run)| yours(point(lbf), point(run)),
    );
}

/// Rays from everywhere, most of which hit the shape: from outside, inside and far away; with
/// directions of all lengths; in intervals that end just before and after a hit; and just
/// inside and outside of a border.
pub fn rays(lesson: &dyn Geometry) -> Vec<RayWithin> {
    let (mut random, mut rays, all) = (Random::new(1), Vec::new(), [0.0, f64::INFINITY]);
    let is_hit = |ray: Ray| lesson.hit(&ray, Interval::AHEAD).is_some();
    for i in 0..2000 {
        let [from, to, aside] = [(); 3].map(|()| point(random.triple(6.0)));
        let distance = if i % 4 == 3 { 100.0 } else { 1.0 };
        let from = to + (from - to) * distance;
        let length = if rays.len() < 40 { 1.0 } else { random.scale() };
        let towards = |to: Point3| Ray::derived(from, (to - from) * length);
        let mut add = |ray: Ray, [min, max]: [f64; 2]| {
            let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
            rays.push((o.to_array(), d.to_array(), min, max));
        };
        let ray = towards(to);
        let Some(Hit { t, .. }) = lesson.hit(&ray, Interval::AHEAD) else {
            continue;
        };
        add(ray, all);
        add(Ray::derived(from, -ray.direction()), all);
        for end in [t * (1.0 - 1e-3), t * (1.0 + 1e-6)] {
            add(ray, [0.0, end]);
            add(ray, [end, f64::INFINITY]);
        }
        // It begins just behind the surface, often inside.
        add(Ray::derived(ray.at(t * 1.001), ray.direction()), all);
        // Between a point that is hit and one that is not, there is a border.
        let between = |share: f64| towards(to + (aside - to) * share);
        let (mut border, mut step) = (0.0, 1.0);
        for _ in 0..40 {
            step /= 2.0;
            if is_hit(between(border + step)) {
                border += step;
            }
        }
        add(between(border - 1e-6), all);
        add(between(border + 1e-6), all);
        if rays.len() >= 180 {
            break;
        }
    }
    rays
}

/// Compares the picture of a scene in which the student's shape stands in the place of the
/// lesson's.
pub fn scene(
    check: &mut Check,
    name: &str,
    view: fn() -> Made<View<World<Color>>>,
    shape: Made<Shape>,
) {
    check.scene(&a04_intersections::stage(), name, |settings| {
        let View { camera, world } = view()?;
        let color = world.objects().map(|(_, color)| *color).next();
        let black = World::new(world.background())?;
        let world = black.with(shape?, color.unwrap_or(Color::WHITE));
        let world = Box::new(world).recorded(false);
        paint(&camera, &|ray: &Ray| world.radiance(ray, 1), settings)
    });
}

/// Remarks the worst ray and shape for the student's formula, whose shape some numbers describe.
#[cfg(not(handout))]
pub fn search(check: &mut Check, name: &str, yours: &dyn Fn(&[f64]) -> Made<Shape>) {
    use a04_lab::search::{INPUTS, SUBJECTS, Subject};
    check.remark(|| {
        let subject = Subject::named(&SUBJECTS, name)?;
        let t = |x: &[f64], ray: &Ray| Some(yours(x).ok()?.hit(ray, Interval::AHEAD)?.t);
        // A learner waits for it.
        Ok(subject.in_words("your formula", &subject.worst(&t, INPUTS / 10)))
    });
}

/// Shows shapes to an eye that looks at the point `at`, coloured by their normals:
/// red faces right or left, green up or down, blue near or far.
pub fn show(
    check: &mut Check,
    shapes: impl IntoIterator<Item = Shape>,
    eye: [f64; 3],
    at: [f64; 3],
) {
    let world = World::new(Color::gray(0.1)).map(|mut world| {
        for shape in shapes {
            world = world.with(shape, Color::WHITE);
        }
        world
    });
    show_world(check, world, eye, at, &|_, _, normal| {
        let [r, g, b] = normal.to_glam().abs().to_array();
        Color::new(r, g, b)
    });
}

/// Shows a world to an eye that looks at the point `at`, coloured by surface, place and
/// normal.
pub fn show_world(
    check: &mut Check,
    world: Made<World<Color>>,
    eye: [f64; 3],
    at: [f64; 3],
    color: &(dyn Fn(Color, Point3, Normal3) -> Color + Sync),
) {
    check.picture(|settings| {
        let world = world?;
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(point(eye), point(at) - point(eye), up, FRAC_PI_4)?;
        let radiance = |ray: &Ray| match world.hit(ray, Interval::AHEAD) {
            Some((hit, surface)) => color(*surface, ray.at(hit.t), hit.normal),
            None => world.background(),
        };
        paint(&camera, &radiance, settings)
    });
}
