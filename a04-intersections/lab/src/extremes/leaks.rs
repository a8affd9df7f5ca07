//! Rays that pass between triangles, or past the edges of a box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use common::Error;
use measure::Effort;
use measure::extremes::{Case, Fails, Holds, Number, Protocol, tried};

use crate::aimed_box::{Aimed, LBF, OTHERS, RUN};
use crate::closed_mesh::{Aim, ClosedMesh};
use crate::protocol;
use crate::support::{corners, first};
use a04_intersections::{AxisAlignedBox, Triangle};

const HERE: Point3 = Point3::ORIGIN;
/// A position far from the origin, where coordinates are coarse, from Embree's tests.
const FAR: Point3 = Point3::new(148_376.0, 1_234.0, -223_423.0);

/// By our triangles or the protocol's.
type IsHit = fn(&Triangle, &Ray) -> bool;

fn is_hit(triangle: &Triangle, ray: &Ray) -> bool {
    first(triangle, ray).is_some()
}

fn is_hit_by_the_protocol(triangle: &Triangle, ray: &Ray) -> bool {
    protocol::triangle(&corners(triangle), ray).is_some()
}

/// Number of rays from near the middle of a closed mesh that miss all its triangles.
fn leaking(middle: Point3, aim: Aim, rays: usize, is_hit: IsHit) -> Result<usize, Error> {
    let mesh = ClosedMesh::around(middle)?;
    let mut leaking = 0;
    for n in 0..rays {
        let ray = mesh.ray(aim, n)?;
        let mut triangles = mesh.triangles.iter();
        let is_held = triangles.any(|triangle| is_hit(triangle, &ray));
        leaking += usize::from(!is_held);
    }
    Ok(leaking)
}

fn leaks(id: &str, middle: Point3, aim: Aim, rays: usize, protocol: Protocol) -> Case {
    let place = if middle == FAR {
        " far from the origin"
    } else {
        ""
    };
    let at = aim.words();
    let ours = leaking(middle, aim, rays, is_hit);
    let theirs = leaking(middle, aim, rays, is_hit_by_the_protocol);
    Case {
        id: id.to_owned(),
        what: format!("a closed mesh{place}, {rays} rays {at}: rays that get out"),
        exact: Number(0.0),
        protocol,
        ..Case::of(ours, theirs)
    }
}

/// A row for each formula of others: rays at a box that are lost, or hit it elsewhere.
struct BoxRows {
    ids: [&'static str; OTHERS.len()],
    /// What the rays aim at, and how many faces meet there.
    aim: &'static str,
    faces: usize,
    /// Whether the other formulas hold.
    expected: [Protocol; OTHERS.len()],
}

impl BoxRows {
    fn cases(&self, rays: usize) -> Vec<Case> {
        let ours = tried(|| {
            let aab = AxisAlignedBox::new(LBF, RUN)?;
            Ok(self.wrong(rays, |ray| first(&aab, ray)))
        });
        let mut cases = Vec::new();
        for (i, formula) in OTHERS.iter().enumerate() {
            let (aim, name) = (self.aim, formula.name);
            cases.push(Case {
                id: self.ids[i].to_owned(),
                what: format!("a box, {rays} rays at {aim}: lost or met elsewhere; {name}"),
                exact: Number(0.0),
                protocol: self.expected[i],
                ..Case::of(ours, self.wrong(rays, formula.t))
            });
        }
        cases
    }

    /// The number of rays for which a formula is wrong.
    fn wrong(&self, rays: usize, formula: impl Fn(&Ray) -> Option<f64>) -> usize {
        let mut wrong = 0;
        for n in 0..rays {
            let aimed = Aimed::new(self.faces, n);
            wrong += usize::from(aimed.is_wrong(formula(&aimed.ray)));
        }
        wrong
    }
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let rays = effort.choose(500, 50_000);
    let mut cases = vec![
        leaks("S01", HERE, Aim::Corners, rays, Fails),
        leaks("S02", HERE, Aim::Edges, rays, Fails),
        leaks("S04", FAR, Aim::Corners, rays, Fails),
        leaks("S06", HERE, Aim::Anywhere, rays, Holds),
    ];
    let boxes = [
        BoxRows {
            ids: ["S07", "S07t"],
            aim: "a face",
            faces: 1,
            expected: [Fails, Holds],
        },
        BoxRows {
            ids: ["S08", "S08t"],
            aim: "an edge",
            faces: 2,
            expected: [Fails; 2],
        },
        BoxRows {
            ids: ["S09", "S09t"],
            aim: "a corner",
            faces: 3,
            expected: [Fails; 2],
        },
    ];
    for rows in boxes {
        cases.extend(rows.cases(effort.choose(2000, 100_000)));
    }
    cases
}
