//! Values from bytes: numbers of which every bit pattern is possible, and those are frequent
//! that make a scene or break a formula; and whatever constructors accept of them.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, Ray};
use a07_transforms::Transform;
use arbitrary::{Result, Unstructured};
use common::{ArgumentError, Size};
use random_scene::{Numbers, Style};

/// Draws whole numbers from bytes; 0 behind their end.
pub fn below(u: &mut Unstructured, end: u32) -> u32 {
    u.int_in_range(0..=end - 1).unwrap_or(0)
}

/// Any number.
pub fn number(u: &mut Unstructured) -> Result<f64> {
    let below = &mut |end| below(u, end);
    Ok(Numbers::new(below, Style::Any).any())
}

/// Three of them.
fn three(u: &mut Unstructured) -> Result<[f64; 3]> {
    Ok([number(u)?, number(u)?, number(u)?])
}

/// A point of three of these numbers.
pub fn point(u: &mut Unstructured) -> Result<Point3> {
    Ok(Point3::from_glam(three(u)?.into()))
}

/// A vector of three of these numbers.
pub fn vector(u: &mut Unstructured) -> Result<Vector3> {
    Ok(Vector3::from_glam(three(u)?.into()))
}

/// A normal of three of these numbers.
pub fn normal(u: &mut Unstructured) -> Result<Normal3> {
    vector(u).map(Vector3::as_normal)
}

/// The result of a constructor; an error must have a message.
pub fn accepted<T>(made: std::result::Result<T, ArgumentError>) -> Option<T> {
    match made {
        Ok(value) => Some(value),
        Err(error) => {
            assert!(error.to_string().contains(" must be "), "{error}");
            None
        }
    }
}

/// A chain of up to four steps; refused steps are skipped.
pub fn transform(u: &mut Unstructured) -> Result<Transform> {
    let mut transform = Transform::IDENTITY;
    for _ in 0..u.int_in_range(0..=4)? {
        let step = match u.int_in_range(0..=4)? {
            0 => transform.rotate_x(number(u)?),
            1 => transform.rotate_y(number(u)?),
            2 => transform.rotate_z(number(u)?),
            3 => transform.translate(point(u)?),
            _ => {
                let [x, y, z] = three(u)?;
                transform.scale(x, y, z)
            }
        };
        transform = accepted(step).unwrap_or(transform);
    }
    Ok(transform)
}

/// A picture of any size, and a ray of a camera through it, which begins at a finite point and has a direction of
/// length 1.
pub fn size_and_ray(u: &mut Unstructured, camera: &dyn Camera) -> Result<(Size, Ray)> {
    let (width, height) = (u.int_in_range(1..=32_768)?, u.int_in_range(1..=2048)?);
    let size = Size::new(width, height).expect("a size");
    let ray = camera.ray_for(size, position(u, width)?, position(u, height)?);
    assert_unit(ray.direction());
    assert!(ray.origin().to_glam().is_finite(), "{ray:?}");
    Ok((size, ray))
}

/// A coordinate in a picture of this width or height.
fn position(u: &mut Unstructured, side: u32) -> Result<f64> {
    let fraction = f64::from(u.arbitrary::<u16>()?) / 65_535.0;
    Ok(f64::from(side) * fraction - 0.5)
}

/// A length of 1, up to the rounding of three quotients and a root.
pub fn assert_unit(v: Vector3) {
    assert!((v.magnitude() - 1.0).abs() <= 4.0 * f64::EPSILON, "{v:?}");
}
