//! Points of rays and beside them, compared with the lesson's `Ray`.

use crate::prelude::*;

pub fn check(
    check: &mut Check,
    at: impl Fn(&Ray, f64) -> Point3 + Sync,
    t_of: impl Fn(&Ray, Point3) -> f64 + Sync,
) {
    let ray = |o, d| Ray::derived(point(o), vector(d));
    let answer =
        |at: Point3, t_of: f64| Answer::named("at", at.to_glam().to_array()).and("t_of", t_of);
    check.compare(
        "ray from {} along {}, t = {}, point {}",
        [
            ([0.0; 3], [0.0, 0.0, -2.0], 3.0, [0.0, 0.0, -8.0]),
            ([1.0, 2.0, 0.0], [2.0, 0.0, 0.0], -1.0, [5.0, 4.0, 0.0]),
        ],
        random(|r| {
            let (o, d, length, p) = (r.triple(9.0), r.triple(5.0), r.scale(), r.triple(9.0));
            (o, d.map(|x| x * length), r.between(-9.0, 9.0), p)
        }),
        |(o, d, t, p)| answer(ray(o, d).at(t), ray(o, d).t_of(point(p))),
        |(o, d, t, p)| answer(at(&ray(o, d), t), t_of(&ray(o, d), point(p))),
    );
    scene(check, |settings, View { camera, world: sky }| {
        let radiance = |ray: &Ray| {
            let way = at(ray, t_of(ray, ray.at(1.0))) - ray.origin();
            sky.color_for(&Ray::derived(ray.origin(), way))
        };
        render(&camera, radiance, settings, &())
    });
}

fn unit(ray: &Ray) -> Vector3 {
    ray.direction().normalized().unwrap_or_default()
}

pub const VARIANTS: &[Variant] = &[
    right("with a direction of length 1", |c| {
        let length = |ray: &Ray| ray.direction().magnitude();
        let at = |ray: &Ray, t| ray.origin() + unit(ray) * (t * length(ray));
        check(c, at, |ray, p| {
            (p - ray.origin()).dot(unit(ray)) / length(ray)
        });
    }),
    wrong("t is no distance: d may have any length", |c| {
        check(c, Ray::at, |ray, p| (p - ray.origin()).magnitude());
    }),
    wrong("the dot product has the length of d twice", |c| {
        check(c, Ray::at, |ray, p| (p - ray.origin()).dot(unit(ray)));
    }),
    wrong("t counts steps of d, of any length", |c| {
        check(c, |ray, t| ray.origin() + unit(ray) * t, Ray::t_of);
    }),
];
