//! `search`: the worst inputs of the disc: see the laboratory of stage 4.

use a02_math::Normal3;
use a02_math::arrays::array;
use a04_lab::exact;
use a04_lab::search::search_among;
use a04_lab::subject::{Subject, triple, unit_normal};
use a04_lab::support::{numbers, plane_condition, point, vector};
use common::Error;

use super::certified::decide;
use super::protocol;
use a07_transforms::Disc;

/// The shape of this stage.
pub static SUBJECTS: [Subject; 1] = [DISC];

pub const DISC: Subject = Subject {
    name: "disc",
    written: "Disc::new(Point3::new(#, #, #), Normal3::new(#, #, #), #)",
    make: |x| Some(Box::new(disc(x)?)),
    aim: |x, aim| {
        // Across the normal, up to a radius from the centre.
        let across = vector([x[3], x[4], x[5]]).cross(vector([aim[0], aim[1], aim[2]]));
        let across = across.normalized().unwrap_or_default() * (x[6] * aim[0]);
        array(point(triple(x)) + across)
    },
    decide,
    exact: |x, line @ [o, d]| {
        let n = numbers(&disc(x)?, "normal");
        let t = exact::plane(&triple(x), &n, o, d);
        Some((t, plane_condition(&triple(x), n, line, t.value())))
    },
    protocol: |x, ray| protocol::disc(point(triple(x)), unit_normal(x), x[6], ray),
};

fn disc(x: &[f64]) -> Option<Disc> {
    Disc::new(point(triple(x)), Normal3::new(x[3], x[4], x[5]), x[6]).ok()
}

/// The worst inputs of the protocol's formula and the lesson's, in words and as lines of Rust.
pub fn search(name: &str) -> Result<String, Error> {
    search_among(&SUBJECTS, name)
}
