//! A closed mesh, and rays from inside that aim at its corners and edges: a ray that gets out has
//! passed between triangles.

use a02_math::Point3;
use a03_rays_cameras::Ray;
use common::Error;

use crate::mesh::Mesh;
use crate::support::{Numbers, corners};
use a04_intersections::Triangle;

/// Where rays aim.
#[derive(Clone, Copy, Debug)]
pub enum Aim {
    Corners,
    Edges,
    Anywhere,
}

impl Aim {
    /// The position on an edge, from 0 at its first corner to 1 at its second one; none for a ray
    /// in any direction.
    fn on_edge(self, numbers: &mut Numbers) -> Option<f64> {
        match self {
            Self::Corners => Some(0.0),
            Self::Edges => Some(numbers.between(0.0, 1.0)),
            Self::Anywhere => None,
        }
    }

    pub const fn words(self) -> &'static str {
        match self {
            Self::Corners => "at corners",
            Self::Edges => "at edges",
            Self::Anywhere => "anywhere, which proves nothing",
        }
    }
}

/// A closed surface around a middle, from where all its triangles are visible.
pub struct ClosedMesh {
    middle: Point3,
    pub triangles: Vec<Triangle>,
}

impl ClosedMesh {
    /// 320 triangles, whose corners are 1 to 2 away from the middle, so that all are different.
    pub fn around(middle: Point3) -> Result<Self, Error> {
        let mesh = Mesh::icosphere(2);
        let mut triangles = Vec::new();
        for face in &mesh.faces {
            let [a, b, c] = face.map(|corner| {
                let height = Numbers::new(51, corner).between(1.0, 2.0);
                middle + mesh.corners[corner] * height
            });
            triangles.push(Triangle::new(a, b, c)?);
        }
        Ok(Self { middle, triangles })
    }

    /// The `n`-th ray from near the middle.
    pub fn ray(&self, aim: Aim, n: usize) -> Result<Ray, Error> {
        let mut numbers = Numbers::new(52, n);
        let eye = self.middle + numbers.triple(-0.1, 0.1);
        let face = corners(&self.triangles[numbers.below(self.triangles.len())]);
        let side = numbers.below(3);
        let (from, to) = (face[side], face[(side + 1) % 3]);
        let direction = match aim.on_edge(&mut numbers) {
            Some(fraction) => from + (to - from) * fraction - eye,
            None => numbers.direction(),
        };
        Ok(Ray::new(eye, direction)?)
    }
}
