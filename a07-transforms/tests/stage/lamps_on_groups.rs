//! A part of a group that holds a lamp hides no other part, which blocks the lamp.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PixelRandom, Ray, View};
use a04_intersections::{Geometry, Plane, Sphere};
use a05_lighting::{Lambert, PointLight};
use a06_shadows_reflection::{LightSource, ShadowedWorld, Surface};
use a07_transforms::{Disc, Node, Transform, traced};
use common::{Color, Renderer, Settings, Size};

/// The number of rays.
const RAYS: u32 = 1_000;

/// A rotation after which no shelf is perpendicular to an axis. So rounding decides whether and
/// where a ray in the plane of a shelf meets it.
fn rotated() -> Transform {
    Transform::IDENTITY
        .rotate_x(0.3)
        .and_then(|rotated| rotated.rotate_z(0.4))
        .unwrap()
}

/// A lamp, and random points on a wall that it lights.
#[derive(Clone, Copy)]
struct Room {
    lamp: Point3,
    wall: Point3,
    normal: Normal3,
    /// How far the points are from the middle of the wall.
    extent: Vector3,
}

/// Sees a point of the wall in each pixel, against the direction of its light.
impl Camera for Room {
    fn ray_for(&self, _: Size, x: f64, _: f64) -> Ray {
        let random = PixelRandom::new(x as u64, 0, 0);
        let [x, y, z] = [0, 1, 2].map(|axis| 2.0 * random.uniform(axis) - 1.0);
        let extent = self.extent.to_glam();
        let aside = Vector3::new(x * extent.x, y * extent.y, z * extent.z);
        let point = rotated().matrix() * (self.wall + aside);
        let to_lamp = rotated().matrix() * self.lamp - point;
        let direction = to_lamp.normalized().unwrap();
        Ray::new(point + direction * 0.5, -direction).unwrap()
    }
}

impl Room {
    /// The number of points that the light does not reach past these objects.
    fn dark(self, renderer: Renderer, objects: Vec<Box<dyn Geometry>>) -> usize {
        let white = || -> Box<dyn Surface> { Box::new(Lambert::new(Color::WHITE).unwrap()) };
        let wall = Plane::new(self.wall, self.normal).unwrap();
        let mut world = ShadowedWorld::empty(Color::WHITE, Color::BLACK)
            .unwrap()
            .with(Node::new(rotated()).with(wall), white());
        for object in objects {
            world = world.with(object, white());
        }
        let lamp = PointLight::new(Color::WHITE, rotated().matrix() * self.lamp).unwrap();
        let world = world.lit_by(LightSource::new(lamp, true));
        let settings = Settings {
            size: Size::new(RAYS, 1).unwrap(),
            renderer,
            ..Settings::default()
        };
        let view = traced(View::new(self, world));
        let image = view.render(&settings, &()).unwrap();
        let pixels = image.pixels().iter();
        pixels.filter(|color| **color == Color::BLACK).count()
    }
}

fn disc(y: f64, radius: f64) -> Disc {
    Disc::new(
        Point3::new(0.0, y, 0.0),
        Normal3::new(0.0, 1.0, 0.0),
        radius,
    )
    .unwrap()
}

/// All rays to the lamp lie in the plane of the shelf, and pass through the ball behind it.
#[test]
fn a_shelf_hides_no_ball_behind_it() {
    let room = Room {
        lamp: Point3::new(5.0, 0.0, 0.0),
        wall: Point3::new(-3.0, 0.0, 0.0),
        normal: Normal3::new(1.0, 0.0, 0.0),
        extent: Vector3::new(0.0, 0.0, 0.5),
    };
    // Near the lamp: farther from it, every hit blocks.
    let center = Point3::new(4.6, 0.0, 0.0);
    let shelf = || Disc::new(center, Normal3::new(0.0, 1.0, 0.0), 0.05).unwrap();
    let ball = || Sphere::new(Point3::new(4.8, 0.0, 0.0), 0.1).unwrap();
    let node = || Node::new(rotated());
    let inner = || Node::new(Transform::IDENTITY).with(shelf()).with(ball());
    // So flat that the engine calls the functions of the node.
    let flat = |transform: Transform| {
        let transform = transform.scale(1.0, 1e-8, 1.0).unwrap();
        Node::new(transform).with(shelf()).with(ball())
    };
    for renderer in Renderer::ALL {
        let groups: [Vec<Box<dyn Geometry>>; 5] = [
            vec![
                Box::new(node().with(shelf())),
                Box::new(node().with(ball())),
            ],
            vec![Box::new(node().with(shelf()).with(ball()))],
            vec![Box::new(node().with(inner()))],
            vec![Box::new(flat(rotated()))],
            vec![Box::new(node().with(flat(Transform::IDENTITY)))],
        ];
        for (i, group) in groups.into_iter().enumerate() {
            let dark = room.dark(renderer, group);
            assert_eq!(dark, RAYS as usize, "{renderer:?}, group {i}");
        }
        assert_eq!(room.dark(renderer, vec![]), 0);
    }
}

/// Below a lamp on a ceiling hangs a lid. Both ends of a ray are rounded by 64 epsilons of its
/// largest number, which is below 9 here: so a gap of 128 times 9 epsilons blocks the light.
#[test]
fn a_lid_just_below_a_lamp_blocks_it() {
    let room = Room {
        lamp: Point3::new(0.0, 5.0, 0.0),
        wall: Point3::ORIGIN,
        normal: Normal3::new(0.0, 1.0, 0.0),
        extent: Vector3::new(4.0, 0.0, 4.0),
    };
    for renderer in Renderer::ALL {
        let group = |gap: f64| {
            let ceiling = disc(5.0, 10.0);
            Node::new(rotated())
                .with(ceiling)
                .with(disc(5.0 - gap, 1.0))
        };
        let dark = |gap: f64| room.dark(renderer, vec![Box::new(group(gap))]);
        assert_eq!(dark(128.0 * 9.0 * f64::EPSILON), RAYS as usize);
        assert_eq!(dark(0.0), 0);
    }
}
