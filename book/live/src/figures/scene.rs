//! The scene that grows from chapter to chapter, seen from aside, and one ray through it.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, PerspectiveCamera, View, render};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};
use a05_lighting::{Lambert, Light, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use a07_transforms::{Disc, Node, Transform, traced};
use common::steps::{Outcome, Step, StepKind};
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

    // The steps of the ray from the eye: those of a picture of one pixel.
    let camera = PerspectiveCamera::new(EYE, Point3::new(x, y, 3.2) - EYE, UP, 1.0)?;
    let one_pixel = Settings {
        size: Size::new(1, 1)?,
        depth,
        ..Settings::default()
    };
    let view = traced(View::new(camera, self::world(step)?));
    let trace = view.trace(&one_pixel, [0, 0]);
    let list = |p: Point3| p.to_glam().to_array();
    let (mut path, mut left) = (vec![list(EYE)], 1.0);
    for step in &trace.steps {
        match (step.kind, step.value("p"), step.value::<3>("cr")) {
            (StepKind::CameraRay | StepKind::ReflectedRay, ..) => path.push(point(step, 10.0)),
            (StepKind::Hit, Some(p), _) => path.splice(path.len() - 1.., [p]).for_each(drop),
            (_, _, Some([red, ..])) => left *= red,
            _ => {}
        }
    }
    let hits = tests(&trace.steps, StepKind::CameraRay).map(|(_, hit)| hit);
    let answer = pixels(&image)
        .with("path", path.into_iter().flatten())
        .with("left", [left])
        .with("hits", hits.flatten())
        .with("lamp", list(LAMP))
        .with("color", trace.color.channels());
    let hit = trace.steps.iter().find(|step| step.kind == StepKind::Hit);
    let vector = |symbol| hit?.value(symbol).map(|v| Vector3::from_glam(v.into()));
    let (Some(p), Some(normal)) = (vector("p"), vector("n")) else {
        return Ok(answer);
    };
    let point = Point3::ORIGIN + p;
    let light = world.lights()[0].illumination(point);
    let reflected = light.map(|light| point + light.direction.reflected_on(normal.as_normal()));
    let blocked =
        tests(&trace.steps, StepKind::ShadowRay).filter(|(test, _)| test.outcome == Outcome::Hit);
    Ok(answer
        .with(
            "t",
            hit.and_then(|hit| hit.value("t")).unwrap_or([f64::NAN]),
        )
        .with("normal", list(point + normal))
        .with("cosine", light.map(|light| normal.dot(light.direction)))
        .with("reflected", reflected.into_iter().flat_map(list))
        .with("blocked", blocked.flat_map(|(_, hit)| hit)))
}

/// The point of a recorded ray at a distance.
fn point(ray: &Step, t: f64) -> [f64; 3] {
    let [o, d] = ["o", "d"].map(|symbol| ray.value(symbol).unwrap_or([0.0; 3]));
    [0, 1, 2].map(|i| o[i] + t * d[i])
}

/// The tests of the objects before the first ray of a kind, with their points on it.
fn tests(steps: &[Step], kind: StepKind) -> impl Iterator<Item = (&Step, [f64; 3])> {
    let at = steps.iter().position(|step| step.kind == kind);
    let (ray, steps) = steps[at.unwrap_or(steps.len())..].split_first().unzip();
    let tests = steps.unwrap_or_default().iter();
    let tests =
        tests.take_while(|step| ![StepKind::Hit, StepKind::ReflectedLight].contains(&step.kind));
    let tests = tests.filter(|step| step.kind == StepKind::Test);
    let level = tests.clone().map(|test| test.level).min();
    tests.filter_map(move |test| {
        let [t] = test.value("t").filter(|[t]| *t > 0.0)?;
        (Some(test.level) == level).then_some((test, point(ray?, t)))
    })
}
