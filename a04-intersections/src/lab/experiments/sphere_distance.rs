//! Accuracy of the formulas for far spheres and for huge spheres.

use std::ops::Add;
use std::rc::Rc;

use a02_math::lab::exact::{product_with_error, sum_with_error};
use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use super::Numbers;
use crate::lab::extremes::arrays;
use crate::lab::real::{Real, difference, dot};
use crate::lab::{exact, protocol};

/// Centre and radius of a sphere, and rays towards it, as origins and directions.
pub struct View<F> {
    pub c: [F; 3],
    pub r: F,
    pub rays: Vec<[[F; 3]; 2]>,
}

/// The formula of the renderer, in either precision.
pub fn stable<F: Real>(c: &[F; 3], r: F, o: &[F; 3], d: &[F; 3]) -> Option<F> {
    let f = difference(o, c);
    stable_roots(&f, r, d, dot(&f, &f) - r * r)
}

/// The renderer's formula with `f · f - r²` in twice as many digits: near a huge
/// sphere this is the difference of two huge numbers (Ogita, Rump and Oishi, "Accurate Sum and Dot
/// Product", 2005).
fn compensated(c: &[f64; 3], r: f64, o: &[f64; 3], d: &[f64; 3]) -> Option<f64> {
    let (square, mut error) = product_with_error(r, r);
    let mut power = -square;
    error = -error;
    let mut f = [0.0; 3];
    for axis in 0..3 {
        let (high, low) = sum_with_error(o[axis], -c[axis]);
        let (square, lost) = product_with_error(high, high);
        let (sum, lost_too) = sum_with_error(power, square);
        error += lost + lost_too + 2.0 * high * low;
        power = sum;
        f[axis] = high;
    }
    stable_roots(&f, r, d, power + error)
}

/// The renderer's `d · d`, the `t` nearest to the centre, and its discriminant `r² - l · l`.
pub fn stable_terms<F: Real>(f: &[F; 3], r: F, d: &[F; 3]) -> [F; 3] {
    let a = dot(d, d);
    let middle = -dot(f, d) / a;
    let l: [F; 3] = std::array::from_fn(|axis| f[axis] + d[axis] * middle);
    [a, middle, r * r - dot(&l, &l)]
}

/// The least positive root, given `power` = `f · f - r²`.
fn stable_roots<F: Real>(f: &[F; 3], r: F, d: &[F; 3], power: F) -> Option<F> {
    let zero = F::from(0.0);
    let [a, middle, discriminant] = stable_terms(f, r, d);
    if discriminant < zero {
        return None;
    }
    let t1 = middle + (discriminant / a).sqrt().copysign(middle);
    let t0 = power / (a * t1);
    let (near, far) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
    [near, far].into_iter().find(|t| *t > zero)
}

/// A ray with this direction, brought to length 1, in either precision.
fn rounded<F: Real>(o: Vector3, d: Vector3) -> [[F; 3]; 2] {
    let ray = Ray::derived(Point3::ORIGIN + o, d * (1.0 / d.magnitude()));
    arrays(&ray).map(|triple| triple.map(F::rounded))
}

/// The unit sphere at the origin and rays from all around, at a distance, that
/// aim at a disc of 1.2 radii.
pub fn view_from<F: Real>(distance: f64, rays: usize) -> View<F> {
    let ray = |n| {
        let mut numbers = Numbers::new(11, n);
        let [back, aside] = numbers.perpendicular();
        let o = back * distance;
        rounded(o, aside * (1.2 * numbers.between(0.0, 1.0).sqrt()) - o)
    };
    View {
        c: [F::from(0.0); 3],
        r: F::from(1.0),
        rays: (0..rays).map(ray).collect(),
    }
}

/// A sphere of this radius whose top is the origin, as a ground, and rays from
/// one to two units above it, three of four of them downwards.
fn view_of_ground<F: Real>(radius: f64, rays: usize) -> View<F> {
    let ray = |n| {
        let mut numbers = Numbers::new(12, n);
        let o = numbers.triple(-1.0, 1.0);
        let o = Vector3::new(o.x(), numbers.between(1.0, 2.0), o.z());
        let down = if numbers.below(4) == 0 { 1.0 } else { -1.0 };
        let mut slope = || numbers.between(-0.5, 0.5);
        rounded(o, Vector3::new(slope(), down, slope()))
    };
    View {
        c: [0.0, -radius, 0.0].map(F::rounded),
        r: F::rounded(radius),
        rays: (0..rays).map(ray).collect(),
    }
}

/// The errors of `t` for all rays that hit the sphere, except near its rim, where
/// rounding of the ray itself has an effect. A miss counts as 1.
fn errors<F: Real>(
    view: &View<F>,
    formula: impl Fn(&[F; 3], F, &[F; 3], &[F; 3]) -> Option<F>,
) -> Vec<f64> {
    let (c, r) = (view.c.map(Into::into), view.r.into());
    let error = |[o, d]: &[[F; 3]; 2]| {
        let exact = exact::sphere(&c, r, &o.map(Into::into), &d.map(Into::into));
        let [near, _] = exact.roots?;
        let counts = exact.distance < 0.9 * r && near.value() > 0.0;
        let found = formula(&view.c, view.r, o, d);
        counts.then(|| found.map_or(1.0, |t| near.error_of(t.into())))
    };
    view.rays.iter().filter_map(error).collect()
}

/// Parameters and their views, for one precision.
type Views<F> = Vec<(f64, Rc<View<F>>)>;

fn views<F: Real>(view: fn(f64, usize) -> View<F>, count: i32, effort: Effort) -> Views<F> {
    let rays = effort.choose(4096, 65_536);
    let knobs = (1..=count).map(|power| libm::pow(8.0, power.into()));
    let views = knobs.map(|knob| (knob, Rc::new(view(knob, rays))));
    views.collect()
}

fn curve<F: Real + 'static>(
    method: &'static str,
    views: &Views<F>,
    slope: f64,
    between: (f64, f64),
    formula: impl Fn(&[F; 3], F, &[F; 3], &[F; 3]) -> Option<F> + Copy + 'static,
) -> Curve<'static> {
    let points = views.iter().map(|(knob, view)| {
        let shot = Rc::clone(view);
        let run = move || {
            let View { c, r, rays } = &*shot;
            let hits = rays.iter().filter_map(|[o, d]| formula(c, *r, o, d));
            hits.fold(F::from(0.0), Add::add).into()
        };
        Point::new(*knob, view.rays.len() as f64, errors(view, formula), run)
    });
    Curve::new(method, points).with_slope(slope, between)
}

/// Remark on the formula that is more exact than needed.
const TOO_EXACT: &str = "not in the renderer: it pays only near a sphere so huge that a plane is \
     cheaper, and from afar its digits are lost in t itself; without the processor's fused \
     multiply-add, as here by default, it is dearer than it must be";

#[rustfmt::skip]
fn far_curves(effort: Effort) -> Vec<Curve<'static>> {
    let doubles = views::<f64>(view_from, 10, effort);
    let singles = views::<f32>(view_from, 3, effort);
    let (until_lost, everywhere, single) = ((8.0, 2e7), (8.0, 2e9), (8.0, 512.0));
    vec![
        curve("protocol", &doubles, 2.0, until_lost, protocol::sphere),
        curve("stable (ours)", &doubles, 1.0, everywhere, stable),
        curve("compensated", &doubles, 1.0, everywhere, compensated).with_remark(TOO_EXACT),
        curve("protocol (single)", &singles, 2.0, single, protocol::sphere),
        curve("stable (single)", &singles, 1.0, single, stable),
    ]
}

#[rustfmt::skip]
fn near_curves(effort: Effort) -> Vec<Curve<'static>> {
    let doubles = views::<f64>(view_of_ground, 10, effort);
    let singles = views::<f32>(view_of_ground, 6, effort);
    let (single, double) = ((64.0, 3e5), (64.0, 2e9));
    vec![
        curve("protocol", &doubles, 1.0, double, protocol::sphere),
        curve("stable (ours)", &doubles, 1.0, double, stable),
        curve("compensated", &doubles, 0.0, double, compensated).with_remark(TOO_EXACT),
        curve("protocol (single)", &singles, 1.0, single, protocol::sphere),
        curve("stable (single)", &singles, 1.0, single, stable),
    ]
}

pub fn far() -> Experiment<'static> {
    Experiment {
        name: "sphere-far",
        about: "How far away may a sphere of radius 1 be?",
        knob: "distance (radii)",
        work: "rays",
        error: "rms error of t",
        unit: Unit::Other("radii"),
        exact: "against 30 digits; a miss counts as 1; seven of ten rays hit",
        seeds: &[11],
        against: Axis::Knob,
        curves: Box::new(far_curves),
    }
}

pub fn near() -> Experiment<'static> {
    Experiment {
        name: "sphere-near",
        about: "How large may a sphere be whose surface is near the eye?",
        knob: "radius (eye heights)",
        unit: Unit::Other("heights of the eye"),
        exact: "against 30 digits; three of four rays hit",
        seeds: &[12],
        curves: Box::new(near_curves),
        ..far()
    }
}
