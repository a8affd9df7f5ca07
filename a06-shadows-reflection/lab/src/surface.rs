//! `Surface`: a shape whose rays are to leave it, and how a point is put back on it.

use std::rc::Rc;

use a02_math::arrays::array;
use a02_math::{Direction, Normal3, Point3, Vector3};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle, World};
use a04_lab::support::{Triple, point};
use common::{Color, Error};

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
    put_back: Option<PutBack>,
}

/// Finds the point of a surface that is nearest to a point close to it.
type PutBack = Rc<dyn Fn(Point3) -> OnSurface>;

/// A point that is put back on a surface.
pub struct OnSurface {
    pub point: Point3,
    /// The largest of the shape's numbers from which the point is computed, and from which a test
    /// of a ray there is.
    pub scale: f64,
}

impl Surface {
    /// The nearest point of the surface; a shape that cannot find it returns the point as it is.
    pub fn put_back(&self, point: Point3) -> OnSurface {
        match &self.put_back {
            Some(put_back) => put_back(point),
            None => OnSurface { point, scale: 0.0 },
        }
    }
}

pub fn world(shape: impl Geometry) -> Result<World<()>, Error> {
    Ok(World::new(Color::BLACK)?.with(shape, ()))
}

/// A shape on which no point is put back.
pub fn surface(shape: impl Geometry) -> Result<Surface, Error> {
    Ok(Surface {
        world: Rc::new(world(shape)?),
        put_back: None,
    })
}

fn with_put_back(
    shape: impl Geometry,
    put_back: impl Fn(Point3) -> OnSurface + 'static,
) -> Result<Surface, Error> {
    Ok(Surface {
        put_back: Some(Rc::new(put_back)),
        ..surface(shape)?
    })
}

pub fn sphere(center: Point3, radius: f64) -> Result<Surface, Error> {
    with_put_back(Sphere::new(center, radius)?, move |p| {
        let from_center = p - center;
        OnSurface {
            point: center + from_center * (radius / from_center.magnitude()),
            scale: radius,
        }
    })
}

pub fn plane(a: Point3, normal: Normal3) -> Result<Surface, Error> {
    let plane = Plane::new(a, normal)?;
    let n = plane.normal();
    with_put_back(plane, move |p| {
        let to_a = a - p;
        OnSurface {
            point: p + Vector3::from(n) * to_a.dot(n),
            scale: to_a.dot_of_magnitudes(n),
        }
    })
}

/// A box between two opposite corners.
pub fn cuboid(least: Triple, greatest: Triple) -> Result<Surface, Error> {
    let shape = AxisAlignedBox::new(point(least), point(greatest))?;
    with_put_back(shape, move |p| {
        let p = array(p);
        let (mut nearest, mut distance) = (p, f64::INFINITY);
        for axis in 0..3 {
            for face in [least[axis], greatest[axis]] {
                let from_face = (p[axis] - face).abs();
                if from_face < distance {
                    distance = from_face;
                    nearest = p;
                    nearest[axis] = face;
                }
            }
        }
        OnSurface {
            point: point(nearest),
            scale: 0.0,
        }
    })
}

pub fn triangle([a, b, c]: [Point3; 3]) -> Result<Surface, Error> {
    let edges = [b - a, c - a, c - b].map(Vector3::magnitude);
    let longest = edges.into_iter().fold(0.0, f64::max);
    let across = (b - a).cross(c - a);
    let scale = longest / across.magnitude() * longest * longest;
    let n = across.unit("normal")?;
    with_put_back(Triangle::new(a, b, c)?, move |p| OnSurface {
        point: p + n * (a - p).dot(n),
        scale,
    })
}

/// The point at a position of the scene of size 1, in a scene of this size.
pub fn at(size: f64, position: Triple) -> Point3 {
    point(position.map(|x| x * size))
}
