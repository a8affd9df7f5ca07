//! Rays that leave shapes of all sizes, near the origin and far away, steep and grazing, to
//! both sides, compared with the solution.

use crate::prelude::*;

yours! { secondary_ray }

type Code = fn(&Ray, &Hit, Vector3) -> Ray;

pub fn exercise() -> Exercise<Code> {
    // Around a point, with this normal and of this size.
    let shapes: [fn(Point3, Vector3, f64) -> Made<Box<dyn Geometry>>; 3] = [
        |p, n, _| Ok(Box::new(Plane::new(p, n.as_normal())?)),
        |p, n, size| Ok(Box::new(Sphere::new(p - n * size, size)?)),
        |p, n, size| Ok(Box::new(smooth_triangle(p, n, size)?)),
    ];
    let forms = shapes.map(|shape| {
        Form::new(move |secondary_ray: &Code, departure: Departure| {
            let p = Point3::ORIGIN + vector(departure.point) * departure.size;
            let shape = shape(p, unit(departure.normal), departure.size).ok()?;
            departure.answer(p, &*shape, secondary_ray)
        })
    });
    Exercise {
        forms: forms.into(),
        picture: StudentPicture::scene("sphere", |leaving: &Code, settings| {
            traced_picture(scenes::sphere()?, settings, |world, ray, depth| {
                let tracer = Tracer {
                    world,
                    is_shadowed: &is_shadowed,
                    secondary_ray: leaving,
                };
                tracer.trace(ray, depth)
            })
        }),
        ..Exercise::default()
    }
}

/// A ray that leaves a shape. Normal and direction have length 1.
#[derive(Clone, Default)]
struct Departure {
    /// The normal at the point.
    normal: [f64; 3],
    /// The radius of a sphere, and half the height of a triangle.
    size: f64,
    /// The point, in sizes.
    point: [f64; 3],
    /// The vector from the point to the eye, in sizes.
    to_eye: [f64; 3],
    /// The direction of the ray that leaves.
    direction: [f64; 3],
}

input! { Departure: normal, size, point, to_eye, direction }

impl Departure {
    /// Whether this function makes the ray leave the shape at `p`, and in which direction.
    fn answer(self, p: Point3, shape: &dyn Geometry, secondary_ray: &Code) -> Option<Answer> {
        let to_eye = vector(self.to_eye) * self.size;
        let direction = unit(self.direction);
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
