//! `registry`: one row for each shape of this stage: its table in a scene file and how it is read and
//! written, its section in the book, and its numbers for the engine.

pub mod example_files;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a03_rays_cameras::instruments::instrumented::ray_step;
use a03_rays_cameras::registry::Format;
use a04_intersections::Geometry;
use a04_intersections::registry::{
    Content, SHAPES as SIMPLE_SHAPES, ShapeKind, ShapeRow, Shapes, Shared,
};
use a06_shadows_reflection::registry::read_view;
use common::pixel_trace::digits;
use common::steps::{self, StepKind};
use glam::DMat4;
use scene_file::{Error, Item};

use crate::{Disc, Mat4x4, Node, Transform, traced};

/// The shapes of this stage.
pub const SHAPES: &[ShapeRow] = &[
    ShapeRow::of::<Disc>("disc", "a07-transforms.md#disc"),
    ShapeRow::of::<Node>("group", "a07-transforms.md#node"),
    ShapeRow::of::<Shared>("use", "scene-files.md#the-same-shapes-in-several-places"),
];

/// All shapes that this stage knows.
pub const ALL_SHAPES: Shapes = Shapes(&[SIMPLE_SHAPES, SHAPES]);

/// The scene files of this stage.
pub const FORMAT: Format = Format {
    stage: 7,
    view: |file| read_view(file, ALL_SHAPES).map(traced),
};

impl ShapeKind for Disc {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let normal = item.vector("normal", Vector3::new)?.as_normal();
        let center = item.vector("center", Point3::new)?;
        item.check(Self::new(center, normal, item.number("radius")?))
    }

    fn content(&self) -> Content<'_> {
        Content::Values(vec![
            ("center", self.c.to_glam().to_array().into()),
            ("normal", self.plane.normal().to_glam().to_array().into()),
            ("radius", vec![self.r]),
        ])
    }

    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        Some(engine::Shape::Disc(engine::Disc {
            plane: self.plane.into(),
            radius: self.r,
        }))
    }
}

impl ShapeKind for Node {
    /// A node with the steps of any table.
    fn read(item: &Item, children: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let transform = item.steps().try_fold(Transform::IDENTITY, chain)?;
        Ok(Self {
            transform,
            children,
        })
    }

    fn content(&self) -> Content<'_> {
        let [matrix, inverse] =
            [self.transform.matrix(), self.transform.inverse()].map(Mat4x4::to_glam);
        Content::Children {
            shapes: self.children.iter().map(|child| &**child).collect(),
            transform: Some(Box::new(engine::Transform::new(matrix, inverse))),
        }
    }

    fn children(&self) -> &[Box<dyn Geometry>] {
        &self.children
    }

    fn children_mut(&mut self) -> Option<&mut Vec<Box<dyn Geometry>>> {
        Some(&mut self.children)
    }

    fn push_object_ray(&self, ray: &Ray) {
        steps::push(StepKind::ObjectRay, |kind| {
            let section = "a07-transforms.md#the-ray-in-object-space";
            let object_ray = self.transform.ray_to_object(ray);
            ray_step(kind, "ray in object space", section, &object_ray)
        });
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
        ["rotate"] => {
            let [[x, y, z]] = step.rows("rotate")?;
            // The first rotation is applied to the object first, so that it stands last.
            let angles = [x, y, z].map(f64::to_radians);
            let about_z = transform.rotate_z(angles[2]);
            let about_y = about_z.and_then(|chain| chain.rotate_y(angles[1]));
            about_y.and_then(|chain| chain.rotate_x(angles[0]))
        }
        ["matrix"] | ["inverse", "matrix"] => {
            let rows = matrix(step.rows("matrix")?);
            let inverse = inverse(step, rows)?;
            transform.chain(rows, inverse)
        }
        [] => {
            return Err(Error {
                is_missing: true,
                ..step.error("", "a step lacks a key, such as { scale = [1, 2, 1] }")
            });
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
const MAX_DIFFERENCE: f64 = 1e-6;

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
    if largest <= MAX_DIFFERENCE {
        return Ok(Mat4x4::from_rows(inverse.transpose().to_cols_array_2d()));
    }
    let [off, most] = [largest, MAX_DIFFERENCE].map(|number| digits(&[number]));
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
