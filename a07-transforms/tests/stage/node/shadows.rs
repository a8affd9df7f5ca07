//! Shadows on transformed shapes.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Interval};
use a05_lighting::{Lambert, PointLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld};
use a07_transforms::Node;
use approx::assert_abs_diff_eq;
use common::Color;

use super::{translated, unit_sphere};

/// Lit from outside, no place of a stretched and turned shape shades itself.
/// Tolerance: the cosine is calculated twice.
#[test]
fn transformed_shapes_do_not_shade_themselves() {
    for s in [1e-6, 1.0, 1e9] {
        let transform = translated(3.0 * s, -2.0 * s, 5.0 * s)
            .rotate_x(0.4)
            .and_then(|transform| transform.rotate_z(-0.7))
            .and_then(|transform| transform.scale(3.0 * s, 0.6 * s, 2.0 * s))
            .unwrap();
        let middle = transform.matrix() * Point3::ORIGIN;
        let light = middle + Vector3::new(1.0, 8.0, 3.0) * s;
        let cube = AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
        for node in [
            Node::new(transform).with(unit_sphere()),
            Node::new(transform).with(cube.unwrap()),
        ] {
            let white = Lambert::new(Color::WHITE).unwrap();
            let lamp = PointLight::new(Color::WHITE, light).unwrap();
            let world = ShadowedWorld::empty(Color::BLACK, Color::BLACK)
                .unwrap()
                .with(node, Box::new(white))
                .lit_by(LightSource::new(lamp, true));
            let tracer = RecursiveTracer::new(&world);
            let mut lit = 0;
            for n in 0..8000 {
                let random = PixelRandom::new(18, n, 0);
                let aim = [0, 1, 2].map(|i| (4.0 * random.uniform(i) - 2.0) * s);
                let eye = middle + Vector3::new(-6.0, 5.0, -4.0) * s;
                let aim = middle + Vector3::from_glam(aim.into());
                let ray = Ray::new(eye, aim - eye).unwrap();
                let Some((found, _)) = world.objects().hit(&ray, Interval::AHEAD) else {
                    continue;
                };
                let l = (light - ray.at(found.t)).normalized().unwrap();
                let n_l = found.normal.dot(l);
                if n_l > 1e-3 {
                    assert_abs_diff_eq!(tracer.trace(&ray, 1).r, n_l, epsilon = 4.0 * f64::EPSILON);
                    lit += 1;
                }
            }
            assert!(lit > 300, "{lit} places are tested");
        }
    }
}
