//! `Mesh`: the triangles of a mesh file, as one geometry that has one surface.

use a03_rays_cameras::Ray;
use common::Color;
use scene_file::{Data, Error, Item};

use super::{Content, ShapeKind, triangle};
use crate::{Geometry, Hit, Interval, World};

/// The triangles of a mesh.
#[derive(Debug)]
pub struct Mesh(World<()>);

/// The nearest hit of its triangles.
impl Geometry for Mesh {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within).map(|(hit, ())| hit)
    }

    /// Tests all triangles, so that their number is the work of a ray.
    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        let mut found = false;
        for (triangle, ()) in self.0.objects() {
            found |= triangle.any_hit(ray, within, counts);
        }
        found
    }
}

impl ShapeKind for Mesh {
    /// The triangles that have an area.
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let Some(Data::Mesh(mesh)) = item.find("file") else {
            return Err(item.lacks("file"));
        };
        let mut triangles = item.check(World::new(Color::BLACK))?;
        for (corners, normals) in mesh.triangles() {
            if let Ok(triangle) = triangle(corners, normals) {
                triangles.objects.push((Box::new(triangle), ()));
            }
        }
        Ok(Self(triangles))
    }

    fn content(&self) -> Content<'_> {
        Content::Children {
            shapes: self.0.objects().map(|(triangle, ())| triangle).collect(),
            transform: None,
        }
    }

    fn tests(&self) -> u64 {
        self.0.objects.len() as u64
    }
}
