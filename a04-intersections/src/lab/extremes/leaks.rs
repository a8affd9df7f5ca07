//! Rays that pass between triangles, or past the edges of a box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use common::{ArgumentError, Error};
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id, Protocol};

use super::first;
use crate::lab::experiments::Numbers;
use crate::lab::experiments::aimed_box::{self, Aimed, LBF, RUN, aimed};
use crate::lab::experiments::icosphere::Mesh;
use crate::{AxisAlignedBox, Triangle, protocol};

/// A closed surface of 320 triangles whose corners are 1 to 2 away from its
/// middle, so that all are different.
struct Hull {
    middle: Point3,
    corners: Vec<[Point3; 3]>,
    triangles: Vec<Triangle>,
}

/// The target of a ray from inside the hull, as the share of an edge that ends there, or
/// none for a ray in any direction; and its description.
type Aim = (fn(&mut Numbers) -> Option<f64>, &'static str);

const CORNER: Aim = (|_| Some(0.0), "at corners");
const EDGE: Aim = (|numbers| Some(numbers.between(0.0, 1.0)), "at edges");
const MIDDLE_OF_EDGE: Aim = (|_| Some(0.5), "at the middles of edges");
const ANYWHERE: Aim = (|_| None, "anywhere, which proves nothing");

impl Hull {
    fn new(middle: Point3) -> Result<Self, ArgumentError> {
        let mesh = Mesh::icosphere(2);
        let place = |corner: usize| {
            middle + mesh.corners[corner] * Numbers::new(51, corner).between(1.0, 2.0)
        };
        let corners: Vec<_> = mesh.faces.iter().map(|face| face.map(place)).collect();
        let triangles = corners.iter().map(|&[a, b, c]| Triangle::new(a, b, c));
        Ok(Self {
            middle,
            triangles: triangles.collect::<Result<_, _>>()?,
            corners,
        })
    }

    /// The `n`-th ray from near the middle, where all triangles are visible.
    fn ray(&self, (aim, _): Aim, n: usize) -> Result<Ray, ArgumentError> {
        let mut numbers = Numbers::new(52, n);
        let eye = self.middle + numbers.triple(-0.1, 0.1);
        let face = self.corners[numbers.below(self.corners.len())];
        let side = numbers.below(3);
        let (from, to) = (face[side], face[(side + 1) % 3]);
        let way = match aim(&mut numbers) {
            Some(share) => from + (to - from) * share - eye,
            None => numbers.direction(),
        };
        Ray::new(eye, way)
    }

    fn ours(&self, ray: &Ray) -> bool {
        let mut triangles = self.triangles.iter();
        triangles.any(|triangle| first(triangle, ray).is_some())
    }

    fn theirs(&self, ray: &Ray) -> bool {
        let mut corners = self.corners.iter();
        corners.any(|corners| protocol::triangle(corners, ray).is_some())
    }
}

/// Number of rays that miss all triangles of the hull around a point, out of `rays`.
fn out(
    middle: Point3,
    aim: Aim,
    rays: usize,
    is_hit: fn(&Hull, &Ray) -> bool,
) -> Result<usize, Error> {
    let hull = Hull::new(middle)?;
    let out = |n| Ok(usize::from(!is_hit(&hull, &hull.ray(aim, n)?)));
    (0..rays).map(out).sum()
}

const HERE: Point3 = Point3::ORIGIN;
/// A position far from the origin, where coordinates are coarse, from Embree's tests.
const FAR: Point3 = Point3::new(148_376.0, 1_234.0, -223_423.0);
const VERY_FAR: Point3 = Point3::new(1e9, -1e9, 1e9);

fn leaks(id: Id, middle: Point3, aim: Aim, rays: usize, says: Protocol) -> Case {
    let ((_, at), is_far) = (aim, middle == FAR);
    let place = if is_far { " far from the origin" } else { "" };
    let what = format!("a closed mesh{place}, {rays} rays {at}: rays that get out");
    Case::new(id, what, 0.0, Equal, out(middle, aim, rays, Hull::ours))
        .protocol(says, out(middle, aim, rays, Hull::theirs))
}

/// A row for three positions and three targets.
fn million(rays: usize) -> Case {
    let places = [HERE, FAR, VERY_FAR].into_iter();
    let targets = [CORNER, EDGE, MIDDLE_OF_EDGE];
    let all = places.flat_map(|middle| targets.map(|aim| out(middle, aim, rays, Hull::ours)));
    let rays = 9 * rays;
    let what = format!(
        "closed meshes at three places, {rays} rays at corners and edges: rays that get out"
    );
    Case::new("S05", what, 0.0, Equal, all.sum::<Result<usize, _>>())
}

/// A formula for the nearest hit of the box.
type Formula = fn(&Ray) -> Option<f64>;

/// Rows of the box with the protocol's three coordinates, two coordinates, and naive
/// slabs.
fn box_rows(ids: [&'static str; 3], faces: usize, rays: usize, says: [Protocol; 3]) -> [Case; 3] {
    let count = |formula: &dyn Fn(&Ray) -> Option<f64>| {
        let wrong = |aimed: &Aimed| aimed.is_wrong(formula(&aimed.ray));
        (0..rays).map(|n| aimed(faces, n)).filter(wrong).count()
    };
    let ours = AxisAlignedBox::new(LBF, RUN).map(|aab| count(&|ray| first(&aab, ray)));
    let aim = ["", "a face", "an edge", "a corner"][faces];
    let theirs: [(&str, Formula); 3] = [
        ("three coordinates compared", aimed_box::three),
        ("two coordinates compared", aimed_box::two),
        ("naive slabs", |ray| aimed_box::slabs(LBF, RUN, ray)),
    ];
    std::array::from_fn(|i| {
        let (name, formula) = theirs[i];
        let what = format!("a box, {rays} rays at {aim}: lost or met elsewhere; {name}");
        Case::new(ids[i], what, 0.0, Equal, ours.clone()).protocol(says[i], count(&formula))
    })
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let (rays, aimed) = (effort.choose(500, 50_000), effort.choose(2000, 100_000));
    let mut cases = vec![
        leaks("S01", HERE, CORNER, rays, Fails),
        leaks("S02", HERE, EDGE, rays, Fails),
        leaks("S03", HERE, MIDDLE_OF_EDGE, rays, Fails),
        leaks("S04", FAR, CORNER, rays, Fails),
        million(effort.choose(500, 120_000)),
        leaks("S06", HERE, ANYWHERE, rays, Holds),
    ];
    cases.extend(box_rows(["S07", "S07t", "S07s"], 1, aimed, [Fails, Holds, Holds]));
    cases.extend(box_rows(["S08", "S08t", "S08s"], 2, aimed, [Fails; 3]));
    cases.extend(box_rows(["S09", "S09t", "S09s"], 3, aimed, [Fails; 3]));
    cases
}
