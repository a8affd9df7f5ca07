//! Rays that leave shapes of all sizes, near the origin and far away, steep and grazing, to
//! both sides, compared with the lesson's.

use crate::prelude::*;

/// Shape, its normal, size, point in sizes, way from there to the eye, and the direction.
type Left = (&'static str, [f64; 3], f64, [f64; 3], [f64; 3], [f64; 3]);

const SHAPES: [&str; 3] = ["plane", "sphere", "smooth triangle"];

pub fn check(check: &mut Check, yours: &(dyn Fn(&Ray, &Hit, Vector3) -> Ray + Sync)) {
    let simple = |d, size| SHAPES.map(|s| (s, [0.0, 1.0, 0.0], size, [0.0; 3], [0.0, 2.0, 1.0], d));
    let (up, down) = ([4.0, 3.0, 0.0], [4.0, -3.0, 0.0]);
    check.compare(
        "{} with normal {}, of size {}, at {} sizes, the eye {} sizes away, left along {}",
        [simple(up, 1.0), simple(down, 1.0), simple(up, 1e-9)].concat(),
        random(|r| {
            let (n, p) = (unit(r.triple(1.0)), r.triple(5.0));
            let side = unit(array(n.cross(vector(r.triple(1.0)))));
            // Near, far from the origin, and far from the eye.
            let [far, away] = [[1.0, 1.0], [1e7, 1.0], [0.0, 1e7]][r.below(3) as usize];
            let eye = (n * r.between(0.5, 3.0) + side * r.between(-3.0, 3.0)) * away;
            let d = side + n * [1.0, -1.0, 1e-3, -1e-3][r.below(4) as usize];
            let (shape, p) = (SHAPES[r.below(3) as usize], p.map(|x| x * far));
            (shape, array(n), r.scale(), p, array(eye), array(d))
        }),
        [&secondary_ray as _, yours],
        |leaving, input| left(input, leaving),
    );
    let picture = reflected_scene(scenes::sphere(), |world, ray, depth| {
        Tracer(world, &is_shadowed, yours).trace(ray, depth)
    });
    check.scene(&stage(), "sphere", picture);
}

fn left((shape, n, size, p, away, d): Left, leaving: Leaving) -> Option<Answer> {
    let (p, away) = (Point3::ORIGIN + vector(p) * size, vector(away) * size);
    let (n, d) = (unit(n), unit(d));
    let shape: Box<dyn Geometry> = match shape {
        "plane" => Box::new(Plane::new(p, n.as_normal()).ok()?),
        "sphere" => Box::new(Sphere::new(p - n * size, size).ok()?),
        _ => Box::new(smooth_triangle(p, n, size).ok()?),
    };
    let ray = Ray::new(p + away, -away).ok()?;
    let hit = shape.hit(&ray, Interval::AHEAD)?;
    let left = leaving(&ray, &hit, d);
    let step = left.origin() - ray.at(hit.t);
    // Inwards, a ray meets the far side of a sphere, but not this one.
    let again = shape.hit(&left, Interval::before(1e-4 * size));
    let words = if step.dot(hit.face) * d.dot(hit.face) <= 0.0 {
        "a ray from the wrong side of the surface"
    } else if step.magnitude() > 1e-9 * numbers(&ray, &hit).iter().sum::<f64>() {
        "a ray that begins far away"
    } else if again.is_some() {
        "a ray that hits the surface again"
    } else {
        "a ray that leaves the surface"
    };
    Some(Answer::words(words).and("direction", array(left.direction())))
}

/// The largest coordinates of the origin and of the point, and t.
fn numbers(ray: &Ray, hit: &Hit) -> [f64; 3] {
    let [o, p] = [ray.origin(), ray.at(hit.t)].map(Point3::largest_coordinate);
    [o, p, hit.t]
}

/// The ray that is offset along this vector, by a length that follows from the numbers.
fn offset(c: &mut Check, along: fn(&Hit, Vector3) -> Vector3, length: fn([f64; 3]) -> f64) {
    check(c, &|ray, hit, d| {
        let along = along(hit, d);
        let length = length(numbers(ray, hit)).copysign(along.dot(d));
        Ray::derived(ray.at(hit.t) + along * length, d)
    });
}

fn face(hit: &Hit, _: Vector3) -> Vector3 {
    hit.face.into()
}

fn largest([o, p, t]: [f64; 3]) -> f64 {
    1e-14 * o.max(p).max(t)
}

variants! { offset:
    yours => &secondary_ray;
    right "a share of the sum" => face, |[o, p, t]| 1e-13 * (o + p + t);
    wrong "no length is fixed" => face, |_| 1e-9;
    wrong "the errors of the coordinates count, too" => face, |[_, _, t]| 1e-12 * t;
    wrong "the error of t counts, too" => face, |[_, p, _]| 1e-12 * p;
    wrong "a grazing ray does not leave along itself" => |_, d| d, largest;
    wrong "the face says where the surface is" => |hit, _| hit.normal.into(), largest;
}
