//! Parallel cameras anywhere, compared with the lesson's.

use crate::camera::{Own, compare};
use crate::prelude::*;

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Point3, Vector3, Vector3, f64) -> Made<C>) {
    compare(
        check,
        "eye, gaze and up {}, s = {}",
        ([[0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]], 1.0),
        |r| ([(); 3].map(|()| r.triple(5.0)), r.between(0.5, 9.0)),
        |([e, g, t], s)| OrthographicCamera::new(point(e), vector(g), vector(t), s),
        |([e, g, t], s)| new(point(e), vector(g), vector(t), s),
    );
    check.scene(&a04_intersections::stage(), "scene-6", |settings| {
        let world = scene_6()?.world;
        let world = Box::new(world).recorded(false);
        let [g, up] = [Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0)];
        let camera = new(Point3::ORIGIN, g, up, 3.0)?;
        paint(&camera, &|ray: &Ray| world.radiance(ray, 1), settings)
    });
}

/// A camera whose rays begin at a place of the picture, in its heights.
fn variant(c: &mut Check, place: fn([f64; 2], [f64; 2]) -> [f64; 2]) {
    check(c, move |e, g, t, s| {
        let Basis { e, u, v, w } = Basis::new(e, g, t)?;
        Ok(Own(move |size: [f64; 2], [x, y]: [f64; 2]| {
            let [right, up] = place(size, [x, y]);
            Ray::derived(e + u * (s * right) + v * (s * up), -w)
        }))
    });
}

variants! { variant:
    yours => OrthographicCamera::new;
    right "from the lower left pixel on" => |[w, h], [x, y]| {
        [w / h * (x / (w - 1.0) - 0.5), y / (h - 1.0) - 0.5]
    };
    wrong "a wide picture shows more to the sides" => |[w, h], [x, y]| {
        [x / (w - 1.0) - 0.5, y / (h - 1.0) - 0.5]
    };
}
