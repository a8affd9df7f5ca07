//! Rays that pass between triangles, or past the edges of a box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use common::{ArgumentError, Error};
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id, Protocol};

use crate::lab::experiments::aimed_box::{Aimed, LBF, NAIVE, RUN, aimed, is_wrong};
use crate::lab::experiments::icosphere::Mesh;
use crate::lab::protocol;
use crate::lab::support::{Numbers, first};
use crate::{AxisAlignedBox, Triangle};

/// A closed surface of 320 triangles whose corners are 1 to 2 away from its
/// middle, so that all are different.
struct Hull {
    middle: Point3,
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
        let corners = mesh.faces.iter().map(|face| face.map(place));
        let triangles = corners.map(|[a, b, c]| Triangle::new(a, b, c));
        let triangles = triangles.collect::<Result<_, _>>()?;
        Ok(Self { middle, triangles })
    }

    /// The `n`-th ray from near the middle, where all triangles are visible.
    fn ray(&self, (aim, _): Aim, n: usize) -> Result<Ray, ArgumentError> {
        let mut numbers = Numbers::new(52, n);
        let eye = self.middle + numbers.triple(-0.1, 0.1);
        let face = self.triangles[numbers.below(self.triangles.len())].corners;
        let side = numbers.below(3);
        let (from, to) = (face[side], face[(side + 1) % 3]);
        let way = match aim(&mut numbers) {
            Some(share) => from + (to - from) * share - eye,
            None => numbers.direction(),
        };
        Ray::new(eye, way)
    }

    fn ours(&self, ray: &Ray) -> bool {
        self.triangles
            .iter()
            .any(|triangle| first(triangle, ray).is_some())
    }

    fn theirs(&self, ray: &Ray) -> bool {
        let is_hit = |triangle: &Triangle| protocol::triangle(&triangle.corners, ray).is_some();
        self.triangles.iter().any(is_hit)
    }
}

/// By our triangles or the protocol's.
type IsHit = fn(&Hull, &Ray) -> bool;

/// Number of rays that miss all triangles of the hull around a point, out of `rays`.
fn out(middle: Point3, aim: Aim, rays: usize, is_hit: IsHit) -> Result<usize, Error> {
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

/// Rows of the box with the protocol's three coordinates, two coordinates, and naive
/// slabs.
fn box_rows(ids: [Id; 3], faces: usize, rays: usize, says: [Protocol; 3]) -> [Case; 3] {
    let count = |formula: &dyn Fn(&Ray) -> Option<f64>| {
        let wrong = |aimed: &Aimed| is_wrong(aimed, formula(&aimed.0));
        (0..rays).map(|n| aimed(faces, n)).filter(wrong).count()
    };
    let ours = AxisAlignedBox::new(LBF, RUN).map(|aab| count(&|ray| first(&aab, ray)));
    let aim = ["", "a face", "an edge", "a corner"][faces];
    let names = [
        "three coordinates compared",
        "two coordinates compared",
        "naive slabs",
    ];
    std::array::from_fn(|i| {
        let name = names[i];
        let what = format!("a box, {rays} rays at {aim}: lost or met elsewhere; {name}");
        Case::new(ids[i], what, 0.0, Equal, ours.clone()).protocol(says[i], count(&NAIVE[i]))
    })
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let (rays, aimed) = (effort.choose(500, 50_000), effort.choose(2000, 100_000));
    // At three places, at three targets.
    let each = effort.choose(500, 120_000);
    let targets = |middle| [CORNER, EDGE, MIDDLE_OF_EDGE].map(|aim| out(middle, aim, each, Hull::ours));
    let all: Result<usize, _> = [HERE, FAR, VERY_FAR].into_iter().flat_map(targets).sum();
    let mut cases = vec![
        leaks("S01", HERE, CORNER, rays, Fails),
        leaks("S02", HERE, EDGE, rays, Fails),
        leaks("S03", HERE, MIDDLE_OF_EDGE, rays, Fails),
        leaks("S04", FAR, CORNER, rays, Fails),
        Case::new("S05", format!("closed meshes at three places, {} rays at corners and edges: rays that get out",
            9 * each), 0.0, Equal, all),
        leaks("S06", HERE, ANYWHERE, rays, Holds),
    ];
    cases.extend(box_rows(["S07", "S07t", "S07s"], 1, aimed, [Fails, Holds, Holds]));
    cases.extend(box_rows(["S08", "S08t", "S08s"], 2, aimed, [Fails; 3]));
    cases.extend(box_rows(["S09", "S09t", "S09s"], 3, aimed, [Fails; 3]));
    cases
}
