//! A ball of triangles as a mirror.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, View};
use a04_intersections::Triangle;
use a04_lab::mesh::Mesh;
use a06_shadows_reflection::{Reflective, ShadowedWorld, traced};
use common::{Color, Renderer, Settings, Size};

const WHITE: Color = Color::WHITE;

/// Under an even sky a convex mirror shows the sky everywhere, reflected once: also where a smooth
/// triangle's normal leans so much that the ray would go into the triangle.
#[test]
fn a_smooth_ball_mirrors_an_even_sky_once_everywhere() {
    let ball = |divisions| {
        let mesh = Mesh::icosphere(divisions);
        let mut world = ShadowedWorld::empty(WHITE, Color::BLACK).unwrap();
        for face in &mesh.faces {
            let vectors = face.map(|corner| mesh.corners[corner]);
            let [a, b, c] = vectors.map(|vector| Point3::ORIGIN + vector);
            let triangle = Triangle::new(a, b, c).unwrap();
            let triangle = triangle
                .with_normals(vectors.map(Vector3::as_normal))
                .unwrap();
            let mirror = Reflective::new(Color::BLACK, Color::BLACK, 1.0, Color::gray(0.5));
            world = world.with(triangle, Box::new(mirror.unwrap()));
        }
        world
    };
    for divisions in [0, 1, 2, 3] {
        let eye = Point3::new(1.5, 1.0, 4.0);
        let gaze = Point3::ORIGIN - eye;
        let up = Vector3::new(0.0, 1.0, 0.0);
        let mut pictures = Vec::new();
        for renderer in Renderer::ALL {
            let camera = PerspectiveCamera::new(eye, gaze, up, 0.52).unwrap();
            let settings = Settings {
                size: Size::new(90, 90).unwrap(),
                renderer,
                ..Settings::default()
            };
            let view = traced(View::new(camera, ball(divisions)));
            pictures.push(view.render(&settings, &()).unwrap());
        }
        let mut count = 0;
        for color in pictures[0].rows().flatten() {
            assert!([WHITE, Color::gray(0.5)].contains(color), "{color:?}");
            count += u32::from(*color != WHITE);
        }
        assert!(count > 2000, "{count} pixels of the ball");
        assert!(pictures.iter().all(|picture| *picture == pictures[0]));
    }
}
