//! The scene that grows from chapter to chapter, seen from aside, and one ray through it.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, Ray, render};
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, Sphere, Triangle};
use a05_lighting::{Lambert, Light, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, secondary_ray,
};
use a07_transforms::{Disc, Node, Transform};
use common::{ArgumentError, Color, Settings, Size};

use super::{Answered, path};
use crate::picture::pixels;

/// The steps from which on the scene has an object, a surface, a light or a transform. The
/// page counts them in the same order.
const SPHERE: u32 = 1;
const BOX: u32 = 2;
const TRIANGLE: u32 = 3;
const LAMBERT: u32 = 6;
const PHONG: u32 = 7;
const SPOT: u32 = 8;
const SHADOW: u32 = 9;
const MIRROR: u32 = 10;
const DEPTH: u32 = 11;
const SCALED: u32 = 12;
const TURNED: u32 = 13;
const NODE: u32 = 14;
const DISC: u32 = 15;

const EYE: Point3 = Point3::new(0.0, 1.4, 4.4);
const LAMP: Point3 = Point3::new(-0.6, 3.0, 2.4);
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

fn surface(step: u32, color: Color) -> Result<Box<dyn Surface>, ArgumentError> {
    Ok(match step {
        ..LAMBERT => Box::new(SingleColor::new(color)?),
        ..PHONG => Box::new(Lambert::new(color)?),
        ..MIRROR => Box::new(Phong::new(color, Color::gray(0.7), 64.0)?),
        _ => Box::new(Reflective::new(
            color * 0.7,
            Color::gray(0.7),
            64.0,
            Color::gray(0.3),
        )?),
    })
}

fn world(step: u32) -> Result<ShadowedWorld, ArgumentError> {
    let lamp = if step == SPOT {
        let axis = Point3::new(0.0, 0.6, 0.8) - LAMP;
        LightSource::new(SpotLight::new(Color::WHITE, LAMP, axis, 0.4)?, false)
    } else {
        LightSource::new(PointLight::new(Color::WHITE, LAMP)?, step >= SHADOW)
    };
    let mut world = ShadowedWorld::empty(Color::gray(0.1), Color::gray(0.25))?.lit_by(lamp);

    let upwards = Normal3::new(0.0, 1.0, 0.0);
    let [ball, cube] = [Point3::new(0.8, 0.5, 0.9), Point3::new(-0.8, 0.5, 0.6)];
    let half = Vector3::new(0.5, 0.5, 0.5);
    let [a, b, c] = [(-0.6, 0.0), (0.6, 0.0), (0.6, 1.5)].map(|(x, y)| Point3::new(x, y, -0.8));
    let squeeze = |t: Transform| t.scale(0.6, 1.4, 0.6);
    let turn = |t: Transform| t.rotate_y(0.6)?.rotate_z(0.5);
    let objects: [(u32, Box<dyn Geometry>, Transform, Color); 5] = [
        (
            0,
            Box::new(Plane::new(Point3::ORIGIN, upwards)?),
            Transform::IDENTITY,
            Color::gray(0.4),
        ),
        (
            SPHERE,
            Box::new(Sphere::new(ball, 0.5)?),
            about(ball, step >= SCALED, squeeze)?,
            Color::new(0.9, 0.25, 0.2),
        ),
        (
            BOX,
            Box::new(AxisAlignedBox::new(cube - half, cube + half)?),
            about(cube, step >= TURNED, turn)?,
            Color::new(0.2, 0.4, 0.9),
        ),
        (
            TRIANGLE,
            Box::new(Triangle::new(a, b, c)?),
            Transform::IDENTITY,
            Color::new(0.9, 0.7, 0.1),
        ),
        (
            DISC,
            Box::new(Disc::new(Point3::new(0.0, 0.02, 0.6), upwards, 1.8)?),
            Transform::IDENTITY,
            Color::new(0.1, 0.5, 0.3),
        ),
    ];
    let group = about(Point3::ORIGIN, step >= NODE, |t| t.rotate_y(0.35))?;
    for (from, shape, own, color) in objects {
        if step < from {
            continue;
        }
        let surface = surface(step, color)?;
        world = if step < SCALED {
            world.with(shape, surface)
        } else {
            world.with(Node::new(group).with(Node::new(own).with(shape)), surface)
        };
    }
    Ok(world)
}

/// A step of a chain about a point, once it is there.
fn about(
    point: Point3,
    is_there: bool,
    step: impl Fn(Transform) -> Result<Transform, ArgumentError>,
) -> Result<Transform, ArgumentError> {
    if !is_there {
        return Ok(Transform::IDENTITY);
    }
    let back = Point3::ORIGIN - (point - Point3::ORIGIN);
    step(Transform::IDENTITY.translate(point)?)?.translate(back)
}

/// Numbers: a point of the ray from the eye, before all objects; the angles under which the
/// scene is seen; and the step.
pub fn answer([x, y, yaw, pitch, step]: [f64; 5]) -> Answered {
    let step = step as u32;
    let world = world(step)?;
    let tracer = RecursiveTracer::new(&world);
    let depth = match step {
        ..MIRROR => 1,
        ..DEPTH => 2,
        _ => 6,
    };
    let level = libm::cos(pitch);
    let towards = Vector3::new(
        libm::sin(yaw) * level,
        libm::sin(pitch),
        libm::cos(yaw) * level,
    );
    let middle = Point3::new(0.0, 1.25, 1.6);
    let camera = OrthographicCamera::new(middle + towards * 30.0, -towards, UP, 4.0)?;
    let settings = Settings {
        size: Size::new(360, 270)?,
        ..Settings::default()
    };
    let image = render(&camera, |ray| tracer.trace(ray, depth), &settings, &())?;

    let ray = Ray::new(EYE, Point3::new(x, y, 3.2) - EYE)?;
    let list = |p: Point3| p.to_glam().to_array();
    let objects = world.objects();
    let (path, _) = path(objects, ray, depth, |surface| {
        surface.reflection() != Color::BLACK
    });
    let hits = objects
        .objects()
        .filter_map(|(shape, _)| shape.hit(&ray, Interval::AHEAD));
    let color = tracer.trace(&ray, depth);
    let answer = pixels(&image)
        .with("path", path.into_iter().flat_map(list))
        .with("hits", hits.flat_map(|hit| list(ray.at(hit.t))))
        .with("lamp", list(LAMP))
        .with("color", [color.r, color.g, color.b]);
    let Some((hit, _)) = objects.hit(&ray, Interval::AHEAD) else {
        return Ok(answer);
    };
    let point = ray.at(hit.t);
    let light = world.lights()[0].illumination(point);
    let blocked = light.and_then(|light| {
        let to_light = secondary_ray(&ray, &hit, light.direction);
        let (met, _) = objects.hit(&to_light, Interval::before(light.distance))?;
        Some(to_light.at(met.t)).filter(|_| step >= SHADOW)
    });
    let reflected = light.map(|light| point + light.direction.reflected_on(hit.normal));
    Ok(answer
        .with("t", [hit.t])
        .with("normal", list(point + Vector3::from(hit.normal)))
        .with("cosine", light.map(|light| hit.normal.dot(light.direction)))
        .with("reflected", reflected.into_iter().flat_map(list))
        .with("blocked", blocked.into_iter().flat_map(list)))
}
