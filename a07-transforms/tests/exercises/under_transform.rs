//! Rays and normals under chains of steps, compared with the lesson's.

use crate::prelude::*;

pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    transform.ray_to_object(ray)
}

pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    transform.normal_from_object(n)
}

type RayToObject = fn(&Transform, &Ray) -> Ray;
type NormalFromObject = fn(&Transform, Normal3) -> Option<Normal3>;

pub fn check(check: &mut Check, ray: RayToObject, normal: NormalFromObject) {
    let (step, double) = (Step::Translate([2.0, 0.0, 0.0]), Step::Scale([2.0; 3]));
    check.compare(
        "chain {}; origin and direction of the ray, and normal {}",
        [step, double].map(|step| (vec![step], [[0.0; 3], [0.0, 0.0, -2.0], [0.6, 0.8, 0.0]])),
        random(|r| (Step::random(r), [(); 3].map(|()| r.triple(5.0)))),
        [(ray_to_object as _, normal_from_object as _), (ray, normal)],
        |(ray, normal): (RayToObject, NormalFromObject), (steps, [o, d, n])| {
            let transform = transform(&steps);
            let ray = ray(&transform, &Ray::derived(point(o), vector(d)));
            let n = normal(&transform, vector(n).as_normal());
            Answer::named("origin", ray.origin().to_glam().to_array())
                .and("direction", ray.direction().to_glam().to_array())
                .and("the normal", n.map(|n| n.to_glam().to_array()))
        },
    );
    locked_scene(check, "sphere-transformation", 20.0, ABOVE, |world| {
        let transform = Transform::IDENTITY.scale(6.0, 1.2, 4.0)?;
        let child = Sphere::new(Point3::ORIGIN, 1.0)?;
        let moved = Own(move |outer: &Ray, within: Interval| {
            let hit = child.hit(&ray(&transform, outer), within)?;
            Some(Hit::new(hit.t, normal(&transform, hit.normal)?))
        });
        let material = Phong::new(Color::new(0.6, 0.0, 0.0), Color::WHITE, 64.0)?;
        Ok(world.with(moved, Box::new(material)))
    });
}

fn unit(v: Vector3) -> Option<Normal3> {
    v.normalized().map(Vector3::as_normal)
}

fn between_points(t: &Transform, ray: &Ray) -> Ray {
    let [from, to] = [0.0, 1.0].map(|at| t.inverse() * ray.at(at));
    Ray::derived(from, to - from)
}

fn forward(t: &Transform, ray: &Ray) -> Ray {
    Ray::derived(t.matrix() * ray.origin(), t.matrix() * ray.direction())
}

fn shortened(t: &Transform, ray: &Ray) -> Ray {
    let ray = t.ray_to_object(ray);
    let d = ray.direction().normalized();
    Ray::derived(ray.origin(), d.unwrap_or_default())
}

variants! { check:
    yours => ray_to_object, normal_from_object;
    right "a direction between two points" => between_points, |t, n| {
        let [x, y, z, _] = t.inverse().rows().map(|[x, y, z, _]| Vector3::new(x, y, z));
        unit(x * n.x() + y * n.y() + z * n.z())
    };
    wrong "the inverse leads to the object" => forward, normal_from_object;
    wrong "the direction keeps its length" => shortened, normal_from_object;
    wrong "a normal is no vector" => ray_to_object, |t, n| unit(t.matrix() * Vector3::from(n));
}
