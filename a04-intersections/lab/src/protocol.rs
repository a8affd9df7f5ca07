//! The formulas as the protocol prints them, mistakes included. They are
//! measured and compared; only pictures of the mistakes are rendered with them.

use a02_lab::protocol::cramer;
use a02_math::arrays::array;
use a02_math::{Direction, Mat3x3, Normal3, Point3};
use a03_rays_cameras::Ray;

use crate::formula::sphere::SphereQuery;
use crate::number::dot;

/// Least distance of a hit, included for the triangle and excluded for box and
/// sphere: a fixed number, as if all scenes had the same size and all directions
/// length 1.
pub const NEAREST: f64 = 0.001;

/// The plane. With `t > 0` a ray can hit the plane that it leaves, and an infinite
/// `t` is accepted.
pub fn plane(a: Point3, n: Normal3, ray: &Ray) -> Option<f64> {
    let across = ray.direction().dot(n);
    if across == 0.0 {
        return None;
    }
    let t = (a - ray.origin()).dot(n) / across;
    (t > 0.0).then_some(t)
}

/// The coordinates of a point on a face that are compared with the corners of the
/// box: the protocol's text allows both readings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compared {
    /// All three, including the coordinate of the face, which is only right up to
    /// rounding.
    Three,
    /// The two coordinates within the face.
    Two,
}

/// The box of six planes. The computed point is compared exactly, so that faces
/// disappear by rounding; corners in the wrong order make an empty box.
pub fn axis_aligned_box(lbf: Point3, run: Point3, ray: &Ray, compared: Compared) -> Option<f64> {
    let mut nearest: Option<f64> = None;
    for axis in 0..3 {
        for (corner, sign) in [(lbf, -1.0), (run, 1.0)] {
            let mut normal = [0.0; 3];
            normal[axis] = sign;
            let Some(t) = plane(corner, Normal3::from_glam(normal.into()), ray) else {
                continue;
            };
            let [point, low, high] = [ray.at(t), lbf, run].map(array);
            let mut is_within = true;
            for other in 0..3 {
                if other != axis || compared == Compared::Three {
                    is_within &= low[other] <= point[other] && point[other] <= high[other];
                }
            }
            if is_within && t > NEAREST && nearest.is_none_or(|nearest| t < nearest) {
                nearest = Some(t);
            }
        }
    }
    nearest
}

/// The text's literal condition for β and γ: a sum of exactly 1, which is true only
/// on the edge between b and c.
pub fn is_inside_by_the_text(beta: f64, gamma: f64) -> bool {
    beta > 0.0 && gamma > 0.0 && beta + gamma == 1.0
}

/// The triangle by Cramer's rule. The determinant is compared with 0, not with its
/// rounding error; rounding up β + γ excludes corner a, where the sum is 0;
/// neighbours round it differently, and rays pass between them.
pub fn triangle(&[a, b, c]: &[Point3; 3], ray: &Ray) -> Option<f64> {
    let (ab, ac, d) = (a - b, a - c, ray.direction());
    let system = Mat3x3::from_rows([
        [ab.x(), ac.x(), d.x()],
        [ab.y(), ac.y(), d.y()],
        [ab.z(), ac.z(), d.z()],
    ]);
    if system.determinant() == 0.0 {
        return None;
    }
    let solution = cramer(system, a - ray.origin());
    let (beta, gamma, t) = (solution.x(), solution.y(), solution.z());
    if beta < 0.0 || gamma < 0.0 || (beta + gamma).ceil() != 1.0 || t < NEAREST {
        return None;
    }
    Some(t)
}

/// The normal between the corners: not brought to length 1.
pub fn interpolated_normal([a, b, c]: [Normal3; 3], beta: f64, gamma: f64) -> Normal3 {
    a * (1.0 - beta - gamma) + b * beta + c * gamma
}

/// The sphere. Discriminant and roots cancel. The root is taken before the sign is tested.
/// Comparisons with NaN are false and exclude it, except in the last branch, which runs only for
/// the direction 0 and returns NaN.
pub fn sphere(query: &SphereQuery) -> Option<f64> {
    let Quadratic { a, b, discriminant } = sphere_equation(query);
    let minus = (-b - discriminant.sqrt()) / (2.0 * a);
    let plus = (-b + discriminant.sqrt()) / (2.0 * a);
    if minus > NEAREST {
        return Some(minus);
    } else if plus > NEAREST {
        return Some(plus);
    }
    if discriminant == 0.0 {
        let t = -b / (2.0 * a);
        if t < NEAREST {
            return None;
        }
        return Some(t);
    }
    None
}

/// The equation `a t² + b t + c = 0` of the `t` at which a line meets a sphere.
pub struct Quadratic {
    pub a: f64,
    pub b: f64,
    /// `b² - 4 a c`.
    pub discriminant: f64,
}

/// The sphere's equation.
pub fn sphere_equation(query: &SphereQuery) -> Quadratic {
    let (f, d) = (query.from_center(), &query.line.direction);
    let a = dot(d, d);
    let b = dot(d, &f.map(|x| 2.0 * x));
    let c = dot(&f, &f) - query.radius * query.radius;
    Quadratic {
        a,
        b,
        discriminant: b * b - 4.0 * a * c,
    }
}

/// A channel from 0 to 1 as the value of a byte, as Java casts it: truncated
/// instead of rounded, and not clamped.
pub fn byte(channel: f64) -> i32 {
    (channel * 255.0) as i32
}
