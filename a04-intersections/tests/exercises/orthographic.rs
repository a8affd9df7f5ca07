//! Parallel cameras anywhere, compared with the lesson's.

use crate::camera::compare;
use crate::prelude::*;

pub fn check<C: Camera>(
    check: &mut Check,
    new: impl Fn(Point3, Vector3, Vector3, f64) -> Result<C, ArgumentError>,
) {
    compare(
        check,
        "eye {}, gaze {}, up {}, s = {}",
        ([0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], 1.0),
        |r| {
            (
                r.triple(9.0),
                r.triple(3.0),
                r.triple(3.0),
                r.between(0.5, 9.0),
            )
        },
        |(e, g, t, s)| OrthographicCamera::new(point(e), vector(g), vector(t), s),
        |(e, g, t, s)| new(point(e), vector(g), vector(t), s),
    );
    check.scene(&a04_intersections::stage(), "scene-6", |settings| {
        let (_, world) = scene_6()?;
        let [g, up] = [Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0)];
        let camera = new(Point3::ORIGIN, g, up, 3.0)?;
        render(&camera, |ray: &Ray| world.color_for(ray), settings, &())
    });
}

/// A camera whose rays follow from its axes, the scale, and each of width and height with a
/// place along it.
struct Own(Basis, f64, Rays);

type Rays = fn(Basis, f64, [f64; 2], [f64; 2]) -> Ray;

impl Camera for Own {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [w, h] = [size.width(), size.height()].map(f64::from);
        (self.2)(self.0, self.1, [w, x], [h, y])
    }
}

fn own(c: &mut Check, rays: Rays) {
    check(c, |e, g, t, s| Ok(Own(Basis::new(e, g, t)?, s, rays)));
}

fn ray(basis: Basis, right: f64, up: f64) -> Ray {
    Ray::derived(basis.e + basis.u * right + basis.v * up, -basis.w)
}

/// Offset of a pixel from the middle, as a fraction of the whole.
fn offset([n, p]: [f64; 2]) -> f64 {
    p / (n - 1.0) - 0.5
}

pub const VARIANTS: &[Variant] = &[
    right("steps of a pixel from the lower left", |c| {
        own(c, |basis, s, [w, x], [h, y]| {
            let [right, up] = [s * w / h / (w - 1.0), s / (h - 1.0)];
            let corner = ray(basis, -right * (w - 1.0) / 2.0, -s / 2.0).origin();
            Ray::derived(
                corner + basis.u * (x * right) + basis.v * (y * up),
                -basis.w,
            )
        });
    }),
    wrong(
        "a picture that is wider than high shows more to the sides",
        |c| {
            own(c, |basis, s, x, y| ray(basis, s * offset(x), s * offset(y)));
        },
    ),
    wrong("the origins differ, not the directions", |c| {
        own(c, |basis, s, x, y| {
            let through = ray(basis, s * x[0] / y[0] * offset(x), s * offset(y)).origin();
            Ray::derived(basis.e, through - basis.e - basis.w)
        });
    }),
];
