//! Transforms in the wrong order, normals moved like vectors, and the last hit.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Sphere, World};
use a07_transforms::protocol::{self, Chained};
use a07_transforms::{Node, Transform};
use common::{ArgumentError, Color, Error, Scene};

use super::formula::Formula;
use super::{beside, shade, traced};

type Made<T> = Result<T, ArgumentError>;

/// A shape of one colour in light from above and from the left.
fn view(eye: f64, shape: impl Geometry) -> Result<View, Error> {
    let world = World::new(Color::BLACK)?.with(shape, Color::YELLOW);
    let (e, g) = (Point3::new(eye, eye, eye), Vector3::new(-1.0, -1.0, -1.0));
    let camera = PerspectiveCamera::new(e, g, Vector3::new(0.0, 1.0, 0.0), FRAC_PI_4)?;
    let light = Vector3::new(1.0, 20.0, 20.0).unit("light")?;
    Ok(traced(camera, move |ray| {
        let hit = world.hit(ray, Interval::AHEAD);
        hit.map_or(Color::BLACK, |(hit, color)| {
            shade(*color, hit.normal.dot(light))
        })
    }))
}

fn unit_box() -> Made<AxisAlignedBox> {
    AxisAlignedBox::new(Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5))
}

/// The steps of the stage's box, outermost first.
const STEPS: [fn(Transform) -> Made<Transform>; 4] = [
    |transform| transform.scale(4.0, 1.0, 8.0),
    |transform| transform.rotate_z(-20_f64.to_radians()),
    |transform| transform.rotate_y(-5_f64.to_radians()),
    |transform| transform.rotate_x(-30_f64.to_radians()),
];

pub fn order() -> Scene {
    beside(
        "transform",
        "the inverses multiplied in the order of the matrices, and in the opposite one",
        |_| {
            let mut chain = Chained::IDENTITY;
            for step in STEPS {
                chain = chain.then(&step(Transform::IDENTITY)?);
            }
            let cube = unit_box()?;
            let shape = Formula(move |ray: &Ray, within| {
                let object_ray = Ray::derived(chain.i * ray.origin(), chain.i * ray.direction());
                let hit = cube.hit(&object_ray, within)?;
                let normal = protocol::unnormalized_normal(chain.i, hit.normal).normalized()?;
                Some(Hit::new(hit.t, normal.as_normal()))
            });
            view(10.0, shape)
        },
        |_| {
            let transform = STEPS
                .iter()
                .try_fold(Transform::IDENTITY, |chain, step| step(chain))?;
            view(10.0, Node::new(transform).with(unit_box()?))
        },
    )
}

fn ellipsoid() -> Made<(Transform, Sphere)> {
    let transform = Transform::IDENTITY.scale(6.0, 1.2, 4.0)?;
    Ok((transform, Sphere::new(Point3::ORIGIN, 1.0)?))
}

pub fn normals() -> Scene {
    beside(
        "normal",
        "a normal multiplied by the transposed matrix, and by the transposed inverse",
        |_| {
            let (transform, ball) = ellipsoid()?;
            let shape = Formula(move |ray: &Ray, within| {
                let hit = ball.hit(&transform.ray_to_object(ray), within)?;
                let face = transform.normal_from_object(hit.face)?;
                let normal = protocol::transposed_normal(transform.matrix(), hit.normal)?;
                Some(Hit {
                    normal,
                    face,
                    ..hit
                })
            });
            view(12.0, shape)
        },
        |_| {
            let (transform, ball) = ellipsoid()?;
            view(12.0, Node::new(transform).with(ball))
        },
    )
}

/// A ball, and behind it a box.
fn ball() -> Made<Sphere> {
    Sphere::new(Point3::new(0.9, 0.9, 0.7), 0.3)
}

pub fn last_wins() -> Scene {
    beside(
        "node",
        "a ball before a box: the last hit of the list, and the nearest",
        |_| {
            let children: Vec<Box<dyn Geometry>> = vec![Box::new(ball()?), Box::new(unit_box()?)];
            let last_hit = move |ray: &Ray, _: Interval| protocol::last_hit(&children, ray);
            view(2.2, Formula(last_hit))
        },
        |_| {
            let node = Node::new(Transform::IDENTITY);
            view(2.2, node.with(ball()?).with(unit_box()?))
        },
    )
}
