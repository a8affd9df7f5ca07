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

use super::{Answered, gaze};
use crate::picture::pixels;

/// The steps from which on the scene has an object, a surface, a light or a transform; the
/// page counts them in the same order, and the first four have an object each.
const LAMBERT: u32 = 6;
const PHONG: u32 = 7;
const SPOT: u32 = 8;
const SHADOW: u32 = 9;
const MIRROR: u32 = 10;
const SCALED: u32 = 12;
const TURNED: u32 = 13;
const NODE: u32 = 14;
const DISC: u32 = 15;

const EYE: Point3 = Point3::new(0.0, 1.4, 4.4);
const LAMP: Point3 = Point3::new(-0.6, 3.0, 2.4);
const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

fn surface(step: u32, color: Color) -> Result<Box<dyn Surface>, ArgumentError> {
    let shine = Color::gray(0.7);
    Ok(match step {
        ..LAMBERT => Box::new(SingleColor::new(color)?),
        LAMBERT..PHONG => Box::new(Lambert::new(color)?),
        PHONG..MIRROR => Box::new(Phong::new(color, shine, 64.0)?),
        _ => Box::new(Reflective::new(color * 0.7, shine, 64.0, Color::gray(0.3))?),
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

    let (o, upwards) = (Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0));
    let [ball, cube] = [Vector3::new(0.8, 0.5, 0.9), Vector3::new(-0.8, 0.5, 0.6)];
    let half = Vector3::new(0.5, 0.5, 0.5);
    let [a, b, c] = [(-0.6, 0.0), (0.6, 0.0), (0.6, 1.5)].map(|(x, y)| Point3::new(x, y, -0.8));
    let shapes: [Box<dyn Geometry>; 5] = [
        Box::new(Plane::new(o, upwards)?),
        Box::new(Sphere::new(o + ball, 0.5)?),
        Box::new(AxisAlignedBox::new(o + cube - half, o + cube + half)?),
        Box::new(Triangle::new(a, b, c)?),
        Box::new(Disc::new(Point3::new(0.0, 0.02, 0.6), upwards, 1.8)?),
    ];
    let colors = [0x66_6666, 0xe6_4033, 0x33_66e6, 0xe6_b31a, 0x1a_804d];
    let turned = if step < NODE { 0.0 } else { 0.35 };
    let group = Transform::IDENTITY.rotate_y(turned)?;
    // A transform about a centre.
    let about = |centre: Vector3, step: fn(Transform) -> Result<Transform, ArgumentError>| {
        step(Transform::IDENTITY.translate(o + centre)?)?.translate(o - centre)
    };
    for (index, (shape, color)) in (0..).zip(shapes.into_iter().zip(colors)) {
        if step < index || (index == 4 && step < DISC) {
            break;
        }
        let surface = surface(step, Color::from_packed(color))?;
        let own = match index {
            1 => about(ball, |t| t.scale(0.6, 1.4, 0.6))?,
            2 if step >= TURNED => about(cube, |t| t.rotate_y(0.6)?.rotate_z(0.5))?,
            _ => Transform::IDENTITY,
        };
        world = match step {
            ..SCALED => world.with(shape, surface),
            _ => world.with(Node::new(group).with(Node::new(own).with(shape)), surface),
        };
    }
    Ok(world)
}

/// Numbers: a point of the ray from the eye, before all objects; the surfaces that a ray may
/// hit from the step after `MIRROR` on; the divisor of the picture's size; the angles under
/// which the scene is seen; the step.
pub fn answer([x, y, depth, coarse, yaw, pitch, step]: [f64; 7]) -> Answered {
    let step = step as u32;
    let world = world(step)?;
    let tracer = RecursiveTracer::new(&world);
    let depth = match step {
        ..MIRROR => 1,
        MIRROR => 2,
        _ => depth as u32,
    };
    let (middle, gaze) = (Point3::new(0.0, 1.25, 1.6), gaze(yaw, -pitch));
    let camera = OrthographicCamera::new(middle - gaze * 30.0, gaze, UP, 4.0)?;
    let settings = Settings {
        size: Size::new((360.0 / coarse) as u32, (270.0 / coarse) as u32)?,
        ..Settings::default()
    };
    let image = render(&camera, |ray| tracer.trace(ray, depth), &settings, &())?;

    let first = Ray::new(EYE, Point3::new(x, y, 3.2) - EYE)?;
    let list = |p: Point3| p.to_glam().to_array();
    let objects = world.objects();
    let (mut ray, mut path, mut left) = (first, vec![EYE], 1.0);
    for _ in 0..depth {
        let met = objects.hit(&ray, Interval::AHEAD);
        path.push(ray.at(met.map_or(10.0, |(hit, _)| hit.t)));
        let Some((hit, surface)) = met.filter(|_| step >= MIRROR) else {
            break;
        };
        left *= surface.reflection().r;
        ray = secondary_ray(&ray, &hit, (-ray.direction()).reflected_on(hit.normal));
    }
    let each = objects.objects();
    let hits = each.filter_map(|(shape, _)| shape.hit(&first, Interval::AHEAD));
    let color = tracer.trace(&first, depth);
    let answer = pixels(&image)
        .with("path", path.into_iter().flat_map(list))
        .with("left", [left])
        .with("hits", hits.flat_map(|hit| list(first.at(hit.t))))
        .with("lamp", list(LAMP))
        .with("color", [color.r, color.g, color.b]);
    let Some((hit, _)) = objects.hit(&first, Interval::AHEAD) else {
        return Ok(answer);
    };
    let point = first.at(hit.t);
    let light = world.lights()[0].illumination(point);
    let blocked = light.and_then(|light| {
        let to_light = secondary_ray(&first, &hit, light.direction);
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
