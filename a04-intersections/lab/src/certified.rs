//! `certified`: decides by interval arithmetic whether a ray hits a shape, and compares the
//! lesson's decision with it. A picture without an open decision shows what the exact hits of
//! its rays would.

use a02_math::arrays::array;
use std::any::Any;
use std::cell::Cell;
use std::ops::Not;

use a03_rays_cameras::{Camera, Ray};
use common::{Color, Settings};

use super::enclosure::Enclosure;
use super::support::{arrays, corners, dot, numbers};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};

/// Whether a ray hits a shape; `None` if the enclosures leave it open.
pub type Decision = Option<bool>;

thread_local! {
    /// The decisions for a pixel: open ones, and wrong ones of the lesson.
    static COUNTS: Cell<[u32; 2]> = const { Cell::new([0; 2]) };
}

/// The number of pixels with an open decision in a picture of the default size, one ray a pixel,
/// and of wrong decisions of the lesson. The geometries of the world are wrapped by [`geometry`].
pub fn picture(camera: &dyn Camera, radiance: impl Fn(&Ray) -> Color) -> [u32; 2] {
    let size = Settings::default().size;
    let (mut open_pixels, mut all_wrong) = (0, 0);
    for row in 0..size.height() {
        for column in 0..size.width() {
            COUNTS.take();
            radiance(&camera.ray_for(size, column.into(), row.into()));
            let [open, wrong] = COUNTS.take();
            open_pixels += u32::from(open > 0);
            all_wrong += wrong;
        }
    }
    [open_pixels, all_wrong]
}

/// A geometry whose decisions are certified.
#[derive(Debug)]
struct Certified(Box<dyn Geometry>, Decide);

/// Decides whether a ray hits a shape within an interval.
pub type Decide = fn(&dyn Geometry, &Ray, Interval) -> Decision;

/// Wraps this geometry to certify its decisions by this function.
pub fn geometry(geometry: Box<dyn Geometry>, decide: Decide) -> Box<dyn Geometry> {
    Box::new(Certified(geometry, decide))
}

impl Geometry for Certified {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let hit = self.0.hit(ray, within);
        let [open, wrong] = COUNTS.get();
        COUNTS.set(match (self.1)(&*self.0, ray, within) {
            None => [open + 1, wrong],
            Some(exact) => [open, wrong + u32::from(exact != hit.is_some())],
        });
        hit
    }
}

/// The decision for the shapes of this stage; for other types it stays open.
pub fn decide(shape: &dyn Geometry, ray: &Ray, within: Interval) -> Decision {
    let line = arrays(ray).map(|triple| triple.map(Enclosure::from));
    let any: &dyn Any = shape;
    if let Some(sphere) = any.downcast_ref::<Sphere>() {
        hits_sphere(sphere, &line, within)
    } else if let Some(aab) = any.downcast_ref::<AxisAlignedBox>() {
        hits_box(aab, &line, within)
    } else if let Some(triangle) = any.downcast_ref::<Triangle>() {
        hits_triangle(triangle, &line, within)
    } else {
        let any_plane: &Plane = any.downcast_ref()?;
        let [a, n] = ["point", "normal"].map(|key| numbers(any_plane, key).map(Enclosure::from));
        contains(within, plane(&a, &n, &line))
    }
}

/// A triple of enclosed numbers.
pub type Triple = [Enclosure; 3];

pub fn difference(a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| a[i] - b[i])
}

fn cross(a: &Triple, b: &Triple) -> Triple {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
}

/// Whether a `t` lies within the interval.
pub fn contains(within: Interval, t: Enclosure) -> Decision {
    if t.low > within.min && t.high < within.max {
        Some(true)
    } else {
        (t.high <= within.min || t.low >= within.max).then_some(false)
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

/// The `t` at a plane; everything for a ray that may be parallel, except beside the plane.
pub fn plane(a: &Triple, n: &Triple, [o, d]: &[Triple; 2]) -> Enclosure {
    dot(&difference(a, o), n) / dot(d, n)
}

/// By the discriminant `a r² - |f × d|²`, which is that of the lesson by Lagrange's identity.
fn hits_sphere(sphere: &Sphere, [o, d]: &[Triple; 2], within: Interval) -> Decision {
    let c = numbers(sphere, "center").map(Enclosure::from);
    let [r] = numbers(sphere, "radius").map(Enclosure::from);
    let f = difference(o, &c);
    let a = dot(d, d);
    let aside = cross(&f, d);
    let discriminant = a * r * r - dot(&aside, &aside);
    if discriminant.high < 0.0 {
        return Some(false);
    }
    let (middle, half) = (dot(&f, d), discriminant.sqrt());
    let zero = Enclosure::from(0.0);
    let roots = [zero - middle - half, half - middle].map(|root| contains(within, root / a));
    match either(roots[0], roots[1]) {
        Some(true) if discriminant.low < 0.0 => None,
        decision => decision,
    }
}

fn hits_box(aab: &AxisAlignedBox, [o, d]: &[Triple; 2], within: Interval) -> Decision {
    let [mut near, mut far] = [f64::NEG_INFINITY, f64::INFINITY].map(Enclosure::from);
    let corners: [[f64; 3]; 2] = ["lbf", "run"].map(|key| numbers(aab, key));
    for axis in 0..3 {
        let [low, high] = corners.map(|corner| Enclosure::from(corner[axis]));
        let Some(is_ahead) = d[axis].sign() else {
            // Along the faces: the borders belong to the box.
            if o[axis].low < low.low || o[axis].low > high.low {
                return Some(false);
            }
            continue;
        };
        let mut ts = [low, high].map(|face| (face - o[axis]) / d[axis]);
        if !is_ahead {
            ts.reverse();
        }
        near = Enclosure {
            low: near.low.max(ts[0].low),
            high: near.high.max(ts[0].high),
        };
        far = Enclosure {
            low: far.low.min(ts[1].low),
            high: far.high.min(ts[1].high),
        };
    }
    if near.low > far.high {
        return Some(false);
    }
    match either(contains(within, near), contains(within, far)) {
        Some(true) if near.high > far.low => None,
        decision => decision,
    }
}

fn hits_triangle(triangle: &Triangle, line: &[Triple; 2], within: Interval) -> Decision {
    let corners = corners(triangle).map(|c| array(c).map(Enclosure::from));
    let [a, b, c] = corners.map(|corner| difference(&corner, &line[0]));
    let d = &line[1];
    // Six times the volumes between the ray and the edges.
    let sides = [(&c, &b), (&a, &c), (&b, &a)].map(|(p, q)| dot(d, &cross(p, q)));
    let signs = sides.map(Enclosure::sign);
    if signs.contains(&Some(true)) && signs.contains(&Some(false)) {
        return Some(false);
    }
    let n = cross(&difference(&b, &a), &difference(&c, &a));
    let t = dot(&a, &n) / dot(d, &n);
    let is_within = contains(within, t);
    if signs.iter().all(Option::is_some) || is_within.is_some_and(Not::not) {
        is_within
    } else {
        None
    }
}
