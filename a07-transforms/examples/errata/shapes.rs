//! A box that loses its faces, and a sphere that is far away.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View};
use a04_intersections::protocol::{self, Compared};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Sphere};
use common::{Color, Error, Scene};

use super::{beside, shade, traced};

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const LBF: Point3 = Point3::new(0.1, 0.2, 0.3);
const RUN: Point3 = Point3::new(0.7, 1.1, 0.9);

pub fn box_faces() -> Scene {
    let about = "a point on a face, all three coordinates of it compared; and slabs";
    let wrong = |_: &_| cube(|ray| protocol::axis_aligned_box(LBF, RUN, ray, Compared::Three));
    beside("box-faces", about, wrong, |_| {
        let aab = AxisAlignedBox::new(LBF, RUN)?;
        cube(move |ray| Some(aab.hit(ray, Interval::AHEAD)?.t))
    })
}

/// The box, darker where it is farther away.
fn cube(t: impl Fn(&Ray) -> Option<f64> + Send + Sync + 'static) -> Result<View, Error> {
    let eye = Point3::new(5.7, 5.2, 7.3);
    let gaze = Point3::new(0.4, 0.65, 0.6) - eye;
    let camera = PerspectiveCamera::new(eye, gaze, UP, 0.15)?;
    Ok(traced(camera, move |ray| {
        t(ray).map_or(Color::BLACK, |t| {
            Color::new(0.3, 0.5, 1.0) * ((10.8 - t) / 2.2).clamp(0.0, 1.0)
        })
    }))
}

const LIGHT: Vector3 = Vector3::new(0.48, 0.6, 0.64);

pub fn far_sphere() -> Scene {
    let about = "radius 1 from 37 million away: b² - 4ac, and the distance of the ray";
    let wrong = |_: &_| {
        ball(|ray| {
            let (o, d) = (ray.origin().to_glam(), ray.direction().to_glam());
            let t = protocol::sphere(&[0.0; 3], 1.0, &o.to_array(), &d.to_array())?;
            let normal = (ray.at(t) - Point3::ORIGIN).normalized()?;
            Some(Hit::new(t, normal.as_normal()))
        })
    };
    beside("far-sphere", about, wrong, |_| {
        let sphere = Sphere::new(Point3::ORIGIN, 1.0)?;
        ball(move |ray| sphere.hit(ray, Interval::AHEAD))
    })
}

fn ball(hit: impl Fn(&Ray) -> Option<Hit> + Send + Sync + 'static) -> Result<View, Error> {
    let eye = Point3::new(1e7, 2e7, 3e7);
    let camera = PerspectiveCamera::new(eye, Point3::ORIGIN - eye, UP, 2.4 / 3.74e7)?;
    Ok(traced(camera, move |ray| {
        hit(ray).map_or(Color::BLACK, |hit| shade(Color::RED, hit.normal.dot(LIGHT)))
    }))
}
