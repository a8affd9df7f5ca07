//! Arbitrary numbers in every constructor, and single operations on the results.

use std::f64::consts::PI;

use a02_math::{Normal3, Vector3};
use a03_rays_cameras::{PinholeCamera, StripeRule, StripedSky};
use arbitrary::{Result, Unstructured};
use fuzz::values::{accepted, assert_unit, normal, number, point, size_and_ray, transform, vector};

pub fn check(u: &mut Unstructured) -> Result<()> {
    match u.int_in_range(0..=2)? {
        0 => vectors(vector(u)?, vector(u)?, normal(u)?),
        1 => cameras(u)?,
        _ => transforms(u)?,
    }
    Ok(())
}

fn vectors(a: Vector3, b: Vector3, n: Normal3) {
    let has_direction = a.to_glam().is_finite() && a != Vector3::default();
    assert_eq!(a.normalized().is_some(), has_direction, "{a:?}");
    assert_eq!(a.unit("a").is_ok(), has_direction, "{a:?}");
    if let Some(unit) = a.normalized() {
        assert_unit(unit);
    }
    if let Some(n) = n.normalized() {
        assert_unit(n.into());
        if let Some(unit) = a.normalized() {
            // Tolerance: the normal's length and four roundings, of twice the length.
            let length = unit.reflected_on(n).magnitude();
            let tolerance = 16.0 * f64::EPSILON;
            assert!((length - 1.0).abs() <= tolerance, "{unit:?} {n:?}");
        }
    }
    let angle = a.angle(b);
    assert!((0.0..=PI).contains(&angle), "{angle}: {a:?} {b:?}");
}

fn cameras(u: &mut Unstructured) -> Result<()> {
    let Some(pinhole) = accepted(PinholeCamera::new(point(u)?, number(u)?)) else {
        return Ok(());
    };
    let (size, ray) = size_and_ray(u, &pinhole)?;
    let (bound, t, stripes) = (number(u)?, number(u)?, u.arbitrary()?);
    if let Some(part) = accepted(ray.bounded(bound)) {
        let is_on_it = 0.0 <= t && t <= bound;
        assert_eq!(part.at(t).is_some(), is_on_it, "{part:?} {t}");
    }
    let sky = StripedSky::new(&pinhole, size, stripes, StripeRule::Direction);
    if let Some(sky) = accepted(sky) {
        assert!(sky.stripe(&ray) < stripes, "{sky:?} {ray:?}");
    }
    Ok(())
}

fn transforms(u: &mut Unstructured) -> Result<()> {
    let (transform, normal) = (transform(u)?, normal(u)?);
    for matrix in [transform.matrix(), transform.inverse()] {
        assert!(matrix.is_within(1e150), "{transform:?}");
    }
    if let Some(normal) = transform.normal_from_object(normal) {
        assert_unit(normal.into());
    }
    Ok(())
}
