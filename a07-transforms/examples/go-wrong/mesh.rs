//! Cracks between triangles. Rays that aim nowhere hardly ever meet an edge, so
//! the corners of this wall lie exactly behind the middles of pixels.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, PixelRandom, Ray, render};
use a04_intersections::{Geometry, Interval, Triangle, protocol};
use common::{Color, Error, Image, Progress, Scene, Settings, Size};

pub fn cracks() -> Scene {
    let about = "a wall of triangles: by Cramer's rule, and by the test without gaps";
    let theirs: Test = |corners| Box::new(move |ray| protocol::triangle(&corners, ray).is_some());
    let ours: Test = |[a, b, c]| match Triangle::new(a, b, c) {
        Ok(triangle) => Box::new(move |ray| triangle.hit(ray, Interval::AHEAD).is_some()),
        Err(_) => Box::new(|_| false),
    };
    let panels = [theirs, ours].map(|test| {
        move |settings: &Settings, progress: &dyn Progress| wall(test, settings, progress)
    });
    Scene::side_by_side("cracks", about, panels, super::PANEL)
}

/// Whether rays meet a triangle.
type Test = fn([Point3; 3]) -> Box<dyn Fn(&Ray) -> bool + Sync>;

/// Pixels from corner to corner.
const STEP: u32 = 20;

/// A wall before a light: light that shines through is white.
fn wall(test: Test, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
    let (eye, gaze) = (Point3::new(0.1, 0.2, 0.3), Vector3::new(1.0, -0.3, -2.0));
    let camera = PerspectiveCamera::new(eye, gaze, Vector3::new(0.0, 1.0, 0.0), 0.8)?;
    let triangles = triangles(&camera, settings.size);
    let triangles: Vec<_> = triangles
        .into_iter()
        .map(|corners| (corners, test(corners)))
        .collect();
    let color = |ray: &Ray| {
        let met = triangles.iter().find(|(_, is_met)| is_met(ray));
        met.map_or(Color::WHITE, |&([a, b, c], _)| {
            let normal = (b - a).cross(c - a).normalized();
            let cosine = normal.map_or(0.0, |n| n.dot(ray.direction()).abs());
            Color::new(0.2, 0.3, 0.5) * cosine
        })
    };
    render(&camera, color, settings, progress)
}

/// The triangles between corners at a fixed distance in pixels, and beyond the
/// border; each corner is 3 to 3.5 away.
fn triangles(camera: &PerspectiveCamera, size: Size) -> Vec<[Point3; 3]> {
    let [columns, rows] = [size.width(), size.height()].map(|side| side / STEP + 2);
    let corner = |column: u32, row: u32| {
        let place = |index: u32| f64::from(STEP) * (f64::from(index) - 0.5);
        let ray = camera.ray_for(size, place(column), place(row));
        let number = PixelRandom::new(4, row * columns + column, 0).uniform(0);
        ray.at(3.0 + 0.5 * number)
    };
    let cells = (1..rows).flat_map(|row| (1..columns).map(move |column| (column, row)));
    cells
        .flat_map(|(column, row)| {
            let (left, below) = (column - 1, row - 1);
            let [a, b] = [corner(left, below), corner(column, below)];
            let [c, d] = [corner(column, row), corner(left, row)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}
