//! Reads scenes from files: discs, groups and their transforms.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::View;
use a04_intersections::Geometry;
use a06_shadows_reflection::from_file::shadowed;
use common::ArgumentError;
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
            let inverse = step.find_rows("inverse").map(matrix);
            chain_matrix(transform, matrix(step.rows("matrix")?), inverse)
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

/// A transform and a matrix, which is applied to the object first. Rounding keeps the product
/// of matrix and inverse within a millionth of the identity.
fn chain_matrix(
    transform: Transform,
    matrix: Mat4x4,
    inverse: Option<Mat4x4>,
) -> Result<Transform, ArgumentError> {
    let rows = matrix.to_glam();
    let inverse = inverse.map_or_else(|| rows.inverse(), Mat4x4::to_glam);
    if !(inverse * rows).abs_diff_eq(DMat4::IDENTITY, 1e-6) {
        let allowed = "a matrix with an inverse, whose product is the identity";
        return Err(ArgumentError::new("matrix", "singular", allowed));
    }
    let from_glam = |m: DMat4| Mat4x4::from_rows(m.transpose().to_cols_array_2d());
    transform.chain(matrix, from_glam(inverse))
}
