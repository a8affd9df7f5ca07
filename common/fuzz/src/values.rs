//! Values from bytes: numbers of which every bit pattern is possible, and those are frequent
//! that make a scene or break a formula; and whatever constructors accept of them.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera};
use a04_intersections::kinds::Shared;
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use a07_transforms::kinds::KINDS;
use a07_transforms::{Disc, Node, Transform};
use arbitrary::{Result, Unstructured};
use common::{ArgumentError, Color};

/// Ends of the ranges that constructors and number formats have, and numbers
/// beyond.
#[rustfmt::skip]
const ENDS: [f64; 24] = [
    0.0, -0.0, 1.0, -1.0, 1.0 - f64::EPSILON / 2.0, 1.0 + f64::EPSILON,
    1e-100, 1e100, -1e100, 1e-7, 1e-12, 1e50, 1e-50, 1e150, 1e-150, 1e160, 1e-160,
    std::f64::consts::PI, std::f64::consts::FRAC_PI_2,
    f64::MIN_POSITIVE, f64::MAX, 5e-324, f64::INFINITY, f64::NAN,
];

/// Any number.
pub fn number(u: &mut Unstructured) -> Result<f64> {
    Ok(match u.int_in_range(0..=7)? {
        0 => f64::from_bits(u.arbitrary()?),
        1 => *u.choose(&ENDS)?,
        // A power of two from 2^-384 to 2^381, whose sum with anything rounds.
        2 => {
            let exponent = 3 * i64::from(u.arbitrary::<i8>()?);
            f64::from_bits(((1023 + exponent) as u64) << 52)
        }
        3 => f64::from(u.arbitrary::<i16>()?) / 4096.0,
        // So few that they repeat: edges that touch, shapes within each other.
        _ => f64::from(u.arbitrary::<i8>()?) / 8.0,
    })
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

/// A colour, most of them from 0 to 1.
pub fn color(u: &mut Unstructured) -> Result<Color> {
    if u.ratio(1, 4)? {
        let [r, g, b] = three(u)?;
        Ok(Color::new(r, g, b))
    } else {
        Ok(Color::from_packed(u.arbitrary()?))
    }
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

/// A boxed trait object of the result of a constructor.
macro_rules! boxed {
    ($made:expr) => {
        accepted($made).map(|made| Box::new(made) as _)
    };
}
pub(crate) use boxed;

/// A shape, with up to these levels of nodes; none if its constructor refuses the numbers.
pub fn shape(u: &mut Unstructured, levels: u32) -> Result<Option<Box<dyn Geometry>>> {
    Ok(match u.int_in_range(0..=8)? {
        0 => {
            let (point, normal) = (point(u)?, normal(u)?);
            boxed!(Plane::new(point, normal))
        }
        1 => {
            let (low, high) = (point(u)?, point(u)?);
            boxed!(AxisAlignedBox::new(low, high))
        }
        2 => {
            let (center, normal) = (point(u)?, normal(u)?);
            boxed!(Disc::new(center, normal, number(u)?))
        }
        3 | 4 => {
            let (center, radius) = (point(u)?, number(u)?);
            boxed!(Sphere::new(center, radius))
        }
        5 => {
            let [a, b, c] = [point(u)?, point(u)?, point(u)?];
            boxed!(Triangle::new(a, b, c))
        }
        6 => {
            let [a, b, c] = [point(u)?, point(u)?, point(u)?];
            let normals = [normal(u)?, normal(u)?, normal(u)?];
            let flat = Triangle::new(a, b, c);
            boxed!(flat.and_then(|triangle| triangle.with_normals(normals)))
        }
        _ if levels == 0 => None,
        7 => Some(Box::new(several_uses(u, levels - 1)?)),
        _ => Some(Box::new(node(u, levels - 1)?)),
    })
}

/// A node with up to three children.
fn node(u: &mut Unstructured, levels: u32) -> Result<Node> {
    let mut node = Node::new(transform(u)?);
    for _ in 0..u.int_in_range(0..=3)? {
        if let Some(child) = shape(u, levels)? {
            node = node.with(child);
        }
    }
    Ok(node)
}

/// A node with up to three uses of the same shapes.
fn several_uses(u: &mut Unstructured, levels: u32) -> Result<Node> {
    let mut shapes = Vec::new();
    for _ in 0..u.int_in_range(1..=7)? {
        shapes.extend(shape(u, levels)?);
    }
    let shared = Shared::new(shapes, KINDS);
    let mut node = Node::new(transform(u)?);
    for _ in 0..u.int_in_range(1..=3)? {
        let used = Node::new(transform(u)?).with(shared.clone());
        node = node.with(used);
    }
    Ok(node)
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

/// A camera of one of the three kinds; a valid default if the constructor refuses the
/// numbers, so that the rest of the bytes is used.
pub fn camera(u: &mut Unstructured) -> Result<Box<dyn Camera>> {
    let kind = u.int_in_range(0..=3)?;
    let (eye, gaze) = (point(u)?, vector(u)?);
    let (up, size) = (vector(u)?, number(u)?);
    let camera: Option<Box<dyn Camera>> = match kind {
        0 => boxed!(PinholeCamera::new(eye, size)),
        1 => boxed!(OrthographicCamera::new(eye, gaze, up, size)),
        2 => boxed!(PerspectiveCamera::new(eye, gaze, up, size)),
        _ => {
            // Where small numbers put shapes.
            let to_origin = Point3::ORIGIN - eye;
            let y = Vector3::new(0.0, 1.0, 0.0);
            boxed!(PerspectiveCamera::new(eye, to_origin, y, 0.75))
        }
    };
    let default = || boxed!(PinholeCamera::new(Point3::new(1.0, 2.0, 20.0), 1.0));
    Ok(camera.or_else(default).expect("a camera"))
}
