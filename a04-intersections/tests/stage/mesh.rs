//! A mesh of a scene file searches all of its triangles.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::registry::{Mesh, ShapeKind};
use a04_intersections::{Geometry, Interval};
use scene_file::SceneFile;

/// Of two triangles, one behind the other, either may be the hit that counts.
#[test]
fn a_triangle_whose_hit_does_not_count_hides_no_other_one() {
    let obj = "v -1 -1 -1\nv 1 -1 -1\nv 0 1 -1\nv -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nf 1 2 3\nf 4 5 6";
    let text = "[camera]\neye = [0, 0, 0]\ngaze = [0, 0, -1]\nangle = 40\n\
                [[mesh]]\nfile = \"two.obj\"\ncolor = \"red\"";
    let read = |_: &str| scene_file::Mesh::read(obj.as_bytes());
    let file = SceneFile::read(text, 4, &read).unwrap();
    let mesh = Mesh::read(&file.shapes[0], Vec::new()).unwrap();
    let ray = Ray::new(Point3::ORIGIN, Vector3::new(0.0, 0.0, -1.0)).unwrap();
    let hits_beyond = |t| mesh.any_hit(&ray, Interval::AHEAD, &|hit| hit.t > t);
    assert!(hits_beyond(0.0) && hits_beyond(1.5) && !hits_beyond(2.5));
}
