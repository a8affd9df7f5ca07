//! Compares shapes: with rays of all lengths, from outside, from inside and from far away,
//! just inside and just outside of borders, and in intervals that end at hits.

use std::f64::consts::FRAC_PI_4;
use std::fmt;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, render};
use a04_intersections::{Geometry, Hit, Interval, World, scenes::View, stage};
use common::{ArgumentError, Color};
use testing::exercise::{Answer, Check, Random};

/// Origin and direction of a ray, and the ends of the interval.
pub type RayWithin = ([f64; 3], [f64; 3], f64, f64);

/// The words for a ray in messages.
pub const RAY: &str = "ray from {} along {}, t from {} to {}";

/// A shape whose hits a function finds.
pub struct Own<F>(pub F);

pub fn own<F: Fn(&Ray, Interval) -> Option<Hit>>(hit: F) -> Result<Own<F>, ArgumentError> {
    Ok(Own(hit))
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

pub fn point(xyz: [f64; 3]) -> Point3 {
    Point3::from_glam(xyz.into())
}

pub fn vector(xyz: [f64; 3]) -> Vector3 {
    Vector3::from_glam(xyz.into())
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

/// Compares a shape, described in words, with the lesson's: first with `simple` rays of
/// origin and direction, then with rays around a point that is about as far as `reach` from
/// the borders of the shape.
pub fn compare<E>(
    check: &mut Check,
    words: &str,
    (middle, reach): ([f64; 3], f64),
    lesson: Result<impl Geometry, E>,
    yours: Result<impl Geometry, E>,
    simple: &[[[f64; 3]; 2]],
) {
    let (Ok(lesson), Ok(yours)) = (lesson, yours) else {
        return;
    };
    let words = format!("{words}; {RAY}");
    let simple = simple.iter().map(|[o, d]| (*o, *d, 0.0, f64::INFINITY));
    let rays = rays(&lesson, point(middle), reach);
    check.compare(
        &words,
        simple,
        rays,
        |input| hit(&lesson, input),
        |input| hit(&yours, input),
    );
}

pub fn hit(shape: &dyn Geometry, input: RayWithin) -> Answer {
    let (ray, within) = ray_within(input);
    answer(shape.hit(&ray, within))
}

/// Rays around a point of a shape; where its borders are, follows from its hits.
pub fn rays(lesson: &dyn Geometry, middle: Point3, reach: f64) -> Vec<RayWithin> {
    let (mut random, mut rays) = (Random::new(1), Vec::new());
    for i in 0..40 {
        let mut place = |most| middle + vector(random.triple(most)) * reach;
        let (to, aside, from) = (place(1.0), place(3.0), place([3.0, 0.5, 3.0, 1e3][i % 4]));
        let length = if i < 10 { 1.0 } else { random.scale() };
        let towards = |to: Point3| Ray::derived(from, (to - from) * length);
        let mut add = |ray: Ray, min, max| {
            let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()];
            rays.push((o.to_array(), d.to_array(), min, max));
        };
        let ray = towards(to);
        add(ray, 0.0, f64::INFINITY);
        add(Ray::derived(from, -ray.direction()), 0.0, f64::INFINITY);
        let hit = |ray: &Ray| lesson.hit(ray, Interval::AHEAD);
        let Some(Hit { t, .. }) = hit(&ray) else {
            continue;
        };
        for end in [t * (1.0 - 1e-6), t * (1.0 + 1e-6)] {
            add(ray, 0.0, end);
            add(ray, end, f64::INFINITY);
        }
        // It begins just behind the surface, often inside.
        add(
            Ray::derived(ray.at(t * 1.001), ray.direction()),
            0.0,
            f64::INFINITY,
        );
        // Towards a border between a point that is hit and one that is not.
        let between = |share: f64| towards(to + (aside - to) * share);
        let (mut hits, mut misses) = (0.0, 1.0);
        while hit(&between(1.0)).is_none() && misses - hits > 1e-12 {
            let share = f64::midpoint(hits, misses);
            *(if hit(&between(share)).is_some() {
                &mut hits
            } else {
                &mut misses
            }) = share;
        }
        add(between(hits - 1e-6), 0.0, f64::INFINITY);
        add(between(misses + 1e-6), 0.0, f64::INFINITY);
    }
    rays
}

/// Compares the picture of a scene in which the student's shape stands in the place of the
/// lesson's.
pub fn scene(
    check: &mut Check,
    name: &str,
    view: fn() -> Result<View, ArgumentError>,
    shape: Result<impl Geometry, ArgumentError>,
) {
    check.scene(&stage(), name, |settings| {
        let (camera, world) = view()?;
        let color = world
            .objects()
            .next()
            .map_or(Color::WHITE, |(_, color)| *color);
        let world = World::new(world.background())?.with(shape?, color);
        render(&camera, |ray: &Ray| world.color_for(ray), settings, &())
    });
}

/// Shows a shape to an eye that looks at the point `at`, coloured by its normal:
/// red faces right or left, green up or down, blue near or far.
pub fn show(
    check: &mut Check,
    shape: Result<impl Geometry, ArgumentError>,
    eye: Point3,
    at: Point3,
) {
    let world = World::new(Color::gray(0.1)).and_then(|world| Ok(world.with(shape?, ())));
    show_world(check, world, eye, at, |_, normal| {
        let [r, g, b] = normal.to_glam().abs().to_array();
        Color::new(r, g, b)
    });
}

/// Shows a world to an eye that looks at the point `at`, coloured by place and
/// normal.
pub fn show_world(
    check: &mut Check,
    world: Result<World<()>, ArgumentError>,
    eye: Point3,
    at: Point3,
    color: impl Fn(Point3, Normal3) -> Color + Sync,
) {
    check.picture(|settings| {
        let world = world?;
        let up = Vector3::new(0.0, 1.0, 0.0);
        let camera = PerspectiveCamera::new(eye, at - eye, up, FRAC_PI_4)?;
        let paint = |ray: &Ray| match world.hit(ray, Interval::AHEAD) {
            Some((hit, ())) => color(ray.at(hit.t), hit.normal),
            None => world.background(),
        };
        render(&camera, paint, settings, &())
    });
}
