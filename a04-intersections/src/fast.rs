//! Translates the shapes of this stage for the engine.

use std::any::Any;

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::Color;

use crate::from_file::Mesh;
use crate::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};

impl From<Hit> for engine::Hit {
    fn from(hit: Hit) -> Self {
        Self {
            t: hit.t,
            normal: hit.normal.to_glam(),
            face: hit.face.to_glam(),
            magnitude: hit.magnitude,
        }
    }
}

impl From<&engine::Hit> for Hit {
    fn from(hit: &engine::Hit) -> Self {
        Self {
            t: hit.t,
            normal: Normal3::from_glam(hit.normal),
            face: Normal3::from_glam(hit.face),
            magnitude: hit.magnitude,
        }
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

/// Adds the shapes of a geometry, one by one, to the list of the engine.
pub type Translate = for<'a> fn(&'a dyn Geometry, &mut dyn FnMut(engine::Shape<'a>));

/// The engine's shape for a geometry of this stage: numbers if the engine has the
/// geometry's type, otherwise a function.
pub fn shapes<'a>(geometry: &'a dyn Geometry, add: &mut dyn FnMut(engine::Shape<'a>)) {
    let any: &dyn Any = geometry;
    add(
        if let Some(boxed) = any.downcast_ref::<Box<dyn Geometry>>() {
            return shapes(&**boxed, add);
        } else if let Some(Mesh(triangles)) = any.downcast_ref() {
            return triangles
                .objects()
                .for_each(|(triangle, ())| shapes(triangle, add));
        } else if let Some(sphere) = any.downcast_ref::<Sphere>() {
            engine::Shape::Sphere(engine::Sphere {
                center: sphere.c.to_glam(),
                radius: sphere.r,
            })
        } else if let Some(plane) = any.downcast_ref::<Plane>() {
            engine::Shape::Plane((*plane).into())
        } else if let Some(aab) = any.downcast_ref::<AxisAlignedBox>() {
            engine::Shape::Box(engine::AxisAlignedBox {
                min: aab.lbf,
                max: aab.run,
            })
        } else if let Some(triangle) = any.downcast_ref::<Triangle>() {
            engine::Shape::Triangle(engine::Triangle {
                corners: triangle.corners.map(Point3::to_glam),
                normals: triangle.normals.map(Normal3::to_glam),
                face: triangle.face.to_glam(),
                scale: triangle.scale,
            })
        } else {
            engine::Shape::other(|ray| {
                let hit = geometry.hit(&Ray::from(ray), Interval::AHEAD);
                hit.map(Into::into)
            })
        },
    );
}

/// Adds the objects of a world to a scene of the engine, in their order.
pub fn add_objects<'a, S>(
    scene: &mut engine::Scene<'a>,
    world: &'a World<S>,
    shapes: Translate,
    surface: impl Fn(&'a S) -> engine::Surface<'a>,
) {
    for (geometry, own) in world.objects() {
        let index = scene.add_surface(surface(own));
        shapes(geometry, &mut |shape| scene.add_shape(shape, index));
    }
}

/// A world of colours as a scene of the engine.
#[must_use]
pub fn scene(world: &World<Color>) -> engine::Scene<'_> {
    let mut scene = engine::Scene::new(world.background(), Color::BLACK, 1);
    add_objects(&mut scene, world, shapes, |color| {
        engine::Surface::matt(engine::Shading::SingleColor(*color))
    });
    scene
}
