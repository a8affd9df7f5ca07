//! Points in the plane of focus, which every ray through the lens meets.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{Basis, Camera, PerspectiveCamera, PixelRandom, Ray};
use common::{Color, Image};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, through: impl Fn(&Basis, f64, &Ray, (f64, f64)) -> Ray) {
    let mut random = Random::new(5);
    for (gaze, up) in [
        ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
        ([1.0, 2.0, -2.0], [2.0, 1.0, 2.0]),
    ] {
        let [gaze, up] = [gaze, up].map(|xyz: [f64; 3]| Vector3::from_glam(xyz.into()));
        let Ok(basis) = Basis::new(Point3::new(1.0, 2.0, 3.0), gaze, up) else {
            continue;
        };
        let mut expect = |focus: f64, (x, y): (f64, f64), lens: (f64, f64)| {
            expect_sharp(check, &through, &basis, focus, (x, y), lens);
        };
        for focus in [0.5, 4.0, 100.0] {
            for place in [(0.0, 0.0), (0.5, 0.0), (-0.75, 1.0), (2.0, -1.5)] {
                for lens in [(0.0, 0.0), (0.1, 0.0), (0.0, -0.2), (-0.3, 0.25)] {
                    expect(focus, place, lens);
                }
            }
        }
        for _ in 0..40 {
            let focus = random.between(0.1, 20.0);
            let mut pair =
                |limit: f64| (random.between(-limit, limit), random.between(-limit, limit));
            expect(focus, pair(2.0), pair(0.5));
        }
    }
    // Three walls of holes, one behind the other; the middle one is in focus.
    check.picture(|settings| {
        let [gaze, up] = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        let [gaze, up] = [gaze, up].map(|xyz| Vector3::from_glam(xyz.into()));
        let camera = PerspectiveCamera::new(Point3::ORIGIN, gaze, up, FRAC_PI_4)?;
        let (size, samples) = (settings.size, 64_u32);
        let bottom = f64::from(size.height() - 1);
        Image::from_fn(size, |x, y| {
            let ray = camera.ray_for(size, x.into(), bottom - f64::from(y));
            let random = PixelRandom::new(0, x, y);
            let mut sum = Color::BLACK;
            for n in (0..u64::from(samples)).map(|n| 2 * n) {
                let lens = [n, n + 1].map(|n| 0.3 * (random.uniform(n) - 0.5));
                sum += wall(&through(&camera.basis(), 5.0, &ray, lens.into()));
            }
            sum.map(|channel| channel / f64::from(samples))
        })
    });
}

/// Compares the ray that meets the place (`x`, `y`) times `focus` in the plane of focus.
fn expect_sharp(
    check: &mut Check,
    through: impl Fn(&Basis, f64, &Ray, (f64, f64)) -> Ray,
    basis: &Basis,
    focus: f64,
    (x, y): (f64, f64),
    (right, up): (f64, f64),
) {
    let Basis { e, u, v, w } = *basis;
    let sharp = e + (u * x + v * y - w) * focus;
    let Ok(ray) = Ray::new(e, sharp - e) else {
        return;
    };
    let got = through(basis, focus, &ray, (right, up));
    let place = sharp.to_glam();
    let name = format!(
        "lens ({right}, {up}), focus {focus}, sharp point {place:.3}, gaze {:.3}",
        (-w).to_glam()
    );
    // Some roundings of coordinates up to 300.
    let bound = Bound::Absolute(1e-12);
    let mut near = |what: &str, exact: Point3, got: Point3| {
        let [exact, got] = [exact, got].map(|p| p.to_glam().to_array());
        check.expect(format!("{what}, {name}"), exact, bound, got);
    };
    let origin = e + u * right + v * up;
    near("origin", origin, got.origin());
    near(
        "where the ray meets the sharp point",
        sharp,
        got.at((sharp - origin).magnitude()),
    );
    let length = got.direction().dot(got.direction()).sqrt();
    check.expect(
        format!("length of the direction, {name}"),
        1.0,
        Bound::Ulps(4.0),
        length,
    );
}

/// The colour of the nearest disc: a row of each, at three distances.
fn wall(ray: &Ray) -> Color {
    let (o, d) = (ray.origin(), ray.direction());
    for (z, middle, color) in [
        (-2.5, -0.7, Color::new(1.0, 0.3, 0.2)),
        (-5.0, 0.0, Color::new(0.3, 0.9, 0.3)),
        (-15.0, 4.0, Color::new(0.4, 0.5, 1.0)),
    ] {
        let p = ray.at((z - o.z()) / d.z());
        // As large in the picture at every distance.
        let (x, y) = (p.x() / z, (p.y() - middle) / z);
        let x = (x * 5.0 - (x * 5.0).round()) / 5.0;
        if x * x + y * y < 0.006 {
            return color;
        }
    }
    Color::gray(0.05)
}
