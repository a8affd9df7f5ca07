//! Steps of a transform; objects under one; and the scenes of this stage, with the
//! student's code in them.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Ray, render};
use a04_intersections::{Geometry, Hit, Interval};
use a05_lighting::PointLight;
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld, diagonal_camera};
use a07_transforms::{Mat4x4, Transform, stage};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

/// A step of a transform: the transform alone.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    Translate([f64; 3]),
    Scale([f64; 3]),
    RotateX(f64),
    RotateY(f64),
    RotateZ(f64),
}

impl Step {
    /// The matrix of the step.
    pub fn matrix(self) -> Mat4x4 {
        self.after(Transform::IDENTITY).matrix()
    }

    /// The matrix that undoes the step.
    pub fn inverse(self) -> Mat4x4 {
        self.after(Transform::IDENTITY).inverse()
    }

    /// A transform with this step chained to it.
    pub fn after(self, t: Transform) -> Transform {
        let chained = match self {
            Self::Translate(to) => t.translate(Point3::from_glam(to.into())),
            Self::Scale([x, y, z]) => t.scale(x, y, z),
            Self::RotateX(angle) => t.rotate_x(angle),
            Self::RotateY(angle) => t.rotate_y(angle),
            Self::RotateZ(angle) => t.rotate_z(angle),
        };
        chained.unwrap_or(t)
    }

    pub fn random(random: &mut Random) -> Self {
        let angle = random.between(-3.0, 3.0);
        match random.below(5) {
            0 => Self::Translate(random.triple(5.0)),
            1 => Self::Scale([(); 3].map(|()| random.between(0.3, 3.0))),
            2 => Self::RotateX(angle),
            3 => Self::RotateY(angle),
            _ => Self::RotateZ(angle),
        }
    }
}

pub fn point(random: &mut Random, most: f64) -> Point3 {
    Point3::from_glam(random.triple(most).into())
}

/// Three unit vectors perpendicular to each other.
pub fn frame(random: &mut Random) -> [Vector3; 3] {
    random.frame().map(|v| Vector3::from_glam(v.into()))
}

/// The unit ball under a transform: its hit at the point that belongs to the object's
/// point `n`, and the normal there, from the tangents of the surface.
pub fn on_ball(transform: &Transform, [n, side, other]: [Vector3; 3]) -> (Point3, Normal3) {
    let at = transform.matrix() * (Point3::ORIGIN + n);
    let tangents = [side, other].map(|tangent| transform.matrix() * tangent);
    let normal = tangents[0]
        .cross(tangents[1])
        .normalized()
        .unwrap_or_default();
    // Outwards: away from the image of the centre.
    let out = at - transform.matrix() * Point3::ORIGIN;
    let is_out = normal.to_glam().dot(out.to_glam()) > 0.0;
    (at, if is_out { normal } else { -normal }.as_normal())
}

type RayToObject<'a> = &'a (dyn Fn(&Ray) -> Ray + Sync);
type NormalFromObject<'a> = &'a (dyn Fn(Normal3) -> Option<Normal3> + Sync);

/// The hit of a child in its own space.
pub fn hit_of_child(
    child: &dyn Geometry,
    ray: &Ray,
    within: Interval,
    ray_to_object: RayToObject,
    normal_from_object: NormalFromObject,
) -> Option<Hit> {
    let hit = child.hit(&ray_to_object(ray), within)?;
    Some(Hit::new(hit.t, normal_from_object(hit.normal)?))
}

/// Compares a scene with its lock. Camera and world are from `src/scenes.rs`.
pub fn expect_scene(
    check: &mut Check,
    name: &str,
    eye: f64,
    world: impl FnOnce() -> Result<ShadowedWorld, ArgumentError>,
) {
    check.scene(&stage(), name, |settings| {
        let (camera, world) = (diagonal_camera(eye)?, world()?);
        let tracer = RecursiveTracer::new(&world);
        let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
        render(&camera, radiance, settings, &())
    });
}

/// A black world with a little ambient light and a lamp.
pub fn lit_from(
    light: Point3,
    casts_shadows: bool,
    ambient: f64,
) -> Result<ShadowedWorld, ArgumentError> {
    let light = PointLight::new(Color::WHITE, light)?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(ambient))?
        .lit_by(LightSource::new(light, casts_shadows)))
}

/// The lamp of the scenes with transformed objects.
pub const ABOVE: Point3 = Point3::new(1.0, 20.0, 20.0);

/// The steps of scene `box-transformations`.
pub fn steps_of_box() -> [Step; 4] {
    [
        Step::Scale([4.0, 1.0, 8.0]),
        Step::RotateZ(-20_f64.to_radians()),
        Step::RotateY(-5_f64.to_radians()),
        Step::RotateX(-30_f64.to_radians()),
    ]
}
