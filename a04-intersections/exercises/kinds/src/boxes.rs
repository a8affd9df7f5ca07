//! Boxes between two corners, which two exercises ask, and rays within their faces.

use a02_math::arrays::{array, point, vector};
use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::Geometry;
use testing::exercises::Made;

use crate::rays::{Edge, RayWithin, ahead, beside, of_sizes};
use crate::shape::{NewShape, Shapes, new_shape, own};

/// The parameters of a box between two corners.
pub type Corners = ([f64; 3], [f64; 3]);

/// The code that makes boxes by this function. At an edge the normals of several faces are right: for
/// each of them, the box answers with the first.
pub fn new_box<G: Geometry + 'static>(
    new: impl Fn(Point3, Point3) -> Made<G> + Send + Sync + 'static,
) -> NewShape<Corners> {
    new_shape(move |(lbf, run)| {
        let shape = new(point(lbf), point(run))?;
        Ok(own(move |ray: &Ray, within| {
            let mut hit = shape.hit(ray, within)?;
            let normals = normals_at(ray.at(hit.t), (lbf, run));
            let is_right = |normal: Normal3| normals.iter().any(|face| is_near(normal, *face));
            if is_right(hit.normal) && is_right(hit.geometric_normal) {
                (hit.normal, hit.geometric_normal) = (normals[0], normals[0]);
            }
            Some(hit)
        }))
    })
}

/// The normals of all faces of a box in whose planes a point lies.
fn normals_at(p: Point3, (lbf, run): Corners) -> Vec<Normal3> {
    let mut normals = Vec::new();
    for (axis, coordinate) in array(p).into_iter().enumerate() {
        for (face, side) in [(lbf[axis], -1.0), (run[axis], 1.0)] {
            if (coordinate - face).abs() <= ROUNDING * (run[axis] - lbf[axis]) {
                let mut normal = [0.0; 3];
                normal[axis] = side;
                normals.push(vector(normal).as_normal());
            }
        }
    }
    normals
}

fn is_near(a: Normal3, b: Normal3) -> bool {
    let (a, b) = (array(a), array(b));
    (0..3).all(|axis| (a[axis] - b[axis]).abs() <= ROUNDING)
}

/// More than the rounding errors of a point and of a normal, relative to the box.
const ROUNDING: f64 = 1e-9;

const FIRST: Corners = ([-1.5; 3], [1.5; 3]);

/// Boxes between two corners.
#[must_use]
pub fn boxes() -> Shapes<Corners> {
    Shapes {
        words: "box from {} to {}",
        first: FIRST,
        further: vec![],
        on_surface: vec![[1.5, 0.0, 0.0], [0.5, -1.5, 0.25], [-0.5, 0.5, 1.5]],
        own_rays: [
            within_faces().into_iter().map(|ray| (FIRST, ray)).collect(),
            of_sizes(|size| ([-1.5 * size; 3], [1.5 * size; 3])),
            beside(&FIRST, &edges()),
        ]
        .concat(),
        middle: |(lbf, run)| [0, 1, 2].map(|k| f64::midpoint(lbf[k], run[k])),
        any: |r| {
            let lbf = r.triple(5.0);
            (lbf, lbf.map(|low| low + r.between(0.1, 3.0)))
        },
    }
}

/// Edges of the first box, seen along each axis.
fn edges() -> Vec<Edge> {
    let mut edges = Vec::new();
    for axis in 0..3 {
        for (across, side) in [((axis + 1) % 3, 1.0), ((axis + 2) % 3, -1.0)] {
            let (mut on_edge, mut direction, mut outwards) = ([0.5; 3], [0.0; 3], [0.0; 3]);
            (on_edge[axis], on_edge[across]) = (1.5, 1.5 * side);
            direction[axis] = -1.0;
            outwards[across] = side;
            edges.push((on_edge, direction, outwards));
        }
    }
    edges
}

/// Rays within the faces of the first box, which belong to it: from outside and from inside of the
/// face, along its edges and aslant.
fn within_faces() -> Vec<RayWithin> {
    let mut within = Vec::new();
    for face in [-1.5, 1.5] {
        for sign in [1.0, -1.0] {
            for axis in 0..3 {
                let (along, across) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut origin = [0.5; 3];
                origin[axis] = face;
                let mut direction = [0.0; 3];
                direction[along] = sign;
                within.push(ahead(origin, direction));
                origin[along] = -4.0 * sign;
                within.push(ahead(origin, direction));
                // Zeros have signs, and a quotient by them, too.
                within.push(ahead(
                    origin,
                    direction.map(|x| if x == 0.0 { -0.0 } else { x }),
                ));
                // Past an edge, which it touches.
                let (mut outside, mut past) = ([0.25; 3], [0.0; 3]);
                (outside[axis], outside[along]) = (2.0 * face, 0.0);
                (past[axis], past[along]) = (-face, face * sign);
                within.push(ahead(outside, past));
                // Along an edge, aslant in the face, and beside the box.
                origin[across] = face;
                within.push(ahead(origin, direction));
                direction[across] = -face / 4.0;
                within.push(ahead(origin, direction));
                origin[across] = 3.0;
                direction[across] = 0.0;
                within.push(ahead(origin, direction));
            }
        }
    }
    within
}
