//! Errors over many rays, compared with 30 digits.

use a02_math::{Direction, Normal3, Point3};
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Id, Protocol, greatest};

use super::EPSILON;
use crate::lab::experiments::needle::{Needle, cramer, error, needles, ours};
use crate::lab::experiments::sphere_distance::{FROM_AFAR, Shot, shots, stable};
use crate::lab::real::Real;
use crate::lab::support::{Numbers, arrays, first, raw_ray};
use crate::lab::{exact, protocol};
use crate::{Plane, Sphere};

/// Number of rays with a wrong decision between hit and miss of a unit sphere,
/// among rays that pass its rim at more than four rounding errors of the distance.
fn wrong<F: Real>(distance: f64, rays: usize, is_hit: impl Fn(&[F; 3], &[F; 3]) -> bool) -> usize {
    let margin = 4.0 * F::epsilon().into() * distance;
    let is_wrong = |Shot { o, d, .. }: &&Shot<F>| {
        let [origin, direction] = [o, d].map(|v| v.map(Into::into));
        let exact = exact::sphere(&[0.0; 3], 1.0, &origin, &direction);
        let is_clear = (exact.distance - 1.0).abs() > margin;
        is_clear && is_hit(o, d) != exact.roots.is_some()
    };
    let shots = shots(FROM_AFAR, distance, rays);
    shots.iter().filter(is_wrong).count()
}

/// Whether the protocol finds a hit of the unit sphere.
fn theirs<F: Real>(o: &[F; 3], d: &[F; 3]) -> bool {
    protocol::sphere(&[F::zero(); 3], F::one(), o, d).is_some()
}

/// The greatest error of a plane's `t`, relative to the theoretical bound: rounding
/// errors of the lengths over the cosine.
fn plane(id: Id, anchor: f64, rays: usize) -> Case {
    let errors = |of: &dyn Fn(Point3, Normal3, &Ray) -> Option<f64>| {
        greatest((0..rays).filter_map(|n| {
            let mut numbers = Numbers::new(61, n);
            let [normal, within] = numbers.perpendicular();
            let a = Point3::ORIGIN + within * anchor;
            let eye = Point3::ORIGIN + normal * numbers.between(1.0, 5.0);
            let ray = Ray::derived(eye, numbers.direction());
            let t = of(a, normal.as_normal(), &ray)?;
            let [a, n] = [a.to_glam(), normal.to_glam()].map(|v| v.to_array());
            let [o, d] = arrays(&ray);
            let error = exact::plane(&a, &n, &o, &d).error_of(t);
            Some(error * ray.direction().dot(normal) / (EPSILON * (anchor + t)))
        }))
    };
    let ours = errors(&|a, n, ray| first(&Plane::new(a, n).ok()?, ray));
    let what = format!("{rays} rays at a plane whose point is {anchor:e} away: error in roundings");
    Case::new(id, what, 0.0, Absolute(2.0), ours).protocol(Holds, errors(&protocol::plane))
}

/// The median of the relative errors of `t`.
fn needle(id: Id, aspect: f64, rays: usize, bound: f64, says: Protocol) -> Case {
    let needles = needles(aspect, rays);
    let median = |formula: fn(&Needle) -> Option<f64>| {
        let errors = needles
            .iter()
            .filter_map(|needle| error(needle, formula(needle)));
        let mut errors: Vec<_> = errors.map(f64::abs).collect();
        errors.sort_by(f64::total_cmp);
        errors[errors.len() / 2]
    };
    let what = format!("{rays} rays at triangles of aspect {aspect:e}: median relative error of t");
    Case::new(id, what, 0.0, Absolute(bound), median(ours)).protocol(says, median(cramer))
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let (rays, needles) = (effort.choose(1000, 3000), effort.choose(1024, 4096));
    let [double, single] = [effort.choose(1000, 4000), effort.choose(2000, 20_000)];
    let of_doubles = Sphere::new(Point3::ORIGIN, 1.0).map(|sphere| {
        wrong::<f64>(1e8, double, |o, d| first(&sphere, &raw_ray((*o, *d))).is_some())
    });
    let of_singles = wrong::<f32>(1e3, single, |o, d| stable(&[0.0; 3], 1.0, o, d).is_some());
    vec![
        Case::new("S10", format!("{double} rays at and past a sphere 1e8 radii away: wrong hits and misses"),
            0.0, Equal, of_doubles).protocol(Fails, wrong::<f64>(1e8, double, theirs)),
        Case::new("S11", format!("in single precision, {single} rays, 1e3 radii away: wrong hits and misses"),
            0.0, Equal, of_singles).protocol(Fails, wrong::<f32>(1e3, single, theirs)),
        plane("S16a", 1.0, rays),
        plane("S16b", 1e6, rays),
        plane("S16c", 1e12, rays),
        needle("S17a", 1.0, needles, 1e-15, Holds),
        needle("S17b", 1e4, needles, 1e-14, Fails),
        needle("S17c", 1e8, needles, 1e-10, Fails),
    ]
}
