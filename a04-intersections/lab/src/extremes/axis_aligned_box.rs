//! Boxes hit along faces and edges, and with zeros in the direction.
//!
//! The protocol's row compares all coordinates of the computed point. Rows with
//! the same number and an s show naive slabs instead.

use measure::extremes::{Absolute, Bound, Case, Equal, Fails, Holds, Id, Outcome, Protocol, Ulps};
use measure::extremes::{Both, case};

use super::{MISS, REFUSED};
use crate::aimed_box::slabs;
use crate::protocol::{Compared, axis_aligned_box};
use crate::subject::BOX;
use crate::support::{Line, Triple, any_ray, first, point};
use a04_intersections::AxisAlignedBox;

/// Two opposite corners.
type Corners = (Triple, Triple);

const UNIT: Corners = ([0.0; 3], [1.0; 3]);

/// A row of the protocol, and with a second id one of naive slabs, which are wrong there.
fn rows(
    ids: &[Id],
    what: &str,
    (lbf, run): Corners,
    line: Line,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Vec<Case> {
    let (both, ray) = (BOX.met(&[lbf, run].concat(), line), any_ray(line));
    let (lbf, run, exact) = (point(lbf), point(run), exact.into());
    let naive = format!("{}: naive slabs", what.split(':').next().unwrap_or(what));
    let theirs = axis_aligned_box(lbf, run, &ray, Compared::Three);
    let rows = [(what, says, theirs), (&naive, Fails, slabs(lbf, run, &ray))];
    let row = |(id, (what, says, theirs)): (&Id, (&str, Protocol, Option<f64>))| {
        let outcomes = [both.outcomes[0], theirs.into()];
        case(id, what, Both { outcomes, ..both }, exact, bound, says)
    };
    ids.iter().zip(rows).map(row).collect()
}

/// The distance of the hit from the unit box at the left, by our formula and the protocol's.
fn beside(line: Line) -> [Outcome; 2] {
    let (ray, [lbf, run]) = (any_ray(line), [UNIT.0, UNIT.1].map(point));
    let ours = AxisAlignedBox::new(lbf, run).map(|unit| first(&unit, &ray));
    let theirs = Ok(axis_aligned_box(lbf, run, &ray, Compared::Three));
    [ours, theirs].map(|t| t.map(|t| t.map_or(0.0, |t| -ray.at(t).x())).into())
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let ahead = |x: f64, y: f64| ([x, y, 5.0], [0.0, 0.0, -1.0]);
    let left = ([0.0, 0.5, 5.0], [-0.0, 0.0, -1.0]);
    let corner = ([1.0, 0.5, 5.0], [-0.0, -0.0, -1.0]);
    let flat = ([0.0; 3], [1.0, 1.0, 0.0]);
    let lbf = [f64::NEG_INFINITY, f64::NEG_INFINITY, 0.0];
    let endless = (lbf, [f64::INFINITY, f64::INFINITY, 1.0]);
    let small = ([3.223, 0.241, 2.119], [3.225, 0.243, 2.121]);
    let at_its_edge = ([3.225, 0.243, 2.221], [0.0, 0.0, -1.0]);
    let barely = |x: f64| ([0.0, 0.5, 5.0], [x, 0.0, -1.0]);
    let nan = ([0.5, 0.5, 5.0], [f64::NAN, 0.0, -1.0]);
    let nowhere = ([0.5; 3], [0.0; 3]);
    let within = ([0.5, 0.5, 5e-4], [0.0, 0.0, -1.0]);
    let outwards = ([0.5, 0.5, 1.0], [0.0, 0.0, 1.0]);
    [
        rows(&["C01"], "through the middle", UNIT, ahead(0.5, 0.5), 4.0, Equal, Holds),
        rows(&["C02", "C02s"], "within the plane of the left face: 0 times infinity",
            UNIT, ahead(0.0, 0.5), 4.0, Equal, Holds),
        rows(&["C03", "C03s"], "within the plane of the right face", UNIT, ahead(1.0, 0.5), 4.0, Equal, Holds),
        rows(&["C04", "C04s"], "within the left face, with a direction of negative 0",
            UNIT, left, 4.0, Equal, Holds),
        rows(&["C05", "C05s"], "within the right face, with two negative zeros",
            UNIT, corner, 4.0, Equal, Holds),
        rows(&["C06", "C06s"], "along an edge", UNIT, ahead(0.0, 0.0), 4.0, Equal, Holds),
        rows(&["C07"], "one unit in the last place beside a face",
            UNIT, ahead(1.0_f64.next_up(), 0.5), MISS, Equal, Holds),
        rows(&["C08"], "a flat box, met obliquely",
            flat, ([0.3, 0.4, 5.0], [0.1, 0.05, -5.0]),
            5.001_249_843_789_051, Ulps(2.0), Holds),
        rows(&["C09"], "a flat box, along its sheet",
            flat, ([-2.0, 0.5, 0.0], [1.0, 0.0, 0.0]), 2.0, Equal, Holds),
        rows(&["C10"], "corners in the wrong order",
            ([1.0; 3], [0.0; 3]), ahead(0.5, 0.5), 4.0, Equal, Fails),
        rows(&["C11"], "inside, 5e-4 before a wall", UNIT, within, 5e-4, Equal, Fails),
        rows(&["C12", "C12s"], "on a face, outwards", UNIT, outwards, MISS, Equal, Holds),
        rows(&["C20", "C20s"], "from a point of a face, within the face",
            UNIT, ([0.5, 0.0, 0.25], [1.0, 0.0, 0.0]), 0.5, Equal, Holds),
        rows(&["C21"], "a corner, which is the ray's own origin",
            UNIT, ([1.0; 3], [1.0, -1.0, 0.0]), MISS, Equal, Holds),
        rows(&["C13"], "infinite corners", endless, ahead(0.5, 0.5), REFUSED, Equal, Fails),
        rows(&["C14", "C14s"], "within a face, but for a direction of 1e-310",
            UNIT, barely(1e-310), 4.0, Equal, Holds),
        // Both distances may be rounded by 3 u of their 4.
        vec![case("C15", "the same outwards by 4e-310: how far outside the hit is",
            beside(barely(-1e-310)), 0.0, Absolute(12.0 * f64::EPSILON), Holds)],
        rows(&["C16", "C16s"], "a direction of NaN", UNIT, nan, REFUSED, Equal, Fails),
        rows(&["C17", "C17s"], "no direction, inside", UNIT, nowhere, REFUSED, Equal, Fails),
        rows(&["C18", "C18s"], "along an edge of a small box elsewhere",
            small, at_its_edge, 0.100_000_000_000_000_09, Equal, Holds),
        // The computed 5 - 4.1 is not below 0.9.
        rows(&["C19"], "at the middle of a face, from 4.1 before it", ([0.1, 0.2, 0.3], [0.7, 1.1, 0.9]),
            ([0.4, 0.6, 5.0], [0.0, 0.0, -1.0]), 4.1, Equal, Fails),
    ].concat()
}
