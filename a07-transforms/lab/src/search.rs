//! `search`: the worst inputs of the disc: see the laboratory of stage 4.

use a02_lab::exact::DoubleDouble;
use a02_math::Normal3;
use a02_math::arrays::{array, point, vector};
use a03_lab::quantity::{Quantity, unit};
use a03_rays_cameras::Ray;
use a04_intersections::Geometry;
use a04_lab::line::Line;
use a04_lab::search::search_among;
use a04_lab::subject::{ExactHit, Subject, triple, unit_normal};
use a04_lab::support::{Triple, numbers};
use a04_lab::{condition, exact};
use common::Error;

use crate::certified::decide;
use crate::protocol;
use a07_transforms::{Disc, Transform};

/// The shape of this stage.
pub static SUBJECTS: [Subject; 1] = [DISC];

/// Its centre, its normal and its radius.
pub const DISC: Subject = Subject {
    name: "disc",
    written: "Disc::new(Point3::new(#, #, #), Normal3::new(#, #, #), #)",
    make,
    aim,
    through,
    decide,
    exact,
    protocol,
};

fn disc(x: &[f64]) -> Option<Disc> {
    let normal = Normal3::new(x[3], x[4], x[5]);
    Disc::new(point(triple(x)), normal, x[6]).ok()
}

fn make(x: &[f64]) -> Option<Box<dyn Geometry>> {
    Some(Box::new(disc(x)?))
}

/// Across the normal, up to a radius from the centre.
fn aim(x: &[f64], aim: Triple) -> Triple {
    let normal = vector(triple(&x[3..]));
    let across = normal.cross(vector(aim)).normalized().unwrap_or_default();
    array(point(triple(x)) + across * (x[6] * aim[0]))
}

/// The radius is the distance.
fn through(x: &mut [f64], place: Triple) {
    x[6] = (point(place) - point(triple(x))).magnitude();
}

fn exact(x: &[f64], line: &Line) -> Option<ExactHit> {
    let center = triple(x);
    // The lesson's rounded normal is the given one.
    let normal = numbers(&disc(x)?, "normal");
    let t = exact::plane(&center, &normal, line);
    let condition = condition::of_plane(&center, normal, line, t.value());
    Some(ExactHit { t, condition })
}

fn protocol(x: &[f64], ray: &Ray) -> Option<f64> {
    protocol::disc(point(triple(x)), unit_normal(x), x[6], ray)
}

/// The normal of an object under a scaling.
pub const TRANSFORM: Quantity = Quantity {
    name: "transform",
    written: "Transform::IDENTITY.scale(#, #, #).map(|scaled| scaled.normal_from_object(Normal3::new(#, #, #)))",
    exact: exact_normal,
    lesson: |x| {
        let scaled = Transform::IDENTITY.scale(x[0], x[1], x[2]).ok()?;
        scaled
            .normal_from_object(Normal3::new(x[3], x[4], x[5]))
            .map(array)
    },
    protocol: |x| {
        let scaled = Transform::IDENTITY.scale(x[0], x[1], x[2]).ok()?;
        let normal = Normal3::new(x[3], x[4], x[5]);
        protocol::normal_as_vector(scaled.matrix(), normal).map(array)
    },
};

/// Each coordinate is divided by its factor.
fn exact_normal(x: &[DoubleDouble]) -> [DoubleDouble; 3] {
    unit([0, 1, 2].map(|i| x[i + 3] / x[i]))
}

/// The worst inputs of the protocol's formula and the lesson's, in words and as lines of Rust.
pub fn search(name: &str) -> Result<String, Error> {
    if name == TRANSFORM.name {
        return TRANSFORM.search(name);
    }
    if name == DISC.name {
        return search_among(&SUBJECTS, name);
    }
    Err(Error::Usage(format!(
        "no \"{name}\" is searched here, only {}, {}",
        DISC.name, TRANSFORM.name
    )))
}
