//! Counts and records shadow rays, reflected rays and colours, by wrappers around the objects
//! of a world.

use std::any::Any;
use std::cell::Cell;

use a02_math::Point3;
use a03_rays_cameras::instruments::watched::ray_step;
use a03_rays_cameras::{Ray, TracedWorld};
use a04_intersections::{Geometry, Hit, Interval, watched as geometries};
use a05_lighting::watched::{self as materials, Watched};
use a05_lighting::{Lighting, Material, Phong};
use common::Color;
use common::steps::{self, HIT, REFLECTED, Step};
use common::tally::{self, Work};

use crate::instruments::all_work::NaiveTracer;
use crate::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};

thread_local! {
    /// The ray for which the world is searched next; none for a ray from the camera.
    static NEXT: Cell<Option<Work>> = const { Cell::new(None) };
}

/// A world whose work is counted.
pub struct WatchedWorld {
    world: ShadowedWorld,
    all_work: bool,
}

impl WatchedWorld {
    /// Wraps the objects of a world. Every search of the world tests its first geometry, which
    /// counts the searches.
    pub fn new(
        world: ShadowedWorld,
        watched: fn(Box<dyn Geometry>) -> Box<dyn Geometry>,
        all_work: bool,
    ) -> Self {
        let geometry = |number, geometry| {
            let geometry = geometries::geometry(number, geometry, watched);
            if number == 1 {
                Box::new(First(geometry))
            } else {
                geometry
            }
        };
        let surface = |material| {
            Box::new(WatchedSurface(Watched {
                material,
                as_phong,
                is_lit_from_behind: false,
                all_work,
            })) as _
        };
        let light = |(number, source): (usize, LightSource)| LightSource {
            light: materials::light((number, source.light)),
            ..source
        };
        Self {
            world: materials::world(world, geometry, surface, light),
            all_work,
        }
    }

    /// The colour that this function of the world finds for a ray from the camera.
    pub fn color(&self, trace: impl FnOnce(&ShadowedWorld) -> Color) -> Color {
        NEXT.set(None);
        let color = trace(&self.world);
        geometries::push_background(self.world.objects().background());
        color
    }
}

impl TracedWorld for WatchedWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        if self.all_work {
            self.color(|world| NaiveTracer(world).trace(ray, depth))
        } else {
            self.color(|world| RecursiveTracer::new(world).trace(ray, depth))
        }
    }

    fn watched(self: Box<Self>, _: bool) -> Box<dyn TracedWorld> {
        self
    }
}

/// The first geometry of a world.
#[derive(Debug)]
struct First(Box<dyn Geometry>);

impl Geometry for First {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        match NEXT.get() {
            Some(work) => {
                tally::count(work);
                push_ray(work, ray, within);
            }
            None => NEXT.set(Some(Work::ReflectedRay)),
        }
        self.0.hit(ray, within)
    }
}

/// Records a shadow ray or a reflected ray, and the lift of its origin off the last hit.
fn push_ray(work: Work, ray: &Ray, within: Interval) {
    let before = |steps: &mut Vec<Step>| {
        let of_sample = steps.iter().rev().take_while(|step| step.level > 0);
        let reflected = of_sample.clone().filter(|step| step.kind == REFLECTED);
        let hit = of_sample.clone().find(|step| step.kind == HIT);
        (1 + reflected.count(), hit.and_then(|hit| hit.value("p")))
    };
    let Some((number, p)) = steps::so_far(before) else {
        return;
    };
    if work == Work::ShadowRay {
        let section = "a06-shadows-reflection.md#is-the-light-in-sight";
        let step = ray_step("shadow ray", "shadow ray", section, ray);
        steps::push(|| step.with("end", [within.max]));
    } else {
        let name = format!("reflected ray {number}");
        let section = "a06-shadows-reflection.md#the-mirror";
        steps::heading(|| ray_step(REFLECTED, name, section, ray));
    }
    let section = "a06-shadows-reflection.md#getting-off-the-surface";
    let lift = ray.origin() - Point3::from_glam(p.unwrap_or_default().into());
    let step = Step::new("lift", "lift off the surface", section);
    steps::push(|| step.with("|p' - p|", [lift.magnitude()]));
}

/// A surface whose shadow rays and powers are counted.
#[derive(Debug)]
struct WatchedSurface(Watched<dyn Surface>);

impl Material for WatchedSurface {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        NEXT.set(Some(Work::ShadowRay));
        let color = self.0.color_for(ray, hit, lighting);
        NEXT.set(Some(Work::ReflectedRay));
        color
    }
}

impl Surface for WatchedSurface {
    fn reflection(&self) -> Color {
        let reflection = self.0.material.reflection();
        steps::push(|| {
            let section = "a06-shadows-reflection.md#the-mirror";
            let step = Step::new("mirror", "share of the mirror", section);
            step.with("cr", reflection.channels())
        });
        reflection
    }
}

/// The Phong material of a surface, if it has one.
fn as_phong(surface: &dyn Surface) -> Option<&Phong> {
    let any: &dyn Any = surface;
    let reflective = any.downcast_ref::<Reflective>();
    reflective.map_or_else(|| any.downcast_ref(), |surface| Some(&surface.shiny))
}
