//! Shapes, cameras and transforms from bytes, if their constructors accept the numbers.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use a07_transforms::{Disc, Node, Transform};
use arbitrary::{Result, Unstructured};
use common::ArgumentError;

use crate::number::{normal, number, point, vector};

/// The result of a constructor; an error must have a message.
pub fn accepted<T>(made: std::result::Result<T, ArgumentError>) -> Option<T> {
    made.inspect_err(|error| assert!(error.to_string().contains(" must be ")))
        .ok()
}

/// A boxed trait object of the result of a constructor.
macro_rules! boxed {
    ($made:expr) => {
        accepted($made).map(|made| Box::new(made) as _)
    };
}
pub(crate) use boxed;

/// A shape, with up to three levels of nodes; none if its constructor refuses the numbers.
pub fn shape(u: &mut Unstructured) -> Result<Option<Box<dyn Geometry>>> {
    shape_below(u, 3)
}

fn shape_below(u: &mut Unstructured, levels: u32) -> Result<Option<Box<dyn Geometry>>> {
    Ok(match u.int_in_range(0..=7)? {
        0 => boxed!(Plane::new(point(u)?, normal(u)?)),
        1 => boxed!(AxisAlignedBox::new(point(u)?, point(u)?)),
        2 => boxed!(Disc::new(point(u)?, normal(u)?, number(u)?)),
        3 | 4 => boxed!(Sphere::new(point(u)?, number(u)?)),
        5 => boxed!(Triangle::new(point(u)?, point(u)?, point(u)?)),
        6 => {
            let corners = Triangle::new(point(u)?, point(u)?, point(u)?);
            let normals = [normal(u)?, normal(u)?, normal(u)?];
            boxed!(corners.and_then(|triangle| triangle.with_normals(normals)))
        }
        _ if levels == 0 => None,
        _ => {
            let mut node = Node::new(transform(u)?);
            for _ in 0..u.int_in_range(0..=3)? {
                if let Some(child) = shape_below(u, levels - 1)? {
                    node = node.with(child);
                }
            }
            Some(Box::new(node))
        }
    })
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
            _ => transform.scale(number(u)?, number(u)?, number(u)?),
        };
        transform = accepted(step).unwrap_or(transform);
    }
    Ok(transform)
}

/// A camera of one of the three kinds; a valid default if the constructor refuses the
/// numbers, so that the rest of the bytes is used.
pub fn camera(u: &mut Unstructured) -> Result<Box<dyn Camera>> {
    let camera: Option<Box<dyn Camera>> = match u.int_in_range(0..=3)? {
        0 => boxed!(PinholeCamera::new(point(u)?, number(u)?)),
        kind @ (1 | 2) => {
            let (e, g, up, size) = (point(u)?, vector(u)?, vector(u)?, number(u)?);
            match kind {
                1 => boxed!(OrthographicCamera::new(e, g, up, size)),
                _ => boxed!(PerspectiveCamera::new(e, g, up, size)),
            }
        }
        // Towards the origin, where small numbers put shapes.
        _ => {
            let (e, up) = (point(u)?, Vector3::new(0.0, 1.0, 0.0));
            boxed!(PerspectiveCamera::new(e, Point3::ORIGIN - e, up, 0.75))
        }
    };
    let default = || boxed!(PinholeCamera::new(Point3::new(1.0, 2.0, 20.0), 1.0));
    Ok(camera.or_else(default).expect("a camera"))
}
