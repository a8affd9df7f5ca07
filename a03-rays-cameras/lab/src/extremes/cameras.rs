//! Cameras: fields of view, brackets and axes from `cases.toml`, and counts of many rays.

use std::f64::consts::FRAC_PI_2;

use a02_math::arrays::{array, vector};
use a02_math::{Direction, Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{Case, Row, greatest, tried};

use super::{AHEAD, UP};
use crate::protocol;
use a03_rays_cameras::{
    Basis, Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, PixelRandom, Ray,
};

/// What a row asks, by our code and by the protocol's formula.
pub fn computed(row: &Row) -> Case {
    let [width, height] = [0, 1].map(|index| row.number(index));
    let (x, y) = (row.number(2), row.number(3));
    match row.asks.as_str() {
        // The protocol takes another angle for the full one.
        "perspective" => {
            let ours = perspective([width, height], [x, y], row.number(4));
            let theirs = protocol::perspective_direction([width, height], x, y, row.number(5));
            Case::of(ours, array(theirs))
        }
        "bracket of the code" => bracket(row, protocol::bracket_of_the_code),
        "bracket of the formula" => bracket(row, protocol::bracket_of_the_formula),
        "bracket of the course" => bracket(row, protocol::bracket_of_the_course),
        "u" => u(row),
        "pinhole" => {
            let theirs = protocol::pinhole_direction([width, height], x, y, FRAC_PI_2);
            Case::of(pinhole([width, height], [x, y]), array(theirs))
        }
        // Ours is the direction through the middle of a pixel, where the protocol has its corner.
        "pinhole, middle" => {
            let theirs = protocol::pinhole_direction([width, height], x, y, FRAC_PI_2);
            Case::of(pinhole([width, height], [x + 0.5, y + 0.5]), array(theirs))
        }
        "pinhole, whole sizes" => {
            let size = [width, height].map(|x| x as u32);
            let theirs = protocol::pinhole_direction_of_whole_sizes(size, x, y, FRAC_PI_2);
            Case::of(pinhole([width, height], [x, y]), array(theirs))
        }
        "almost parallel" => Case::of_ours(defect_of_almost_parallel()),
        "far point" => far_point(),
        _ => Row::unknown(),
    }
}

fn size([width, height]: [f64; 2]) -> Result<Size, ArgumentError> {
    Size::new(width as u32, height as u32)
}

/// The direction through the middle of a pixel, counted from below, of the perspective camera at the origin with
/// this full angle.
fn perspective(of: [f64; 2], [x, y]: [f64; 2], angle: f64) -> Result<[f64; 3], ArgumentError> {
    let camera = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle)?;
    Ok(array(camera.ray_for(size(of)?, x, y).direction()))
}

/// The direction of the pinhole camera through a position in the picture, counted from its upper
/// left corner.
fn pinhole(of: [f64; 2], [x, y]: [f64; 2]) -> Result<[f64; 3], ArgumentError> {
    let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
    Ok(array(camera.generate_ray(size(of)?, x, y).direction()))
}

/// The offset of the origin of a column's ray in the orthographic camera, in widths of
/// the picture.
fn bracket(row: &Row, formula: fn(f64, f64) -> f64) -> Case {
    let (column, width) = (row.number(0), row.number(1));
    let ours = tried(|| {
        let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?;
        let ray = camera.ray_for(size([width, width])?, column, 0.0);
        Ok(ray.origin().x())
    });
    Case::of(ours, formula(column, width))
}

/// The axis u of a camera. The protocol does not check gaze and up vector.
fn u(row: &Row) -> Case {
    let [gaze, up] = [0, 3].map(|index| vector(row.triple(index)));
    let ours = Basis::new(Point3::ORIGIN, gaze, up).map(|basis| array(basis.u));
    let [theirs, _, _] = protocol::axes(gaze, up);
    Case::of(ours, array(theirs))
}

/// Greatest deviation of the axes from being perpendicular and of length 1.
fn defect(Basis { u, v, w, .. }: Basis) -> f64 {
    let cosines = [u.dot(v), v.dot(w), w.dot(u)];
    let lengths = [u, v, w].map(|axis| axis.dot(axis) - 1.0);
    greatest(cosines.into_iter().chain(lengths))
}

/// The greatest defect of the axes for random gazes and an up vector 2.6e-12 beside them.
fn defect_of_almost_parallel() -> f64 {
    let mut defects = Vec::new();
    for n in 0..10_000 {
        let random = PixelRandom::new(31, n, 0);
        let [gaze, other] = [0, 3].map(|first| {
            let [x, y, z] = [0, 1, 2].map(|i| random.uniform(first + i) - 0.5);
            Vector3::new(x, y, z)
        });
        if let Some(basis) = almost_parallel(gaze, other) {
            defects.push(defect(basis));
        }
    }
    greatest(defects)
}

fn almost_parallel(gaze: Vector3, other: Vector3) -> Option<Basis> {
    let gaze = gaze.normalized()?;
    let across = gaze.cross(other).normalized()?;
    Basis::new(Point3::ORIGIN, gaze, gaze + across * 2.6e-12).ok()
}

/// The point at t = 50 of a ray to the sky.
fn far_point() -> Case {
    let far = Vector3::new(0.0, 0.0, -2.0);
    let ours = tried(|| {
        let ray = Ray::new(Point3::ORIGIN, far)?;
        Ok(ray.bounded(f64::INFINITY)?.at(50.0).map(array))
    });
    let theirs = protocol::point_at(Point3::ORIGIN, far, 30.0, 50.0);
    Case::of(ours, theirs.map(array))
}
