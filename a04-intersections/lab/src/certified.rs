//! `certified`: decides by interval arithmetic whether a ray hits a shape, and compares the
//! lesson's decision with it. A picture without an open decision shows what the exact hits of
//! its rays would.

use std::any::Any;
use std::cell::Cell;

use a02_math::arrays::array;
use a03_rays_cameras::{Camera, Ray};
use common::{Color, Settings};

use crate::enclosure::Enclosure;
use crate::formula;
use crate::formula::sphere;
use crate::line::Line;
use crate::number::{Triple, cross, difference, dot};
use crate::support::{corners, numbers};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};

/// Whether a ray hits a shape; `None` if the enclosures leave it open.
pub type Decision = Option<bool>;

/// How many decisions are not certified.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uncertified {
    /// Left open by the enclosures: the number of decisions, or of pixels with such decisions.
    pub open: u32,
    /// Wrong decisions of the lesson.
    pub wrong: u32,
}

thread_local! {
    /// The decisions for a pixel.
    static COUNTS: Cell<Uncertified> = const { Cell::new(Uncertified { open: 0, wrong: 0 }) };
}

/// The number of pixels with an open decision in a picture of the default size, one ray a pixel,
/// and of wrong decisions of the lesson. The geometries of the world are wrapped by [`geometry`].
pub fn picture(camera: &dyn Camera, radiance: impl Fn(&Ray) -> Color) -> Uncertified {
    let size = Settings::default().size;
    let mut of_picture = Uncertified::default();
    for row in 0..size.height() {
        for column in 0..size.width() {
            COUNTS.take();
            radiance(&camera.ray_for(size, column.into(), row.into()));
            let of_pixel = COUNTS.take();
            of_picture.open += u32::from(of_pixel.open > 0);
            of_picture.wrong += of_pixel.wrong;
        }
    }
    of_picture
}

/// A geometry whose decisions are certified.
#[derive(Debug)]
struct Certified {
    geometry: Box<dyn Geometry>,
    decide: Decide,
}

/// Decides whether a ray hits a shape within an interval.
pub type Decide = fn(&dyn Geometry, &Ray, Interval) -> Decision;

/// Wraps this geometry to certify its decisions by this function.
pub fn geometry(geometry: Box<dyn Geometry>, decide: Decide) -> Box<dyn Geometry> {
    Box::new(Certified { geometry, decide })
}

impl Geometry for Certified {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.geometry.hit(ray, within);
        let mut counts = COUNTS.get();
        match (self.decide)(&*self.geometry, ray, within) {
            None => counts.open += 1,
            Some(is_hit) => counts.wrong += u32::from(is_hit != hit.is_some()),
        }
        COUNTS.set(counts);
        hit
    }
}

/// The decision for the shapes of this stage; for other types it stays open.
pub fn decide(shape: &dyn Geometry, ray: &Ray, within: Interval) -> Decision {
    let line = Line::of(ray).to();
    let any: &dyn Any = shape;
    if let Some(sphere) = any.downcast_ref::<Sphere>() {
        hits_sphere(sphere, &line, within)
    } else if let Some(aab) = any.downcast_ref::<AxisAlignedBox>() {
        hits_box(aab, &line, within)
    } else if let Some(triangle) = any.downcast_ref::<Triangle>() {
        hits_triangle(triangle, &line, within)
    } else {
        hits_plane(any.downcast_ref::<Plane>()?, &line, within)
    }
}

/// Whether a `t` lies within the interval.
pub fn contains(within: Interval, t: Enclosure) -> Decision {
    if t.low > within.min && t.high < within.max {
        Some(true)
    } else if t.high <= within.min || t.low >= within.max {
        Some(false)
    } else {
        None
    }
}

/// Whether any of two decisions is true.
fn either(a: Decision, b: Decision) -> Decision {
    match (a, b) {
        (Some(true), _) | (_, Some(true)) => Some(true),
        (Some(false), Some(false)) => Some(false),
        _ => None,
    }
}

/// The numbers of a shape as enclosures.
pub fn enclosed<const N: usize>(numbers: [f64; N]) -> [Enclosure; N] {
    numbers.map(Enclosure::from)
}

/// Of a ray that may be parallel to the plane or not, `t` is everything, and the decision stays open.
fn hits_plane(plane: &Plane, line: &Line<Enclosure>, within: Interval) -> Decision {
    let point = enclosed(numbers(plane, "point"));
    let normal = enclosed(numbers(plane, "normal"));
    if dot(&line.direction, &normal).is_zero() {
        return Some(false);
    }
    contains(within, formula::plane::t(&point, &normal, line))
}

fn hits_sphere(sphere: &Sphere, line: &Line<Enclosure>, within: Interval) -> Decision {
    let center = enclosed(numbers(sphere, "center"));
    let [radius] = enclosed(numbers(sphere, "radius"));
    let f = difference(&line.origin, &center);
    let terms = sphere::terms(&f, radius, &line.direction);
    if terms.discriminant.high < 0.0 {
        return Some(false);
    }
    let [near, far] = terms.plain_roots().map(|root| contains(within, root));
    match either(near, far) {
        Some(true) if terms.discriminant.low < 0.0 => None,
        decision => decision,
    }
}

fn hits_box(aab: &AxisAlignedBox, line: &Line<Enclosure>, within: Interval) -> Decision {
    let (o, d) = (&line.origin, &line.direction);
    let lbf: Triple<Enclosure> = enclosed(numbers(aab, "lbf"));
    let run: Triple<Enclosure> = enclosed(numbers(aab, "run"));
    let mut near = Enclosure::from(f64::NEG_INFINITY);
    let mut far = Enclosure::from(f64::INFINITY);
    for axis in 0..3 {
        let (low, high) = (lbf[axis], run[axis]);
        let Some(is_ahead) = d[axis].sign() else {
            // Along the faces: the borders belong to the box.
            if o[axis].low < low.low || o[axis].low > high.low {
                return Some(false);
            }
            continue;
        };
        let [at_low, at_high] = [low, high].map(|face| (face - o[axis]) / d[axis]);
        let (enter, leave) = if is_ahead {
            (at_low, at_high)
        } else {
            (at_high, at_low)
        };
        near = near.max(enter);
        far = far.min(leave);
    }
    if near.low > far.high {
        return Some(false);
    }
    match either(contains(within, near), contains(within, far)) {
        Some(true) if near.high > far.low => None,
        decision => decision,
    }
}

fn hits_triangle(triangle: &Triangle, line: &Line<Enclosure>, within: Interval) -> Decision {
    let corners = corners(triangle).map(|corner| enclosed(array(corner)));
    let [a, b, c] = corners.map(|corner| difference(&corner, &line.origin));
    let d = &line.direction;
    // Six times the volumes between the ray and the edges.
    let sides = [(&c, &b), (&a, &c), (&b, &a)].map(|(p, q)| dot(d, &cross(p, q)));
    let signs = sides.map(Enclosure::sign);
    if signs.contains(&Some(true)) && signs.contains(&Some(false)) {
        return Some(false);
    }
    let n = cross(&difference(&b, &a), &difference(&c, &a));
    let t = dot(&a, &n) / dot(d, &n);
    let is_within = contains(within, t);
    // Edges belong to the triangle.
    let is_decided = sides
        .iter()
        .all(|side| side.sign().is_some() || side.is_zero());
    if is_decided || is_within == Some(false) {
        is_within
    } else {
        None
    }
}
