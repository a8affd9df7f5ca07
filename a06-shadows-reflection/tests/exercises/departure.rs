//! Rays that leave shapes of all sizes, near the origin and far away.

use crate::prelude::*;

pub const SHAPES: [&str; 3] = ["plane", "sphere", "smooth triangle"];

/// A ray that leaves a shape. Normal and direction have length 1.
#[derive(Clone)]
pub struct Departure {
    /// One of [`SHAPES`].
    pub shape: &'static str,
    /// The normal at the point.
    pub normal: [f64; 3],
    /// The radius of a sphere, and half the height of a triangle.
    pub size: f64,
    /// The point, in sizes.
    pub point: [f64; 3],
    /// The vector from the point to the eye, in sizes.
    pub to_eye: [f64; 3],
    /// The direction of the ray that leaves.
    pub direction: [f64; 3],
}

input! { Departure: shape, normal, size, point, to_eye, direction }

impl Departure {
    /// A random one: steep and grazing, outwards and inwards.
    pub fn any(r: &mut Random) -> Self {
        Self::with_slope(r, [1.0, -1.0, 1e-3, -1e-3])
    }

    /// A random one that is almost parallel to the surface.
    pub fn grazing(r: &mut Random) -> Self {
        Self::with_slope(r, [1e-6, -1e-6, 1e-8, -1e-8])
    }

    /// A random one, with one of these slopes.
    fn with_slope<const N: usize>(r: &mut Random, slopes: [f64; N]) -> Self {
        let (normal, point) = (unit(r.triple(1.0)), r.triple(5.0));
        let side = unit(array(normal.cross(vector(r.triple(1.0)))));
        // Near, far from the origin, and, at the origin, far from the eye and close to it.
        let places = [[1.0, 1.0], [1e7, 1.0], [0.0, 1e7], [0.0, 1e-4]];
        let [from_origin, from_eye] = places[r.below(4) as usize];
        let to_eye = (normal * r.between(0.5, 3.0) + side * r.between(-3.0, 3.0)) * from_eye;
        let direction = side + normal * slopes[r.below(N as u32) as usize];
        Self {
            shape: SHAPES[r.below(3) as usize],
            normal: array(normal),
            size: r.scale(),
            point: point.map(|x| x * from_origin),
            to_eye: array(to_eye),
            direction: array(unit(array(direction))),
        }
    }

    /// Whether this function makes the ray leave the shape, and in which direction.
    pub fn answer(self, secondary_ray: &dyn Fn(&Ray, &Hit, Vector3) -> Ray) -> Option<Answer> {
        let p = Point3::ORIGIN + vector(self.point) * self.size;
        let to_eye = vector(self.to_eye) * self.size;
        let (normal, direction) = (unit(self.normal), unit(self.direction));
        let shape: Box<dyn Geometry> = match self.shape {
            "plane" => Box::new(Plane::new(p, normal.as_normal()).ok()?),
            "sphere" => Box::new(Sphere::new(p - normal * self.size, self.size).ok()?),
            _ => Box::new(smooth_triangle(p, normal, self.size).ok()?),
        };
        let ray = Ray::new(p + to_eye, -to_eye).ok()?;
        let hit = shape.hit(&ray, Interval::AHEAD)?;
        let left = secondary_ray(&ray, &hit, direction);
        let step = left.origin() - ray.at(hit.t);
        let slope = direction.dot(hit.geometric_normal);
        // Inwards, a ray meets the far side of a sphere, but not this one.
        let again = shape.hit(&left, Interval::before(0.1 * slope.abs() * self.size));
        let words = if step.magnitude() == 0.0 {
            "a ray that begins at the hit: it is not moved"
        } else if step.dot(hit.geometric_normal) * slope <= 0.0 {
            "a ray from the wrong side of the surface"
        } else if step.magnitude() > 1e-9 * with_errors(&ray, &hit) {
            "a ray that begins far away"
        } else if again.is_some() {
            "a ray that hits the surface again"
        } else {
            "a ray that leaves the surface"
        };
        Some(Answer::words(words).and("direction", array(left.direction())))
    }
}

/// The sum of the numbers at a hit that have rounding errors: the largest coordinates of the ray's origin
/// and of the point, the parameter of the ray, and the scale of the shape.
fn with_errors(ray: &Ray, hit: &Hit) -> f64 {
    let (origin, point) = (ray.origin(), ray.at(hit.t));
    origin.largest_coordinate() + point.largest_coordinate() + hit.t + hit.scale
}
