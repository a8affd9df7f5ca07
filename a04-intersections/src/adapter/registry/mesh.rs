//! `Mesh`: the triangles of a mesh file, as one geometry that has one surface.

use a03_rays_cameras::Ray;
use scene_file::{Data, Error, Item};

use super::{Content, ShapeKind, triangle};
use crate::{Geometry, Hit, Interval, Triangle};

/// The triangles of a mesh.
#[derive(Debug)]
pub struct Mesh(Vec<Triangle>);

/// The nearest hit of its triangles.
impl Geometry for Mesh {
    fn hit(&self, ray: &Ray, mut within: Interval) -> Option<Hit> {
        let mut nearest = None;
        for triangle in &self.0 {
            if let Some(hit) = triangle.hit(ray, within) {
                within.max = hit.t;
                nearest = Some(hit);
            }
        }
        nearest
    }

    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        let mut triangles = self.0.iter();
        triangles.any(|triangle| triangle.any_hit(ray, within, counts))
    }
}

impl ShapeKind for Mesh {
    /// The triangles that have an area.
    fn read(item: &Item, _: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        let Some(Data::Mesh(mesh)) = item.find("file") else {
            return Err(item.lacks("file"));
        };
        let triangles = mesh.triangles();
        let with_area = triangles.filter_map(|(corners, normals)| triangle(corners, normals).ok());
        let with_area = with_area.collect::<Vec<_>>();
        if with_area.is_empty() {
            return Err(item.error("file", "none of the faces has an area"));
        }
        Ok(Self(with_area))
    }

    fn content(&self) -> Content<'_> {
        Content::Children {
            shapes: self.0.iter().map(|triangle| triangle as _).collect(),
            transform: None,
        }
    }

    fn tests(&self) -> u64 {
        self.0.len() as u64
    }
}
