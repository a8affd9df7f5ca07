//! Rays that pass between triangles, or past the edges of a box.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use common::Error;
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id, Protocol, case};

use crate::aimed_box::{Aimed, LBF, NAIVE, RUN, aimed, is_wrong};
use crate::mesh::Mesh;
use crate::protocol;
use crate::support::{Numbers, corners, first};
use a04_intersections::{AxisAlignedBox, Triangle};

/// The target of a ray from inside a mesh, as the fraction of an edge that ends there, or none
/// for a ray in any direction; and its description.
type Aim = (fn(&mut Numbers) -> Option<f64>, &'static str);

const CORNER: Aim = (|_| Some(0.0), "at corners");
const EDGE: Aim = (|numbers| Some(numbers.between(0.0, 1.0)), "at edges");
const MIDDLE_OF_EDGE: Aim = (|_| Some(0.5), "at the middles of edges");
const ANYWHERE: Aim = (|_| None, "anywhere, which proves nothing");

const HERE: Point3 = Point3::ORIGIN;
/// A position far from the origin, where coordinates are coarse, from Embree's tests.
const FAR: Point3 = Point3::new(148_376.0, 1_234.0, -223_423.0);
const VERY_FAR: Point3 = Point3::new(1e9, -1e9, 1e9);

/// By our triangles or the protocol's.
type IsHit = fn(&Triangle, &Ray) -> bool;

const OURS: IsHit = |triangle, ray| first(triangle, ray).is_some();
const THEIRS: IsHit = |triangle, ray| protocol::triangle(&corners(triangle), ray).is_some();

/// Number of rays from near the middle of a closed surface that miss all its triangles, all
/// of which are visible from there. The corners of the 320 triangles are 1 to 2 away from
/// the middle, so that all are different.
fn out(middle: Point3, (aim, _): Aim, rays: usize, is_hit: IsHit) -> Result<usize, Error> {
    let mesh = Mesh::icosphere(2);
    let height = |corner| Numbers::new(51, corner).between(1.0, 2.0);
    let place = |corner: usize| middle + mesh.corners[corner] * height(corner);
    let faces = mesh.faces.iter().map(|face| face.map(place));
    let triangles: Result<Vec<_>, _> = faces.map(|[a, b, c]| Triangle::new(a, b, c)).collect();
    let triangles = triangles?;
    let gets_out = |n| {
        let mut numbers = Numbers::new(52, n);
        let eye = middle + numbers.triple(-0.1, 0.1);
        let face = corners(&triangles[numbers.below(triangles.len())]);
        let side = numbers.below(3);
        let (from, to) = (face[side], face[(side + 1) % 3]);
        let way = match aim(&mut numbers) {
            Some(fraction) => from + (to - from) * fraction - eye,
            None => numbers.direction(),
        };
        let ray = Ray::new(eye, way)?;
        let is_held = triangles.iter().any(|triangle| is_hit(triangle, &ray));
        Ok(usize::from(!is_held))
    };
    (0..rays).map(gets_out).sum()
}

fn leaks(id: Id, middle: Point3, aim: Aim, rays: usize, says: Protocol) -> Case {
    let ((_, at), is_far) = (aim, middle == FAR);
    let place = if is_far { " far from the origin" } else { "" };
    let what = format!("a closed mesh{place}, {rays} rays {at}: rays that get out");
    let both = [OURS, THEIRS].map(|is_hit| out(middle, aim, rays, is_hit).into());
    case(id, what, both, 0.0, Equal, says)
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
    std::array::from_fn(|i| {
        let formula = [
            "three coordinates compared",
            "two coordinates compared",
            "naive slabs",
        ][i];
        let what = format!("a box, {rays} rays at {aim}: lost or met elsewhere; {formula}");
        let both = [ours.clone().into(), count(&NAIVE[i]).into()];
        case(ids[i], what, both, 0.0, Equal, says[i])
    })
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let (rays, aimed) = (effort.choose(500, 50_000), effort.choose(2000, 100_000));
    // At three places, at three targets.
    let each = effort.choose(500, 120_000);
    let targets = |middle| [CORNER, EDGE, MIDDLE_OF_EDGE].map(|aim| out(middle, aim, each, OURS));
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
