//! Parallel cameras at any place, that look into any direction, with any scale.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Camera;
use a04_intersections::{Sphere, World};
use common::{ArgumentError, Color, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::aimed::{expect_scene, frame, point};

/// Some roundings of coordinates up to 100.
const BOUND: Bound = Bound::Absolute(1e-11);

pub fn check<C: Camera>(
    check: &mut Check,
    new: impl Fn(Point3, Vector3, Vector3, f64) -> Result<C, ArgumentError>,
) {
    let mut random = Random::new(40);
    for _ in 0..20 {
        let (e, [u, v, w], s) = (
            point(&mut random, 9.0),
            frame(&mut random),
            random.between(0.5, 9.0),
        );
        let Ok(camera) = new(e, -w, v, s) else {
            continue;
        };
        let (width, height) = (2 + random.below(90), 2 + random.below(90));
        let Ok(size) = Size::new(width, height) else {
            continue;
        };
        let [columns, rows] = [width, height].map(f64::from);
        let (right, up) = (random.between(-0.5, 0.5), random.between(-0.5, 0.5));
        for (place, right, up) in [
            ("through the middle", 0.0, 0.0),
            ("through the middle of the lowest row", 0.0, -0.5),
            ("through the middle of the highest row", 0.0, 0.5),
            ("through the middle of the last column", 0.5, 0.0),
            ("anywhere", right, up),
        ] {
            let (x, y) = ((right + 0.5) * (columns - 1.0), (up + 0.5) * (rows - 1.0));
            let exact = e + u * (right * s * columns / rows) + v * (up * s);
            let ray = camera.ray_for(size, x, y);
            let words = format!(
                "eye {}, gaze {:.3}, up {:.3}, s = {s}, picture of {size}, x = {x}, y = {y}",
                e.to_glam(),
                (-w).to_glam(),
                v.to_glam()
            );
            let [exact, got] = [exact, ray.origin()].map(|p| p.to_glam().to_array());
            check.expect(format!("the origin {place}; {words}"), exact, BOUND, got);
            let [exact, got] = [-w, ray.direction()].map(|d| d.to_glam().to_array());
            check.expect(format!("the direction; {words}"), exact, BOUND, got);
        }
    }
    expect_scene(check, "scene-6", || {
        let (g, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
        let world = World::new(Color::BLACK)?
            .with(Sphere::new(Point3::new(-1.0, 0.0, -3.0), 0.5)?, Color::RED)
            .with(Sphere::new(Point3::new(1.0, 0.0, -6.0), 0.5)?, Color::RED);
        Ok((Box::new(new(Point3::ORIGIN, g, up, 3.0)?), world))
    });
}
