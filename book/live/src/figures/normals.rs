//! A transformed sphere: the ray in both spaces, and its normal moved rightly and
//! wrongly.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval, Sphere};
use a07_lab::protocol;
use a07_transforms::{Node, Transform};

use super::{Answered, flat, place, point};
use crate::Reply;

/// Numbers: the factors of the scaling, an angle in degrees, the translation, and
/// origin and passed point of the ray. The sphere is scaled, turned and then moved.
pub fn answer([sx, sy, angle, tx, ty, ox, oy, x, y]: [f64; 9]) -> Answered {
    let transform = Transform::IDENTITY
        .translate(point(tx, ty))?
        .rotate_z(angle.to_radians())?
        .scale(sx, sy, 1.0)?;
    let o = point(ox, oy);
    let ray = Ray::new(o, point(x, y) - o)?;
    let object_ray = transform.ray_to_object(&ray);
    let sphere = Sphere::new(Point3::ORIGIN, 1.0)?;
    let matrix = transform.matrix().rows();
    let answer = Reply::default()
        .with("matrix", matrix.concat())
        .with("direction", flat(ray.direction()))
        .with("object_origin", place(object_ray.origin()))
        .with("object_direction", flat(object_ray.direction()))
        .with("length", [object_ray.direction().magnitude()]);
    let Some(inside) = sphere.hit(&object_ray, Interval::AHEAD) else {
        return Ok(answer.with("t_world", []));
    };
    let outside = Node::new(transform).with(sphere).hit(&ray, Interval::AHEAD);
    let right = outside.map(|hit| hit.normal);
    let moved = protocol::normal_as_vector(transform.matrix(), inside.normal);
    let apart = right.zip(moved).map(|pair| {
        let (right, moved): (Vector3, Vector3) = (pair.0.into(), pair.1.into());
        right.angle(moved).to_degrees()
    });
    Ok(answer
        .with("apart", apart)
        .with("t_object", [inside.t])
        .with("t_world", outside.map(|hit| hit.t))
        .with("object_normal", flat(inside.normal))
        .with("normal", right.into_iter().flat_map(flat))
        .with("wrong_normal", moved.into_iter().flat_map(flat)))
}
