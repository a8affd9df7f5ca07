//! `Subject`: a shape as some numbers, with the lesson's formula, the protocol's, and exact ones.

use a02_math::Normal3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::Error;
use measure::extremes::{Both, Outcome};

use super::certified::{Decide, decide};
use super::exact::{self, DoubleDouble};
use super::protocol;
use super::support::{
    Line, Triple, any_ray, arrays, first, plane_condition, point, sphere_condition,
    triangle_condition, unit_ray, vector,
};
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere, Triangle};

/// A shape that some numbers describe.
pub struct Subject {
    pub name: &'static str,
    /// Its constructor in Rust, with `#` instead of each number.
    pub written: &'static str,
    pub make: fn(&[f64]) -> Option<Box<dyn Geometry>>,
    /// The point near the shape that three numbers, mostly from -1 to 1, stand for.
    pub aim: fn(&[f64], &[f64]) -> Triple,
    pub decide: Decide,
    /// The `t` of a hit with 30 digits, and its condition. It is infinite where the ray starts on
    /// the shape: moved by any length, the origin may lie before the shape, and its hit there is
    /// the nearest.
    pub exact: fn(&[f64], &[Triple; 2]) -> Exact,
    pub protocol: fn(&[f64], &Ray) -> Option<f64>,
}

pub type Exact = Option<(DoubleDouble, f64)>;

/// The `t` of a ray at a face of a box, the axis of the face, and its coordinate.
type Meeting = (DoubleDouble, usize, f64);

/// The shapes of this stage.
pub static SUBJECTS: [Subject; 4] = [SPHERE, PLANE, BOX, TRIANGLE];

pub const SPHERE: Subject = Subject {
    name: "sphere",
    written: "Sphere::new(Point3::new(#, #, #), #)",
    make: |x| Some(Box::new(Sphere::new(point(triple(x)), x[3]).ok()?)),
    aim: |x, aim| std::array::from_fn(|i| x[i] + x[3] * aim[i]),
    decide,
    exact: |x, line @ [o, d]| {
        let roots = exact::sphere(&triple(x), x[3], o, d).roots?;
        let t = roots.into_iter().find(|t| t.value() > 0.0)?;
        let starts_on_it = roots.into_iter().any(|t| t.value() == 0.0);
        let condition = if starts_on_it {
            f64::INFINITY
        } else {
            sphere_condition(&triple(x), x[3], line, t.value())
        };
        Some((t, condition))
    },
    protocol: |x, ray| {
        let [o, d] = arrays(ray);
        protocol::sphere(&triple(x), x[3], &o, &d)
    },
};

pub const PLANE: Subject = Subject {
    name: "plane",
    written: "Plane::new(Point3::new(#, #, #), Normal3::new(#, #, #))",
    make: |x| Some(Box::new(plane(x)?)),
    aim: |x, aim| std::array::from_fn(|i| x[i] + aim[i]),
    decide,
    exact: |x, line @ [o, d]| {
        let n = array(plane(x)?.normal());
        let t = exact::plane(&triple(x), &n, o, d);
        Some((t, plane_condition(&triple(x), n, line, t.value())))
    },
    protocol: |x, ray| protocol::plane(point(triple(x)), unit_normal(x), ray),
};

pub const BOX: Subject = Subject {
    name: "box",
    written: "AxisAlignedBox::new(Point3::new(#, #, #), Point3::new(#, #, #))",
    make: |x| {
        Some(Box::new(
            AxisAlignedBox::new(point(triple(x)), point(triple(&x[3..]))).ok()?,
        ))
    },
    aim: |x, aim| std::array::from_fn(|i| x[i] + 0.5 * (x[i + 3] - x[i]) * (aim[i] + 1.0)),
    decide,
    exact: |x, line @ [o, d]| {
        // The `t` of both faces of each slab, in order, and the coordinate of the face.
        let slabs = (0..3).filter(|axis| d[*axis] != 0.0).map(|axis| {
            let meet = |face| {
                let t = (DoubleDouble::from(face) - o[axis].into()) / d[axis].into();
                (t, axis, face)
            };
            let [a, b] = [x[axis], x[axis + 3]].map(meet);
            if a.0.value() < b.0.value() {
                [a, b]
            } else {
                [b, a]
            }
        });
        let by_t = |a: &Meeting, b: &Meeting| a.0.value().total_cmp(&b.0.value());
        let near = slabs.clone().map(|slab| slab[0]).max_by(by_t)?;
        let far = slabs.map(|slab| slab[1]).min_by(by_t)?;
        let (t, axis, face) = if near.0.value() > 0.0 { near } else { far };
        let mut normal = [0.0; 3];
        normal[axis] = 1.0;
        let condition = if near.0.value() == 0.0 {
            f64::INFINITY
        } else {
            plane_condition(&[face; 3], normal, line, t.value())
        };
        Some((t, condition))
    },
    protocol: |x, ray| {
        let low = std::array::from_fn(|i| x[i].min(x[i + 3]));
        let high = std::array::from_fn(|i| x[i].max(x[i + 3]));
        protocol::axis_aligned_box(point(low), point(high), ray, protocol::Compared::Three)
    },
};

pub const TRIANGLE: Subject = Subject {
    name: "triangle",
    written: "Triangle::new(Point3::new(#, #, #), Point3::new(#, #, #), Point3::new(#, #, #))",
    make: |x| {
        let [a, b, c] = corners(x).map(point);
        Some(Box::new(Triangle::new(a, b, c).ok()?))
    },
    aim: |x, aim| {
        let [a, b, c] = corners(x);
        std::array::from_fn(|i| a[i] + (b[i] - a[i]) * aim[0] + (c[i] - a[i]) * aim[1])
    },
    decide,
    exact: |x, line @ [o, d]| {
        let [t, beta, gamma] = exact::triangle(&corners(x), o, d);
        let fractions = [beta.value(), gamma.value()];
        Some((
            t,
            triangle_condition(&corners(x), fractions, line, t.value()),
        ))
    },
    protocol: |x, ray| protocol::triangle(&corners(x).map(point), ray),
};

/// The first three numbers.
pub fn triple(x: &[f64]) -> Triple {
    [x[0], x[1], x[2]]
}

fn corners(x: &[f64]) -> [Triple; 3] {
    [0, 3, 6].map(|corner| triple(&x[corner..]))
}

/// The normal of a plane or disc, of length 1 where this is possible.
pub fn unit_normal(x: &[f64]) -> Normal3 {
    let n = vector(triple(&x[3..]));
    n.normalized().unwrap_or(n).as_normal()
}

fn plane(x: &[f64]) -> Option<Plane> {
    Plane::new(point(triple(x)), vector(triple(&x[3..])).as_normal()).ok()
}

impl Subject {
    /// The shape of this name.
    pub fn named<'a>(subjects: &'a [Self], name: &str) -> Result<&'a Self, Error> {
        let found = subjects.iter().find(|subject| subject.name == name);
        found.ok_or_else(|| {
            let names: Vec<_> = subjects.iter().map(|subject| subject.name).collect();
            let names = names.join(", ");
            Error::Usage(format!(
                "no shape \"{name}\" is searched here, only {names}"
            ))
        })
    }

    /// The nearest hit of a ray by the lesson's formula and the protocol's; and the exact one by
    /// intervals and 30 digits, unless they leave it open.
    pub fn met(&self, numbers: &[f64], line: Line) -> Both {
        let (ray, made) = (any_ray(line), (self.make)(numbers).zip(unit_ray(line).ok()));
        let theirs = (self.protocol)(numbers, &ray).into();
        let Some((shape, ray)) = made else {
            return Both::from([Outcome::Refused, theirs]);
        };
        let exact = (self.exact)(numbers, &arrays(&ray));
        let certified = match (self.decide)(&*shape, &ray, Interval::AHEAD) {
            Some(true) => exact.map(|(t, _)| t.value().into()),
            Some(false) => Some(Outcome::Nothing),
            None => None,
        };
        Both {
            outcomes: [first(&*shape, &ray).into(), theirs],
            condition: exact.map(|(_, condition)| condition),
            certified,
        }
    }

    /// The lesson's formula.
    pub fn lesson(&self, numbers: &[f64], ray: &Ray) -> Option<f64> {
        first(&*(self.make)(numbers)?, ray)
    }
}
