//! Reads scenes from files: shapes, meshes and the world.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::from_file::camera;
use a03_rays_cameras::{Ray, View};
use common::{ArgumentError, Color};
use scene_file::{Data, Error, Item, SceneFile};

use crate::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};

/// The camera and the world of a file.
pub fn view(file: &SceneFile) -> Result<View, Error> {
    let item = &file.world;
    let mut world = item.check(World::new(item.color("background")))?;
    add_objects(&mut world, file, geometry, |item| {
        item.vector("color", Color::new)
    })?;
    let camera = camera(file)?;
    Ok(View { camera, world }.boxed())
}

/// Adds the shapes of a file to a world, with their surfaces.
pub fn add_objects<S>(
    world: &mut World<S>,
    file: &SceneFile,
    geometry: fn(&Item) -> Result<Box<dyn Geometry>, Error>,
    surface: impl Fn(&Item) -> Result<S, Error>,
) -> Result<(), Error> {
    for item in &file.shapes {
        world.objects.push((geometry(item)?, surface(item)?));
    }
    Ok(())
}

/// A shape of this stage.
pub fn geometry(item: &Item) -> Result<Box<dyn Geometry>, Error> {
    let point = |key| item.vector(key, Point3::new);
    Ok(match item.kind.name {
        "sphere" => Box::new(item.check(Sphere::new(point("center")?, item.number("radius")?))?),
        "plane" => {
            let normal = item.vector("normal", Vector3::new)?.as_normal();
            Box::new(item.check(Plane::new(point("point")?, normal))?)
        }
        "box" => Box::new(item.check(AxisAlignedBox::new(point("lbf")?, point("run")?))?),
        "mesh" => Box::new(mesh(item)?),
        _ => {
            let corners = item.rows("corners")?;
            Box::new(item.check(triangle(corners, item.find_rows("normals")))?)
        }
    })
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

/// The triangles that have an area.
fn mesh(item: &Item) -> Result<Mesh, Error> {
    let Some(Data::Mesh(mesh)) = item.find("file") else {
        return Err(item.lacks("file"));
    };
    let mut triangles = item.check(World::new(Color::BLACK))?;
    for (corners, normals) in mesh.triangles() {
        if let Ok(triangle) = triangle(corners, normals) {
            triangles.objects.push((Box::new(triangle), ()));
        }
    }
    Ok(Mesh(triangles))
}

/// The triangles of a mesh: one geometry, so that they share a surface.
#[derive(Debug)]
pub(crate) struct Mesh(pub World<()>);

/// The nearest hit of its triangles.
impl Geometry for Mesh {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.hit(ray, within).map(|(hit, ())| hit)
    }
}
