//! Reports shadow rays, reflected rays and mirrors, by wrappers around the objects, lights and
//! surfaces of a world.
//!
//! A search of the world begins with the test of its first object. Whether any object is hit is asked of
//! a shadow ray, and which one is nearest of the camera's ray, which has just been reported, or of a reflected ray.

use a02_math::Point3;
use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::instruments::instrumented::ray_step;
use a03_rays_cameras::{Ray, TracedWorld};
use a04_intersections::instruments::instrumented as geometries;
use a04_intersections::registry::Shapes;
use a04_intersections::{Geometry, Hit, Interval};
use a05_lighting::instruments::instrumented::{self as materials, InstrumentedMaterial};
use a05_lighting::{Lighting, Material};
use common::steps::{self, Step, StepKind};
use common::{Color, Omissions};

use crate::instruments::omitting_tracer::OmittingTracer;
use crate::registry::ALL_MATERIALS;
use crate::{LightSource, RecursiveTracer, ShadowedWorld, Surface};

/// A world whose work is reported, or that does all work.
pub struct InstrumentedWorld {
    world: ShadowedWorld,
    instruments: Instruments,
}

impl InstrumentedWorld {
    /// Wraps the objects of a world, which may be of these shapes, its surfaces and its lights;
    /// where nothing is reported, only its surfaces.
    #[must_use]
    pub fn new(world: ShadowedWorld, shapes: Shapes, instruments: Instruments) -> Self {
        let omissions = instruments.omissions();
        let surface = |surface| InstrumentedSurface::on(surface, omissions);
        if let Instruments::Silent(_) = instruments {
            return Self {
                world: materials::map_surfaces(world, surface),
                instruments,
            };
        }
        let geometry = |number, geometry: Box<dyn Geometry>| {
            let instrumented = geometries::geometry(number, geometry, shapes);
            if number == 1 {
                Box::new(FirstObject(instrumented))
            } else {
                instrumented
            }
        };
        let light = |(number, source): (usize, LightSource)| LightSource {
            light: materials::light((number, source.light)),
            ..source
        };
        Self {
            world: materials::map_world(world, geometry, surface, light),
            instruments,
        }
    }

    /// The colour that this function of the world finds for a ray from the camera.
    pub fn color(&self, trace: impl FnOnce(&ShadowedWorld) -> Color) -> Color {
        let color = trace(&self.world);
        geometries::push_background(self.world.objects().background());
        color
    }
}

impl TracedWorld for InstrumentedWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        if self.instruments == Instruments::LESSON {
            return self.color(|world| RecursiveTracer::new(world).trace(ray, depth));
        }
        let omissions = self.instruments.omissions();
        self.color(|world| OmittingTracer { world, omissions }.trace(ray, depth))
    }

    fn instrumented(self: Box<Self>, _: Instruments) -> Box<dyn TracedWorld> {
        self
    }
}

/// The first object of the world, with whose test a search begins: it reports the ray.
#[derive(Debug)]
struct FirstObject(Box<dyn Geometry>);

impl Geometry for FirstObject {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        if steps::last() != Some(StepKind::CameraRay) {
            push_reflected_ray(ray);
        }
        self.0.hit(ray, within)
    }

    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        push_shadow_ray(ray, within);
        self.0.any_hit(ray, within, counts)
    }
}

fn push_shadow_ray(ray: &Ray, within: Interval) {
    let p = last_hit();
    steps::push(StepKind::ShadowRay, |kind| {
        let section = "a06-shadows-reflection.md#is-the-light-in-sight";
        ray_step(kind, "shadow ray", section, ray).with("end", [within.max])
    });
    push_offset(ray, p);
}

fn push_reflected_ray(ray: &Ray) {
    let p = last_hit();
    let before = steps::so_far(|steps| {
        let mut of_sample = steps.iter().rev().take_while(|step| step.level > 0);
        let last = of_sample.find(|step| step.kind == StepKind::ReflectedRay);
        last.and_then(|step| step.number).unwrap_or_default()
    });
    steps::heading(StepKind::ReflectedRay, |kind| {
        let number = 1 + before.unwrap_or_default();
        let (name, section) = (
            format!("reflected ray {number}"),
            "a06-shadows-reflection.md#the-mirror",
        );
        ray_step(kind, name, section, ray).numbered(number)
    });
    push_offset(ray, p);
}

/// The point of the last hit of the sample, if steps are traced.
fn last_hit() -> Option<Point3> {
    steps::so_far(|steps| {
        let mut of_sample = steps.iter().rev().take_while(|step| step.level > 0);
        let hit = of_sample.find(|step| step.kind == StepKind::Hit);
        let p = hit.and_then(|hit| hit.value("p")).unwrap_or_default();
        Point3::from_glam(p.into())
    })
}

/// Reports how far the origin of a ray is from the last hit.
fn push_offset(ray: &Ray, p: Option<Point3>) {
    steps::push(StepKind::Offset, |kind| {
        let section = "a06-shadows-reflection.md#getting-off-the-surface";
        let offset = ray.origin() - p.unwrap_or_default();
        Step::new(kind, "offset from the surface", section).with("|p' - p|", [offset.magnitude()])
    });
}

/// A surface whose work is reported.
#[derive(Debug)]
pub struct InstrumentedSurface {
    instrumented: InstrumentedMaterial,
    reflection: Color,
}

impl InstrumentedSurface {
    /// Wraps a surface that leaves out this work.
    fn on(surface: Box<dyn Surface>, omissions: Omissions) -> Box<dyn Surface> {
        Box::new(Self {
            reflection: surface.mirror_reflectance(),
            instrumented: InstrumentedMaterial {
                material: surface,
                rows: ALL_MATERIALS,
                gets_all_light: false,
                omissions,
            },
        })
    }
}

impl Material for InstrumentedSurface {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        self.instrumented.color_for(ray, hit, lighting)
    }
}

impl Surface for InstrumentedSurface {
    fn mirror_reflectance(&self) -> Color {
        steps::push(StepKind::Mirror, |kind| {
            let section = "a06-shadows-reflection.md#the-mirror";
            Step::new(kind, "mirror reflectance", section).with("cr", self.reflection.channels())
        });
        self.reflection
    }
}
