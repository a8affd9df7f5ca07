//! `Surface`: a shape whose rays are to leave it, alone in a world.

use std::rc::Rc;

use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle, World};
use a04_lab::support::{Triple, point};
use common::{Color, Error};

/// A world of one shape.
pub type Surface = Rc<World<()>>;

/// A shape in a scene of this size.
pub type Shape = fn(f64) -> Result<Surface, Error>;

/// The shapes of this stage, leaning and perpendicular to an axis.
pub const SHAPES: [Shape; 6] = [
    |size| sphere(at(size, [0.1, 0.2, 0.3]), 0.7 * size),
    |size| plane(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.3, 1.0, 0.2)),
    |size| plane(at(size, [0.1, 0.2, 0.3]), Normal3::new(0.0, 1.0, 0.0)),
    |size| cuboid(at(size, [-0.3, -0.5, -0.1]), at(size, [0.6, 0.7, 0.8])),
    |size| {
        let corners = [[-0.9, -0.3, -0.5], [1.2, 0.1, -0.6], [0.3, 0.4, 1.3]];
        triangle(corners.map(|corner| at(size, corner)))
    },
    |size| {
        let corners = [[-0.9, 0.2, -0.5], [1.2, 0.2, -0.6], [0.3, 0.2, 1.3]];
        triangle(corners.map(|corner| at(size, corner)))
    },
];

pub fn surface(shape: impl Geometry) -> Result<Surface, Error> {
    Ok(Rc::new(World::new(Color::BLACK)?.with(shape, ())))
}

pub fn sphere(center: Point3, radius: f64) -> Result<Surface, Error> {
    surface(Sphere::new(center, radius)?)
}

pub fn plane(a: Point3, normal: Normal3) -> Result<Surface, Error> {
    surface(Plane::new(a, normal)?)
}

/// A box between two opposite corners.
pub fn cuboid(least: Point3, greatest: Point3) -> Result<Surface, Error> {
    surface(AxisAlignedBox::new(least, greatest)?)
}

pub fn triangle([a, b, c]: [Point3; 3]) -> Result<Surface, Error> {
    surface(Triangle::new(a, b, c)?)
}

/// The point at a position of the scene of size 1, in a scene of this size.
pub fn at(size: f64, position: Triple) -> Point3 {
    point(position.map(|x| x * size))
}
