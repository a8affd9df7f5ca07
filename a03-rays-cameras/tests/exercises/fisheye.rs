//! Places whose angle from the gaze is a share of the opening, in directions whose
//! sine and cosine are fractions.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Basis, Camera, Ray, render};
use common::{Color, Error, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

/// Some roundings of coordinates up to 1.
const BOUND: Bound = Bound::Absolute(1e-14);

/// At (1, 2, 3), held askew.
fn basis(gaze: [f64; 3], up: [f64; 3]) -> Result<Basis, Error> {
    let [gaze, up] = [gaze, up].map(|xyz| Vector3::from_glam(xyz.into()));
    Ok(Basis::new(Point3::new(1.0, 2.0, 3.0), gaze, up)?)
}

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Basis, f64) -> C) {
    let mut random = Random::new(4);
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
                let mut aimed = |r: f64, (x, y): (f64, f64)| {
                    let (right, up) = (r * x, r * y);
                    let h = f64::from(height);
                    let column = (f64::from(width) - 1.0) / 2.0 + right * h;
                    let row = (h - 1.0) / 2.0 + up * h;
                    let ray = camera.ray_for(size, column, row);
                    let (sin, cos) = libm::sincos(r * angle);
                    let exact = (basis.u * x + basis.v * y) * sin - basis.w * cos;
                    let what = format!(
                        "direction at ({right:.3}, {up:.3}) heights from the middle of {size}, opening {angle:.3}, gaze {gaze:?}"
                    );
                    let [exact, got] = [exact, ray.direction()].map(|d| d.to_glam().to_array());
                    check.expect(what, exact, BOUND, got);
                    let [exact, got] = [basis.e, ray.origin()].map(|p| p.to_glam().to_array());
                    check.expect("origin of the ray", exact, Bound::Equal, got);
                };
                aimed(0.0, (1.0, 0.0));
                for way in [
                    (1.0, 0.0),
                    (0.0, 1.0),
                    (0.0, -1.0),
                    (-0.6, 0.8),
                    (0.28, -0.96),
                ] {
                    aimed(0.5, way);
                    aimed(random.between(0.01, 0.5), way);
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
