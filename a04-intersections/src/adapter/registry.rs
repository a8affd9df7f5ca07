//! `registry`: one row for each shape of this stage: its table in a scene file and how it is read and
//! written, its section in the book, and its numbers for the engine.
//!
//! A shape without a row works, too: the engine asks its `hit`, ray by ray.

mod for_engine;
mod mesh;
mod read_objects;
mod shape_row;
mod shared;
mod written;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::View;
use a03_rays_cameras::registry::{Format, read_camera};
use common::{ArgumentError, Color};
use scene_file::{Error, FirstMistake, Item, SceneFile};

use crate::{AxisAlignedBox, Geometry, Hit, Plane, Sphere, Triangle, World};
pub use mesh::Mesh;
pub use shape_row::{Content, ShapeKind, ShapeRow, Shapes};
pub use shared::Shared;

/// The shapes of this stage.
pub const SHAPES: &[ShapeRow] = &[
    ShapeRow::of::<Plane>("plane", "a04-intersections.md#plane"),
    ShapeRow::of::<AxisAlignedBox>("box", "a04-intersections.md#box"),
    ShapeRow::of::<Triangle>("triangle", "a04-intersections.md#triangle"),
    ShapeRow::of::<Sphere>("sphere", "a04-intersections.md#sphere"),
    ShapeRow::of::<Mesh>("mesh", "a04-intersections.md#one-question-and-an-interval"),
];

/// All shapes that this stage knows.
pub const ALL_SHAPES: Shapes = Shapes(&[SHAPES]);

/// The scene files of this stage.
pub const FORMAT: Format = Format { stage: 4, view };

impl ShapeKind for Plane {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let point = item.vector("point", Point3::new)?;
        let normal = item.vector("normal", Vector3::new)?.as_normal();
        item.check(Self::new(point, normal))
    }

    fn content(&self) -> Content<'_> {
        Content::Values(vec![
            ("point", self.a.to_glam().to_array().into()),
            ("normal", self.n.to_glam().to_array().into()),
        ])
    }

    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        Some(engine::Shape::Plane((*self).into()))
    }
}

impl From<Plane> for engine::Plane {
    fn from(plane: Plane) -> Self {
        Self {
            point: plane.a.to_glam(),
            normal: plane.n.to_glam(),
        }
    }
}

impl ShapeKind for AxisAlignedBox {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let lbf = item.vector("lbf", Point3::new)?;
        let run = item.vector("run", Point3::new)?;
        item.check(Self::new(lbf, run))
    }

    fn content(&self) -> Content<'_> {
        Content::Values(vec![("lbf", self.lbf.into()), ("run", self.run.into())])
    }

    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        Some(engine::Shape::Box(engine::AxisAlignedBox {
            min: self.lbf,
            max: self.run,
        }))
    }
}

impl ShapeKind for Triangle {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let corners = item.rows("corners")?;
        item.check(triangle(corners, item.find_rows("normals")))
    }

    /// The normals of the corners only where they are not the triangle's own.
    fn content(&self) -> Content<'_> {
        let corners = self.corners.map(|p| p.to_glam().to_array());
        let mut values = vec![("corners", corners.as_flattened().to_vec())];
        if self.normals != [self.geometric_normal; 3] {
            let normals = self.normals.map(|n| n.to_glam().to_array());
            values.push(("normals", normals.as_flattened().to_vec()));
        }
        Content::Values(values)
    }

    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        Some(engine::Shape::Triangle(engine::Triangle {
            corners: self.corners.map(Point3::to_glam),
            normals: self.normals.map(Normal3::to_glam),
            geometric_normal: self.geometric_normal.to_glam(),
            scale: self.scale,
        }))
    }
}

/// A triangle, with the normals of its corners for smooth shading.
fn triangle(
    corners: [[f64; 3]; 3],
    normals: Option<[[f64; 3]; 3]>,
) -> Result<Triangle, ArgumentError> {
    let [a, b, c] = corners.map(|[x, y, z]| Point3::new(x, y, z));
    let triangle = Triangle::new(a, b, c)?;
    let normals = normals.map(|normals| normals.map(|[x, y, z]| Normal3::new(x, y, z)));
    normals.map_or(Ok(triangle), |normals| triangle.with_normals(normals))
}

impl ShapeKind for Sphere {
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let center = item.vector("center", Point3::new)?;
        item.check(Self::new(center, item.number("radius")?))
    }

    fn content(&self) -> Content<'_> {
        Content::Values(vec![
            ("center", self.c.to_glam().to_array().into()),
            ("radius", vec![self.r]),
        ])
    }

    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        Some(engine::Shape::Sphere(engine::Sphere {
            center: self.c.to_glam(),
            radius: self.r,
        }))
    }
}

impl From<Hit> for engine::Hit {
    fn from(hit: Hit) -> Self {
        Self {
            t: hit.t,
            normal: hit.normal.to_glam(),
            geometric_normal: hit.geometric_normal.to_glam(),
            scale: hit.scale,
        }
    }
}

impl From<&engine::Hit> for Hit {
    fn from(hit: &engine::Hit) -> Self {
        Self {
            t: hit.t,
            normal: Normal3::from_glam(hit.normal),
            geometric_normal: Normal3::from_glam(hit.geometric_normal),
            scale: hit.scale,
        }
    }
}

/// A world of colours as a scene of the engine.
#[must_use]
pub fn for_engine(world: &World<Color>) -> engine::Scene<'_> {
    let mut scene = engine::Scene::new(world.background(), Color::BLACK, 1);
    ALL_SHAPES.add_objects(&mut scene, world, |color| {
        engine::Surface::matt(engine::Shading::SingleColor(*color))
    });
    scene
}

/// The camera and the world of a file.
fn view(file: &SceneFile) -> Result<View, Error> {
    let mut first = FirstMistake::of(file);
    let item = &file.world;
    let empty = first.keep(item.check(World::new(item.color("background"))));
    let color = |item: &Item| item.vector("color", Color::new);
    let objects = ALL_SHAPES.read_objects(file, &mut first, color);
    let camera = first.keep(read_camera(file));
    let (world, camera) = first.result(empty.zip(camera))?;
    let world = World { objects, ..world };
    Ok(View { camera, world }.boxed())
}
