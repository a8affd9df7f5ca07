//! Boxes between two corners, which two exercises ask.

use a02_math::arrays::{array, point, vector};
use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use testing::exercises::Made;

use crate::shape::{NewShape, OwnShape, new_shape};

/// The parameters of a box between two corners.
pub type Corners = ([f64; 3], [f64; 3]);

/// The code that makes boxes by this function. At an edge the normals of several faces are right: for
/// each of them, the box answers with the first.
pub fn new_box<G: Geometry + 'static>(
    new: impl Fn(Point3, Point3) -> Made<G> + Send + Sync + 'static,
) -> NewShape<Corners> {
    new_shape(move |(lbf, run)| {
        let shape = new(point(lbf), point(run))?;
        Ok(OwnShape(move |ray: &Ray, within: Interval| {
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
