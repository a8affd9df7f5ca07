//! The scenes of this stage, with the student's code in them.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{Ray, render};
use a04_intersections::{AxisAlignedBox, Hit, Interval, Plane, Sphere, World};
use a05_lighting::{Illumination, Lambert, Light, Lighting, PointLight};
use a06_shadows_reflection::{
    LightSource, Reflective, ShadowedWorld, Surface, diagonal_camera, is_shadowed, secondary_ray,
    stage,
};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

pub type Objects = World<Box<dyn Surface>>;
type IsShadowed<'a> = &'a (dyn Fn(&Objects, &Ray, &Hit, &Illumination) -> bool + Sync);
type Leaving<'a> = &'a (dyn Fn(&Ray, &Hit, Vector3) -> Ray + Sync);

/// Computes colours by their definition, with these functions in the place of the
/// lesson's.
#[derive(Clone, Copy)]
pub struct Tracer<'a> {
    pub world: &'a ShadowedWorld,
    pub is_shadowed: IsShadowed<'a>,
    pub leaving: Leaving<'a>,
}

impl<'a> Tracer<'a> {
    pub fn new(world: &'a ShadowedWorld) -> Self {
        Self {
            world,
            is_shadowed: &is_shadowed,
            leaving: &secondary_ray,
        }
    }

    /// `c + cr f`, with the colour `f` that the reflected ray brings back.
    pub fn trace(&self, ray: &Ray, depth: u32) -> Color {
        if depth == 0 {
            return Color::BLACK;
        }
        let Some((hit, surface)) = self.world.objects().hit(ray, Interval::AHEAD) else {
            return self.world.objects().background();
        };
        let mut color = surface.color_for(ray, &hit, self);
        if surface.reflection() != Color::BLACK {
            let direction = (-ray.direction()).reflected_on(hit.normal);
            let mirrored = self.trace(&(self.leaving)(ray, &hit, direction), depth - 1);
            color += surface.reflection() * mirrored;
        }
        color
    }
}

impl Lighting for Tracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        for light in self
            .world
            .lights()
            .iter()
            .filter_map(|light| light.illumination(point))
        {
            let is_in_front = hit.normal.dot(light.direction) > 0.0;
            if is_in_front && !(self.is_shadowed)(self.world.objects(), ray, hit, &light) {
                shade(&light);
            }
        }
    }
}

/// Compares a scene with its lock. Camera and world are from `src/scenes.rs`.
pub fn expect_scene(
    check: &mut Check,
    name: &str,
    world: fn() -> Result<ShadowedWorld, ArgumentError>,
    trace: impl Fn(&ShadowedWorld, &Ray, u32) -> Color + Sync,
) {
    check.scene(&stage(), name, |settings| {
        let (camera, world) = (diagonal_camera(8.0)?, world()?);
        let radiance = |ray: &Ray| trace(&world, ray, settings.depth);
        render(&camera, radiance, settings, &())
    });
}

fn lit_floor(light: Point3, floor: Box<dyn Surface>) -> Result<ShadowedWorld, ArgumentError> {
    let light = PointLight::new(Color::WHITE, light)?;
    let plane = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(plane, floor)
        .lit_by(LightSource::new(light, true)))
}

/// A box and its shadow.
pub fn aab() -> Result<ShadowedWorld, ArgumentError> {
    let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
    let floor = Box::new(Lambert::new(Color::gray(0.8))?);
    Ok(lit_floor(Point3::new(8.0, 8.0, 0.0), floor)?.with(
        AxisAlignedBox::new(lbf, run)?,
        Box::new(Lambert::new(Color::RED)?),
    ))
}

/// Three mirroring spheres on a mirror.
pub fn sphere() -> Result<ShadowedWorld, ArgumentError> {
    let half = Color::gray(0.5);
    let mirror = Reflective::new(Color::gray(0.1), Color::BLACK, 64.0, half)?;
    let mut world = lit_floor(Point3::new(8.0, 8.0, 8.0), Box::new(mirror))?;
    for (x, color) in [(-3.0, Color::RED), (0.0, Color::GREEN), (3.0, Color::BLUE)] {
        let sphere = Sphere::new(Point3::new(x, 1.0, 0.0), 1.0)?;
        world = world.with(
            sphere,
            Box::new(Reflective::new(color, Color::WHITE, 64.0, half)?),
        );
    }
    Ok(world)
}

/// A point of hundredths.
pub fn point(random: &mut Random, most: f64) -> Point3 {
    Point3::from_glam(random.triple(most).into())
}

/// Three unit vectors perpendicular to each other.
pub fn frame(random: &mut Random) -> [Vector3; 3] {
    random.frame().map(|v| Vector3::from_glam(v.into()))
}
