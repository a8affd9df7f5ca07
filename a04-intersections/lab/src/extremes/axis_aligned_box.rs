//! Boxes hit along faces and edges, and with zeros in the direction.
//!
//! The protocol's row compares all coordinates of the computed point. Rows with
//! the same number and an s show naive slabs instead.

use measure::extremes::{
    Absolute, Bound, Case, Equal, Fails, Holds, Id, Nothing, Number, Outcome, Protocol, Refused,
    Ulps,
};

use crate::aimed_box::slabs;
use crate::line::{Line, line};
use crate::protocol::{Compared, axis_aligned_box};
use crate::subject::BOX;
use crate::support::{Triple, first, point};
use a04_intersections::AxisAlignedBox;

/// Two opposite corners: left, bottom and far; right, upper and near.
#[derive(Clone, Copy)]
struct Corners {
    lbf: Triple,
    run: Triple,
}

const UNIT: Corners = Corners {
    lbf: [0.0; 3],
    run: [1.0; 3],
};

/// A box without depth.
const FLAT: Corners = Corners {
    lbf: [0.0; 3],
    run: [1.0, 1.0, 0.0],
};

/// The distance of a hit, by our formula and the protocol's, and perhaps by naive slabs.
struct Row {
    id: Id,
    /// The name of the row of naive slabs, which are wrong there.
    slabs: Option<Id>,
    what: &'static str,
    corners: Corners,
    line: Line,
    exact: Outcome,
    bound: Bound,
    protocol: Protocol,
}

impl Row {
    /// The unit box, which the protocol hits and misses as it should.
    fn of_unit(line: Line) -> Self {
        Self {
            id: "",
            slabs: None,
            what: "",
            corners: UNIT,
            line,
            exact: Nothing,
            bound: Equal,
            protocol: Holds,
        }
    }

    fn cases(self) -> Vec<Case> {
        let Corners { lbf, run } = self.corners;
        let (a, b, ray) = (point(lbf), point(run), self.line.any_ray());
        let theirs = axis_aligned_box(a, b, &ray, Compared::Three);
        let case = Case {
            id: self.id,
            what: self.what.into(),
            exact: self.exact,
            bound: self.bound,
            theirs: Some(theirs.into()),
            protocol: self.protocol,
            ..BOX.met(&[lbf, run].concat(), self.line)
        };
        let Some(id) = self.slabs else {
            return vec![case];
        };
        let subject = self.what.split(':').next().unwrap_or(self.what);
        let of_slabs = Case {
            id,
            what: format!("{subject}: naive slabs"),
            theirs: Some(slabs(a, b, &ray).into()),
            protocol: Fails,
            ..case.clone()
        };
        vec![case, of_slabs]
    }
}

/// The line along -z from above the unit box.
fn ahead(x: f64, y: f64) -> Line {
    line([x, y, 5.0], [0.0, 0.0, -1.0])
}

/// The line along -z within the plane of the left face, but for a slope to its side.
fn barely(slope: f64) -> Line {
    line([0.0, 0.5, 5.0], [slope, 0.0, -1.0])
}

pub fn cases() -> Vec<Case> {
    let mut cases = vec![beside_the_face()];
    let tables = [along_faces(), from_faces(), other_boxes(), odd_rays()];
    for row in tables.into_iter().flatten() {
        cases.extend(row.cases());
    }
    cases
}

/// Rays in the planes of faces and in edges, which belong to the box.
fn along_faces() -> Vec<Row> {
    vec![
        Row {
            id: "C01",
            what: "through the middle",
            exact: Number(4.0),
            ..Row::of_unit(ahead(0.5, 0.5))
        },
        Row {
            id: "C02",
            slabs: Some("C02s"),
            what: "within the plane of the left face: 0 times infinity",
            exact: Number(4.0),
            ..Row::of_unit(ahead(0.0, 0.5))
        },
        Row {
            id: "C03",
            slabs: Some("C03s"),
            what: "within the plane of the right face",
            exact: Number(4.0),
            ..Row::of_unit(ahead(1.0, 0.5))
        },
        Row {
            id: "C04",
            slabs: Some("C04s"),
            what: "within the left face, with a direction of negative 0",
            exact: Number(4.0),
            ..Row::of_unit(barely(-0.0))
        },
        Row {
            id: "C05",
            slabs: Some("C05s"),
            what: "within the right face, with two negative zeros",
            exact: Number(4.0),
            ..Row::of_unit(line([1.0, 0.5, 5.0], [-0.0, -0.0, -1.0]))
        },
        Row {
            id: "C06",
            slabs: Some("C06s"),
            what: "along an edge",
            exact: Number(4.0),
            ..Row::of_unit(ahead(0.0, 0.0))
        },
        Row {
            id: "C07",
            what: "one unit in the last place beside a face",
            exact: Nothing,
            ..Row::of_unit(ahead(1.0_f64.next_up(), 0.5))
        },
        Row {
            id: "C14",
            slabs: Some("C14s"),
            what: "within a face, but for a direction of 1e-310",
            exact: Number(4.0),
            ..Row::of_unit(barely(1e-310))
        },
    ]
}

/// Rays from the box itself, or from just before a wall inside it.
fn from_faces() -> Vec<Row> {
    vec![
        Row {
            id: "C11",
            what: "inside, 5e-4 before a wall",
            exact: Number(5e-4),
            protocol: Fails,
            ..Row::of_unit(line([0.5, 0.5, 5e-4], [0.0, 0.0, -1.0]))
        },
        Row {
            id: "C12",
            slabs: Some("C12s"),
            what: "on a face, outwards",
            exact: Nothing,
            ..Row::of_unit(line([0.5, 0.5, 1.0], [0.0, 0.0, 1.0]))
        },
        Row {
            id: "C20",
            slabs: Some("C20s"),
            what: "from a point of a face, within the face",
            exact: Number(0.5),
            ..Row::of_unit(line([0.5, 0.0, 0.25], [1.0, 0.0, 0.0]))
        },
        Row {
            id: "C21",
            what: "a corner, which is the ray's own origin",
            exact: Nothing,
            ..Row::of_unit(line([1.0; 3], [1.0, -1.0, 0.0]))
        },
    ]
}

/// Boxes of other shapes and sizes, and at other positions.
fn other_boxes() -> Vec<Row> {
    vec![
        Row {
            id: "C08",
            what: "a flat box, met obliquely",
            corners: FLAT,
            exact: Number(5.001_249_843_789_051),
            bound: Ulps(2.0),
            ..Row::of_unit(line([0.3, 0.4, 5.0], [0.1, 0.05, -5.0]))
        },
        Row {
            id: "C09",
            what: "a flat box, along its sheet",
            corners: FLAT,
            exact: Number(2.0),
            ..Row::of_unit(line([-2.0, 0.5, 0.0], [1.0, 0.0, 0.0]))
        },
        Row {
            id: "C10",
            what: "corners in the wrong order",
            corners: Corners {
                lbf: [1.0; 3],
                run: [0.0; 3],
            },
            exact: Number(4.0),
            protocol: Fails,
            ..Row::of_unit(ahead(0.5, 0.5))
        },
        Row {
            id: "C13",
            what: "infinite corners",
            corners: Corners {
                lbf: [f64::NEG_INFINITY, f64::NEG_INFINITY, 0.0],
                run: [f64::INFINITY, f64::INFINITY, 1.0],
            },
            exact: Refused,
            protocol: Fails,
            ..Row::of_unit(ahead(0.5, 0.5))
        },
        Row {
            id: "C18",
            slabs: Some("C18s"),
            what: "along an edge of a small box elsewhere",
            corners: Corners {
                lbf: [3.223, 0.241, 2.119],
                run: [3.225, 0.243, 2.121],
            },
            exact: Number(0.100_000_000_000_000_09),
            ..Row::of_unit(line([3.225, 0.243, 2.221], [0.0, 0.0, -1.0]))
        },
        // The computed 5 - 4.1 is not below 0.9.
        Row {
            id: "C19",
            what: "at the middle of a face, from 4.1 before it",
            corners: Corners {
                lbf: [0.1, 0.2, 0.3],
                run: [0.7, 1.1, 0.9],
            },
            exact: Number(4.1),
            protocol: Fails,
            ..Row::of_unit(line([0.4, 0.6, 5.0], [0.0, 0.0, -1.0]))
        },
    ]
}

/// Rays without a direction.
fn odd_rays() -> Vec<Row> {
    vec![
        Row {
            id: "C16",
            slabs: Some("C16s"),
            what: "a direction of NaN",
            exact: Refused,
            protocol: Fails,
            ..Row::of_unit(line([0.5, 0.5, 5.0], [f64::NAN, 0.0, -1.0]))
        },
        Row {
            id: "C17",
            slabs: Some("C17s"),
            what: "no direction, inside",
            exact: Refused,
            protocol: Fails,
            ..Row::of_unit(line([0.5; 3], [0.0; 3]))
        },
    ]
}

/// How far outside of the left face a hit is, of a ray that slopes outwards by almost nothing.
fn beside_the_face() -> Case {
    let ray = barely(-1e-310).any_ray();
    let [lbf, run] = [UNIT.lbf, UNIT.run].map(point);
    let outside = |t: Option<f64>| t.map_or(0.0, |t| -ray.at(t).x());
    let ours = AxisAlignedBox::new(lbf, run).map(|unit| outside(first(&unit, &ray)));
    let theirs = outside(axis_aligned_box(lbf, run, &ray, Compared::Three));
    Case {
        id: "C15",
        what: "the same outwards by 4e-310: how far outside the hit is".into(),
        exact: Number(0.0),
        // Both distances may be rounded by 3 u of their 4.
        bound: Absolute(12.0 * f64::EPSILON),
        protocol: Holds,
        ..Case::of(ours, theirs)
    }
}
