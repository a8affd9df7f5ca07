//! Reads scenes from files: discs, groups and their transforms.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::View;
use a04_intersections::Geometry;
use a06_shadows_reflection::from_file::shadowed;
use common::pixel_trace::digits;
use glam::DMat4;
use scene_file::{Error, Item, SceneFile};

use crate::{Disc, Mat4x4, Node, Transform, traced};

/// The camera and the world of a file.
pub fn view(file: &SceneFile) -> Result<View, Error> {
    shadowed(file, geometry).map(traced)
}

/// A shape of this stage or a lower one.
fn geometry(item: &Item) -> Result<Box<dyn Geometry>, Error> {
    match item.kind.name {
        "disc" => {
            let normal = item.vector("normal", Vector3::new)?.as_normal();
            let center = item.vector("center", Point3::new)?;
            let disc = Disc::new(center, normal, item.number("radius")?);
            Ok(Box::new(item.check(disc)?))
        }
        "group" => {
            let is_step = |table: &&Item| table.kind.name == "step";
            let (steps, shapes): (Vec<_>, Vec<_>) = item.tables.iter().partition(is_step);
            let mut node = Node::new(steps.into_iter().try_fold(Transform::IDENTITY, chain)?);
            for shape in shapes {
                node.children.push(geometry(shape)?);
            }
            Ok(Box::new(node))
        }
        _ => a04_intersections::from_file::geometry(item),
    }
}

/// A transform and a step of a group, which is applied to the object first.
fn chain(transform: Transform, step: &Item) -> Result<Transform, Error> {
    let keys: Vec<_> = step.values.iter().map(|(key, ..)| *key).collect();
    let chained = match keys[..] {
        ["translate"] => transform.translate(step.vector("translate", Point3::new)?),
        ["scale"] => {
            let [[x, y, z]] = step.rows("scale")?;
            transform.scale(x, y, z)
        }
        ["rotate_x"] => transform.rotate_x(step.angle("rotate_x")?),
        ["rotate_y"] => transform.rotate_y(step.angle("rotate_y")?),
        ["rotate_z"] => transform.rotate_z(step.angle("rotate_z")?),
        ["matrix"] | ["inverse", "matrix"] => {
            let rows = matrix(step.rows("matrix")?);
            let inverse = inverse(step, rows)?;
            transform.chain(rows, inverse)
        }
        _ => {
            let text = "a step has one key, such as { scale = [1, 2, 1] }; only an inverse stands \
                beside its matrix";
            return Err(step.error("", text));
        }
    };
    step.check(chained)
}

/// A matrix of three rows, and (0, 0, 0, 1) below.
fn matrix([x, y, z]: [[f64; 4]; 3]) -> Mat4x4 {
    Mat4x4::from_rows([x, y, z, [0.0, 0.0, 0.0, 1.0]])
}

/// Largest difference of the product of a matrix and its inverse from the identity. Rounding
/// keeps it below this, unless the matrix has nearly no inverse.
const LARGEST_DIFFERENCE: f64 = 1e-6;

/// The inverse of a matrix: that of the step, or else computed.
fn inverse(step: &Item, rows: Mat4x4) -> Result<Mat4x4, Error> {
    let given = step.find_rows("inverse").map(matrix);
    let matrix = rows.to_glam();
    let inverse = given.map_or_else(|| matrix.inverse(), Mat4x4::to_glam);
    let differences = (inverse * matrix - DMat4::IDENTITY).to_cols_array();
    // NaN, which compares false, counts as the largest.
    let is_worse = |a: f64, b: f64| a.is_nan() || a > b;
    let largest = differences.into_iter().map(f64::abs);
    let largest = largest.fold(
        0.0,
        |most, next| if is_worse(next, most) { next } else { most },
    );
    if largest <= LARGEST_DIFFERENCE {
        return Ok(Mat4x4::from_rows(inverse.transpose().to_cols_array_2d()));
    }
    let [off, most] = [largest, LARGEST_DIFFERENCE].map(|number| digits(&[number]));
    Err(if given.is_some() {
        let text = format!(
            "the inverse does not fit the matrix: their product differs by {off} from the \
             identity, and {most} is allowed; without the key it is computed"
        );
        step.error("inverse", text)
    } else {
        let text = "the matrix is singular, or nearly so: it has no inverse that could be computed";
        step.error("matrix", text)
    })
}
