//! Points of rays and beside them, compared with the lesson's `Ray`.

use crate::prelude::*;

pub fn at(ray: &Ray, t: f64) -> Point3 {
    ray.at(t)
}

pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    ray.t_of(point)
}

pub fn check(check: &mut Check, at: fn(&Ray, f64) -> Point3, t_of: fn(&Ray, Point3) -> f64) {
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
        [(Ray::at as _, Ray::t_of as _), (at, t_of)],
        |(at, t_of), (o, d, t, p)| {
            let ray = Ray::derived(point(o), vector(d));
            Answer::named("at", at(&ray, t).to_glam().to_array()).and("t_of", t_of(&ray, point(p)))
        },
    );
    scene(check, |settings, View { camera, world: sky }| {
        let radiance = |ray: &Ray| {
            let way = at(ray, t_of(ray, ray.at(1.0))) - ray.origin();
            sky.color_for(&Ray::derived(ray.origin(), way))
        };
        paint(&camera, &radiance, settings)
    });
}

fn unit(ray: &Ray) -> Vector3 {
    ray.direction().normalized().unwrap_or_default()
}

fn length(ray: &Ray) -> f64 {
    ray.direction().magnitude()
}

variants! { check:
    yours => at, t_of;
    right "with a direction of length 1" =>
        |ray, t| ray.origin() + unit(ray) * (t * length(ray)),
        |ray, p| (p - ray.origin()).dot(unit(ray)) / length(ray);
    wrong "t is no distance: d may have any length" => Ray::at, |ray, p| {
        (p - ray.origin()).magnitude()
    };
    wrong "the dot product has the length of d twice" => Ray::at, |ray, p| {
        (p - ray.origin()).dot(unit(ray))
    };
    wrong "t counts steps of d, of any length" => |ray, t| ray.origin() + unit(ray) * t, Ray::t_of;
}
