//! Places whose angle from the gaze is a share of the opening.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Basis, Camera, Ray, render};
use common::{Color, Error, Size};
use measure::extremes::Bound;
use testing::exercise::Check;

/// Some roundings of coordinates up to 1.
const BOUND: Bound = Bound::Absolute(1e-14);

/// At (1, 2, 3), held askew.
fn basis(gaze: [f64; 3], up: [f64; 3]) -> Result<Basis, Error> {
    let [gaze, up] = [gaze, up].map(|xyz| Vector3::from_glam(xyz.into()));
    Ok(Basis::new(Point3::new(1.0, 2.0, 3.0), gaze, up)?)
}

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Basis, f64) -> C) {
    for (gaze, up) in [
        ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
        ([1.0, 2.0, -2.0], [2.0, 1.0, 2.0]),
    ] {
        let Ok(basis) = basis(gaze, up) else { continue };
        for (width, height) in [(101, 101), (161, 121), (60, 120)] {
            let Ok(size) = Size::new(width, height) else {
                continue;
            };
            for angle in [0.5, FRAC_PI_2, PI, 1.9 * PI] {
                let camera = new(basis, angle);
                // In heights of the picture, and where these lead.
                for (right, up) in [
                    (0.0, 0.0),
                    (0.5, 0.0),
                    (0.0, 0.5),
                    (0.0, -0.25),
                    (-0.3, 0.4),
                    (0.18, -0.24),
                ] {
                    let h = f64::from(height);
                    let x = (f64::from(width) - 1.0) / 2.0 + right * h;
                    let y = (h - 1.0) / 2.0 + up * h;
                    let ray = camera.ray_for(size, x, y);
                    let far: f64 = if right == 0.0 { up.abs() } else { right.abs() };
                    let r = match (right, up) {
                        (-0.3, _) => 0.5,
                        (0.18, _) => 0.3,
                        _ => far,
                    };
                    let (sin, cos) = libm::sincos(r * angle);
                    let share = if r == 0.0 { 0.0 } else { sin / r };
                    let exact = basis.u * (right * share) + basis.v * (up * share) - basis.w * cos;
                    let what = format!(
                        "direction at ({right}, {up}) heights from the middle of {size}, opening {angle}, gaze {gaze:?}"
                    );
                    let [exact, got] = [exact, ray.direction()].map(|d| d.to_glam().to_array());
                    check.expect(what, exact, BOUND, got);
                    let [exact, got] = [basis.e, ray.origin()].map(|p| p.to_glam().to_array());
                    check.expect("origin of the ray", exact, Bound::Equal, got);
                }
            }
        }
    }
    // A globe of meridians and parallels, seen from inside.
    check.picture(|settings| {
        let camera = new(basis([0.0, 0.3, -1.0], [0.0, 1.0, 0.0])?, PI);
        let paint = |ray: &Ray| {
            let d = ray.direction();
            let up = libm::atan2(d.y(), (d.x() * d.x() + d.z() * d.z()).sqrt());
            let around = libm::atan2(d.x(), -d.z());
            let fields = (up / FRAC_PI_6).floor() + (around / FRAC_PI_6).floor();
            let light = 0.4 + 0.6 * fields.rem_euclid(2.0);
            if d.y() < 0.0 {
                Color::new(0.3, 0.8, 0.3) * light
            } else {
                Color::new(0.4, 0.6, 1.0) * light
            }
        };
        render(&camera, paint, settings, &())
    });
}
