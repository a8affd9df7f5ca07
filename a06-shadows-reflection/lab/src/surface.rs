//! `Surface`: a shape whose rays are to leave it.

use std::rc::Rc;

use a02_math::arrays::array;
use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle, World};
use a04_lab::support::{Triple, point};
use common::{Color, Error};

use crate::form::Form;

/// A shape in a scene of this size.
pub type Shape = fn(f64) -> Result<Surface, Error>;

/// The shapes of this stage, leaning and perpendicular to an axis.
pub const SHAPES: [Shape; 6] = [
    |size| sphere(at(size, [0.1, 0.2, 0.3]), 0.7 * size),
    |size| plane(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.3, 1.0, 0.2)),
    |size| plane(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.0, 1.0, 0.0)),
    |size| {
        let least = [-0.3, -0.5, -0.1].map(|x| x * size);
        let greatest = [0.6, 0.7, 0.8].map(|x| x * size);
        cuboid(least, greatest)
    },
    |size| {
        let corners = [[-0.9, -0.3, -0.5], [1.2, 0.1, -0.6], [0.3, 0.4, 1.3]];
        triangle(corners.map(|corner| at(size, corner)))
    },
    |size| {
        let corners = [[-0.9, 0.2, -0.5], [1.2, 0.2, -0.6], [0.3, 0.2, 1.3]];
        triangle(corners.map(|corner| at(size, corner)))
    },
];

/// A world of one shape.
#[derive(Clone)]
pub struct Surface {
    pub world: Rc<World<()>>,
    /// Its numbers, where a point can be reprojected onto it.
    pub form: Option<Form>,
}

pub fn world(shape: impl Geometry) -> Result<World<()>, Error> {
    Ok(World::new(Color::BLACK)?.with(shape, ()))
}

/// A shape onto which no point is reprojected.
pub fn surface(shape: impl Geometry) -> Result<Surface, Error> {
    Ok(Surface {
        world: Rc::new(world(shape)?),
        form: None,
    })
}

fn with_form(shape: impl Geometry, form: Form) -> Result<Surface, Error> {
    Ok(Surface {
        form: Some(form),
        ..surface(shape)?
    })
}

pub fn sphere(center: Point3, radius: f64) -> Result<Surface, Error> {
    let form = Form::Sphere {
        center: array(center),
        radius,
    };
    with_form(Sphere::new(center, radius)?, form)
}

pub fn plane(a: Point3, normal: Normal3) -> Result<Surface, Error> {
    let plane = Plane::new(a, normal)?;
    let form = Form::Plane {
        a: array(a),
        normal: array(plane.normal()),
    };
    with_form(plane, form)
}

/// A box between two opposite corners.
pub fn cuboid(least: Triple, greatest: Triple) -> Result<Surface, Error> {
    let shape = AxisAlignedBox::new(point(least), point(greatest))?;
    with_form(shape, Form::Box { least, greatest })
}

pub fn triangle([a, b, c]: [Point3; 3]) -> Result<Surface, Error> {
    let form = Form::Triangle {
        corners: [a, b, c].map(array),
    };
    with_form(Triangle::new(a, b, c)?, form)
}

/// The point at a position of the scene of size 1, in a scene of this size.
pub fn at(size: f64, position: Triple) -> Point3 {
    point(position.map(|x| x * size))
}
