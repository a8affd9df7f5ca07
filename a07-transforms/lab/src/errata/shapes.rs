//! A box that loses its faces, a sphere that is far away, transforms in the wrong order,
//! normals moved like vectors, and the last hit.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Sphere};
use a04_lab::formula::sphere::SphereQuery;
use a04_lab::line::Line;
use a04_lab::protocol::{self, Compared};
use a07_transforms::{Node, Transform};
use common::{Color, Error, Scene};

use super::{Made, beside, camera, shade, traced};
use crate::protocol::{Chained, last_hit, transposed_normal, unnormalized_normal};

const LBF: Point3 = Point3::new(0.1, 0.2, 0.3);
const RUN: Point3 = Point3::new(0.7, 1.1, 0.9);

pub fn box_faces() -> Scene {
    beside(
        "box-faces",
        "a point on a face, all three coordinates of it compared; and slabs",
        |_| cube(|ray| protocol::axis_aligned_box(LBF, RUN, ray, Compared::Three)),
        |_| {
            let aab = AxisAlignedBox::new(LBF, RUN)?;
            cube(move |ray| Some(aab.hit(ray, Interval::AHEAD)?.t))
        },
    )
}

/// The box, darker where it is farther away.
fn cube(t: impl Fn(&Ray) -> Option<f64> + Send + Sync + 'static) -> Result<View, Error> {
    let camera = camera(
        Point3::new(5.7, 5.2, 7.3),
        Point3::new(0.4, 0.65, 0.6),
        0.15,
    )?;
    Ok(traced(camera, move |ray| {
        t(ray).map_or(Color::BLACK, |t| {
            Color::new(0.3, 0.5, 1.0) * ((10.8 - t) / 2.2).clamp(0.0, 1.0)
        })
    }))
}

/// A shape of one colour in light from one direction, by the function of its hits.
fn matt(
    camera: PerspectiveCamera,
    color: Color,
    light: Vector3,
    hit: impl Fn(&Ray) -> Option<Hit> + Send + Sync + 'static,
) -> View {
    traced(camera, move |ray| {
        hit(ray).map_or(Color::BLACK, |hit| shade(color, hit.normal.dot(light)))
    })
}

pub fn far_sphere() -> Scene {
    beside(
        "far-sphere",
        "radius 1 from 37 million away: b² - 4ac, and the distance of the ray",
        |_| {
            far_away(|ray| {
                let t = protocol::sphere(&SphereQuery {
                    center: [0.0; 3],
                    radius: 1.0,
                    line: Line::of(ray),
                })?;
                let normal = (ray.at(t) - Point3::ORIGIN).normalized()?;
                Some(Hit::new(t, normal.as_normal()))
            })
        },
        |_| {
            let sphere = Sphere::new(Point3::ORIGIN, 1.0)?;
            far_away(move |ray| sphere.hit(ray, Interval::AHEAD))
        },
    )
}

fn far_away(hit: impl Fn(&Ray) -> Option<Hit> + Send + Sync + 'static) -> Result<View, Error> {
    let camera = camera(Point3::new(1e7, 2e7, 3e7), Point3::ORIGIN, 2.4 / 3.74e7)?;
    let light = Vector3::new(0.48, 0.6, 0.64);
    Ok(matt(camera, Color::RED, light, hit))
}

/// A shape in light from above and from the left.
fn view(
    eye: f64,
    hit: impl Fn(&Ray) -> Option<Hit> + Send + Sync + 'static,
) -> Result<View, Error> {
    let [eye, to] = [eye, eye - 1.0].map(|x| Point3::new(x, x, x));
    let camera = camera(eye, to, FRAC_PI_4)?;
    let light = Vector3::new(1.0, 20.0, 20.0).unit("light")?;
    Ok(matt(camera, Color::YELLOW, light, hit))
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
            view(10.0, move |ray| {
                let object_ray = Ray::derived(chain.i * ray.origin(), chain.i * ray.direction());
                let hit = cube.hit(&object_ray, Interval::AHEAD)?;
                let normal = unnormalized_normal(chain.i, hit.normal).normalized()?;
                let is_turned = normal.dot(ray.direction()) > 0.0;
                let to_eye = if is_turned { -normal } else { normal };
                Some(Hit::new(hit.t, to_eye.as_normal()))
            })
        },
        |_| {
            let mut steps = STEPS.iter();
            let transform = steps.try_fold(Transform::IDENTITY, |chain, step| step(chain))?;
            let node = Node::new(transform).with(unit_box()?);
            view(10.0, move |ray| node.hit(ray, Interval::AHEAD))
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
            view(12.0, move |ray| {
                let hit = ball.hit(&transform.ray_to_object(ray), Interval::AHEAD)?;
                let normal = transposed_normal(transform.matrix(), hit.normal)?;
                Some(Hit::new(hit.t, normal))
            })
        },
        |_| {
            let (transform, ball) = ellipsoid()?;
            let node = Node::new(transform).with(ball);
            view(12.0, move |ray| node.hit(ray, Interval::AHEAD))
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
            view(2.2, move |ray| last_hit(&children, ray))
        },
        |_| {
            let node = Node::new(Transform::IDENTITY).with(ball()?);
            let node = node.with(unit_box()?);
            view(2.2, move |ray| node.hit(ray, Interval::AHEAD))
        },
    )
}
