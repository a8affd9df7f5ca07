//! Points under nested nodes: none shades itself, and none misses an object near it.

use std::f64::consts::TAU;

use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Geometry, Sphere};
use a04_lab::support::Numbers;
use a06_lab::experiments::secondary_rays::NEAR;
use a06_lab::lit_points::{EyeRay, LitPoint, from_eye_rays};
use a06_lab::policy::offset;
use a06_lab::surface::surface;
use a07_transforms::{Disc, Node, Transform};
use common::{ArgumentError, Error};

/// Of four thousand points a condition, none has acne or a leak.
#[test]
fn points_under_nested_nodes_are_right() {
    for condition in [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9] {
        for lit in lit_points(4_096, 13, condition).unwrap() {
            assert!(!lit.shades_itself(offset), "acne, {condition}");
            assert!(!NEAR.iter().any(|near| lit.leaks(offset, *near)));
        }
    }
}

/// Lit points of shapes under nodes of this condition.
fn lit_points(count: usize, seed: u64, condition: f64) -> Result<Vec<LitPoint>, Error> {
    from_eye_rays(count, seed, 1.0, |numbers| eye_ray(numbers, condition))
}

/// A ray from the eye to a box, ball or disc under one to three nodes, each of which translates, flattens
/// and, one time in two each, turns before and after.
fn eye_ray(numbers: &mut Numbers, condition: f64) -> Result<EyeRay, Error> {
    let mut shape = any_shape(numbers)?;
    let mut target = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let levels = 1 + numbers.below(3);
    let flat = libm::pow(condition, -1.0 / levels as f64);
    for _ in 0..levels {
        let transform = flattening(numbers, flat)?;
        target = transform.matrix() * target;
        shape = Box::new(Node::new(transform).with(shape));
    }
    // Farther away than the three nodes reach.
    let eye = Point3::ORIGIN + numbers.direction() * 9.0;
    Ok(EyeRay {
        surface: surface(shape)?,
        eye,
        target,
    })
}

fn any_shape(numbers: &mut Numbers) -> Result<Box<dyn Geometry>, Error> {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let (low, high) = (Point3::new(-1.0, -1.0, -1.0), Point3::new(1.0, 1.0, 1.0));
    Ok(match numbers.below(3) {
        0 => Box::new(AxisAlignedBox::new(low, high)?),
        1 => Box::new(Sphere::new(Point3::ORIGIN, 1.0)?),
        _ => Box::new(Disc::new(Point3::ORIGIN, up, 1.0)?),
    })
}

/// A transform that scales one axis by `flat`, and another one by less.
fn flattening(numbers: &mut Numbers, flat: f64) -> Result<Transform, ArgumentError> {
    let translation = Point3::ORIGIN + numbers.triple(-1.0, 1.0);
    let moved = Transform::IDENTITY.translate(translation)?;
    let mut angle = || numbers.below(2) as f64 * numbers.between(0.0, TAU);
    let [a, b, c] = [angle(), angle(), angle()];
    let mut scale = [1.0, libm::pow(flat, numbers.between(0.0, 1.0)), flat];
    scale.rotate_left(numbers.below(3));
    let [x, y, z] = scale;
    let turned = moved.rotate_x(a)?.rotate_y(b)?;
    turned.scale(x, y, z)?.rotate_z(c)
}
