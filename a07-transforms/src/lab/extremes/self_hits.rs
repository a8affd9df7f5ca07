//! Rays that leave the shape that they have hit, under transforms of every size: no
//! ray may hit it again, and no ray may miss an object close to it.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a06_shadows_reflection::secondary_ray;
use common::{ArgumentError, Color};
use measure::Effort;
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case};

use crate::{Disc, Node, Transform};

type Made<T> = Result<T, ArgumentError>;
type Shape = fn(Node) -> Made<Node>;

const SHAPES: [(&str, Shape, [&str; 4]); 5] = [
    ("a sphere", sphere, ["S61", "S62", "S63", "S64"]),
    ("a plane", plane, ["S65", "S66", "S67", "S68"]),
    ("a box", cube, ["S69", "S70", "S71", "S72"]),
    ("a triangle", triangle, ["S73", "S74", "S75", "S76"]),
    ("a disc", disc, ["S77", "S78", "S79", "S80"]),
];

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let mut cases = Vec::new();
    for (name, shape, ids) in SHAPES {
        for (id, size) in ids.into_iter().zip([1e-6, 1.0, 1e4, 1e9]) {
            let what = format!(
                "{name} under a node of size {size:e}, {count} lit points: dark, or lit through an object"
            );
            let case = Case::new(
                id,
                what,
                0.0,
                Bound::Equal,
                counts(shape, size, count, &lifted),
            );
            // At 1e9 the result depends on the rounding of single points.
            cases.push(match size {
                ..=1.0 => case.protocol(Fails, counts(shape, size, count, &fixed)),
                ..=1e4 => case.protocol(Holds, counts(shape, size, count, &fixed)),
                _ => case,
            });
        }
    }
    cases
}

/// The ray to a light and the least `t` that counts.
type Policy = dyn Fn(&Ray, &Hit, Vector3) -> (Ray, f64);

fn lifted(ray: &Ray, hit: &Hit, light: Vector3) -> (Ray, f64) {
    (secondary_ray(ray, hit, light), 0.0)
}

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
fn fixed(ray: &Ray, hit: &Hit, light: Vector3) -> (Ray, f64) {
    (Ray::derived(ray.at(hit.t), light), 0.001)
}

/// Number of lit points that a shape shadows itself, and of points that a light
/// reaches through an object at a ten thousandth of the scene's size.
fn counts(shape: Shape, size: f64, count: usize, policy: &Policy) -> Made<usize> {
    let transform = Transform::IDENTITY
        .translate(Point3::new(0.3 * size, -0.2 * size, 0.7 * size))?
        .rotate_x(0.4)?
        .rotate_y(1.1)?
        .scale(size, 0.5 * size, 2.0 * size)?;
    let middle = transform.matrix() * Point3::ORIGIN;
    let world = World::new(Color::BLACK)?.with(shape(Node::new(transform))?, ());
    let (mut wrong, mut lit, mut n) = (0, 0, 0);
    while lit < count {
        let random = PixelRandom::new(7, n, 0);
        n += 1;
        let within = |from: u64| {
            let number = |i| 2.0 * random.uniform(from + i) - 1.0;
            Vector3::new(number(0), number(1), number(2))
        };
        let eye = middle + within(0).unit("eye")? * (9.0 * size);
        let target = middle + within(3) * (0.3 * size);
        let ray = Ray::new(eye, target - eye)?;
        let Some((hit, ())) = world.hit(&ray, Interval::AHEAD) else {
            continue;
        };
        let light = within(6).unit("light")?;
        let cosine = light.dot(hit.face);
        if cosine.abs() < 1e-3 {
            continue;
        }
        lit += 1;
        let light = light * 1.0_f64.copysign(cosine);
        let (to_light, min) = policy(&ray, &hit, light);
        let beyond = Interval {
            min,
            max: f64::INFINITY,
        };
        wrong += usize::from(world.is_hit(&to_light, beyond));
        let occluder = Plane::new(ray.at(hit.t) + light * (1e-4 * size), light.as_normal())?;
        wrong += usize::from(occluder.hit(&to_light, beyond).is_none());
    }
    Ok(wrong)
}

fn sphere(node: Node) -> Made<Node> {
    Ok(node.with(Sphere::new(Point3::ORIGIN, 1.0)?))
}

fn plane(node: Node) -> Made<Node> {
    Ok(node.with(Plane::new(Point3::ORIGIN, Normal3::new(0.3, 1.0, 0.2))?))
}

fn cube(node: Node) -> Made<Node> {
    let (lbf, run) = (Point3::new(-0.3, -0.4, -0.1), Point3::new(0.3, 0.2, 0.5));
    Ok(node.with(AxisAlignedBox::new(lbf, run)?))
}

fn triangle(node: Node) -> Made<Node> {
    let (a, b) = (Point3::new(-1.1, -0.2, -0.9), Point3::new(1.3, 0.1, -0.7));
    Ok(node.with(Triangle::new(a, b, Point3::new(0.2, 0.3, 1.7))?))
}

fn disc(node: Node) -> Made<Node> {
    let normal = Normal3::new(0.3, 1.0, 0.2);
    Ok(node.with(Disc::new(Point3::new(0.0, 0.1, 0.0), normal, 1.5)?))
}
