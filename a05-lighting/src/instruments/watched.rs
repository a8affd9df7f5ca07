//! Counts powers and records light and colours, by wrappers around materials and lights; with
//! all work, every material computes the light of all lights, and a Phong material a power for
//! each.

use a02_math::arrays::array;
use std::any::Any;
use std::cell::Cell;
use std::fmt::Debug;
use std::hint::black_box;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, watched};
use common::Color;
use common::steps::{self, HIT, LIGHT, Step, TEST, type_name};
use common::tally::{self, Work};

use crate::power::power;
use crate::{Illumination, Lambert, Light, Lighting, LitWorld, Material, Phong};

const REFLECTED: &str = "reflected light";

/// The world with its geometries, surfaces and lights replaced by these functions of them;
/// geometries and lights are counted from 1.
pub fn world<S, T, L>(
    world: LitWorld<S, L>,
    geometry: impl Fn(usize, Box<dyn Geometry>) -> Box<dyn Geometry>,
    surface: impl Fn(S) -> T,
    light: impl Fn((usize, L)) -> L,
) -> LitWorld<T, L> {
    LitWorld {
        world: watched::world(world.world, geometry, surface),
        lights: (1..).zip(world.lights).map(light).collect(),
        ambient: world.ambient,
    }
}

/// A light whose steps are recorded, with its number and the name of its type.
#[derive(Debug)]
struct WatchedLight(usize, String, Box<dyn Light>);

/// Wraps a light, counted from 1, to record its steps.
pub fn light((number, light): (usize, Box<dyn Light>)) -> Box<dyn Light> {
    Box::new(WatchedLight(number, type_name(&light), light))
}

impl Light for WatchedLight {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.2.illumination(point);
        push_light(self.0, &self.1, light);
        light
    }
}

/// Records the light that arrives from a source, counted from 1, of this type.
pub fn push_light(number: usize, name: &str, light: Option<Illumination>) {
    steps::heading(|| {
        let name = format!("light {number}: {name}");
        let step = Step::new(LIGHT, name, "a05-lighting.md#three-lights");
        light.into_iter().fold(step, |step, light| {
            step.with("cl", light.color.channels())
                .with("l", array(light.direction))
                .with("distance", [light.distance])
        })
    });
}

/// Wraps this material to count its powers.
pub fn material(material: Box<dyn Material>, all_work: bool) -> Box<dyn Material> {
    Box::new(Watched {
        material,
        as_phong: |material| (material as &dyn Any).downcast_ref(),
        is_lit_from_behind: true,
        all_work,
    })
}

/// A material whose powers are counted.
#[derive(Debug)]
pub struct Watched<M: ?Sized> {
    /// The material.
    pub material: Box<M>,
    /// The material as a Phong material, if it is one.
    pub as_phong: fn(&M) -> Option<&Phong>,
    /// Whether light from behind the surface reaches the material.
    pub is_lit_from_behind: bool,
    /// Whether it does the work that the lesson leaves out.
    pub all_work: bool,
}

impl<M: Material + ?Sized> Material for Watched<M> {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let light = WatchedLighting {
            ray,
            hit,
            watched: self,
            lighting,
            is_used: Cell::new(false),
        };
        let color = shaded(ray, hit, &self.material, || {
            self.material.color_for(ray, hit, &light)
        });
        if self.all_work && !light.is_used.get() {
            steps::paused(|| light.for_each_light(ray, hit, &mut |_| ()));
        }
        color
    }
}

/// Records the nearest hit, and the colour of its material with the steps of `shade`, which
/// computes it.
pub fn shaded<M: Debug + ?Sized>(
    ray: &Ray,
    hit: &Hit,
    material: &M,
    shade: impl FnOnce() -> Color,
) -> Color {
    watched::shaded(ray, hit, || {
        let color = shade();
        steps::heading(|| step("color", "colour", material).with("c", color.channels()));
        color
    })
}

/// The step of a part of a material's colour.
fn step<M: Debug + ?Sized>(kind: &'static str, part: &str, material: &M) -> Step {
    let name = type_name(material);
    let section = match &*name {
        "Lambert" => "a05-lighting.md#lambert-the-cosine",
        "Phong" | "Reflective" => "a05-lighting.md#phong-the-highlight",
        _ => "a05-lighting.md#two-questions",
    };
    Step::new(kind, format!("{part} of {name}"), section)
}

impl<M: Material + ?Sized> Watched<M> {
    /// The ambient light that the material reflects.
    fn ambient(&self, ray: &Ray, hit: &Hit, ambient: Color) -> Step {
        let of = |ambient| self.material.color_for(ray, hit, &OneLight(ambient, None));
        step("ambient", "ambient light", &self.material)
            .with("ca", ambient.channels())
            .with("cd", of(Color::WHITE).channels())
            .with("c", of(ambient).channels())
    }

    /// The part of one light that the material reflects, and both terms of a Phong material.
    fn reflected(&self, ray: &Ray, hit: &Hit, light: &Illumination) -> Step {
        let only = OneLight(Color::BLACK, Some(*light));
        let mut step = step(REFLECTED, "light", &self.material);
        if let Some(phong) = (self.as_phong)(&self.material) {
            let diffuse = Color::BLACK;
            let highlight = Phong {
                matt: Lambert { diffuse },
                ..*phong
            };
            let r = light.direction.reflected_on(hit.normal);
            step = step
                .with("diffuse", phong.matt.share(hit, light).channels())
                .with("cs", phong.specular.channels())
                .with("e·r", [(-ray.direction()).dot(r)])
                .with("exponent", [phong.exponent])
                .with("specular", highlight.color_for(ray, hit, &only).channels());
        }
        let color = self.material.color_for(ray, hit, &only);
        step.with("c", color.channels())
    }
}

/// Ambient light and at most one light that arrives, for one term of a material's sum.
struct OneLight(Color, Option<Illumination>);

impl Lighting for OneLight {
    fn ambient(&self) -> Color {
        self.0
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.1.iter().for_each(shade);
    }
}

/// Light on its way to a material, which may take a power for it.
struct WatchedLighting<'a, M: ?Sized> {
    watched: &'a Watched<M>,
    /// The ray and the hit that are shaded.
    ray: &'a Ray,
    hit: &'a Hit,
    lighting: &'a dyn Lighting,
    /// Whether the material has used the lights.
    is_used: Cell<bool>,
}

impl<M: Material + ?Sized> Lighting for WatchedLighting<'_, M> {
    fn ambient(&self) -> Color {
        let ambient = self.lighting.ambient();
        steps::push(|| self.watched.ambient(self.ray, self.hit, ambient));
        ambient
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.is_used.set(true);
        let watched = self.watched;
        let phong = (watched.as_phong)(&watched.material);
        let first = steps::so_far(|steps| steps.len()).unwrap_or(0);
        self.lighting.for_each_light(ray, hit, &mut |light| {
            if let Some(phong) = phong {
                count_power(phong, watched.all_work, ray, hit, light);
            }
            let is_behind = hit.normal.dot(light.direction) <= 0.0;
            if watched.is_lit_from_behind || !is_behind {
                steps::push(|| watched.reflected(ray, hit, light));
                shade(light);
            }
        });
        steps::so_far(|steps| add_outcomes(&mut steps[first..], hit));
    }
}

/// Adds to the step of each light whether it arrives at the hit, or why it does not.
fn add_outcomes(steps: &mut [Step], hit: &Hit) {
    let level = steps.first().map_or(0, |step| step.level);
    for block in steps.chunk_by_mut(|_, next| next.level > level) {
        let Some((light, parts)) = block.split_first_mut() else {
            continue;
        };
        let arrives = parts.iter().any(|step| step.kind == REFLECTED);
        light.values.push(("arrives", vec![f64::from(arrives)]));
        let Some(l) = light.value("l").map(|l| Vector3::from_glam(l.into())) else {
            "does not shine here".clone_into(&mut light.outcome);
            continue;
        };
        let cosine = hit.normal.dot(l);
        // The search ends at the object that blocks the light; an object before it in the
        // list may hold the lamp.
        let mut tests = parts.iter().filter(|step| step.kind == TEST);
        light.outcome = match tests.rfind(|test| test.outcome == HIT) {
            _ if arrives => "arrives".to_owned(),
            Some(test) if cosine > 0.0 => format!("blocked by {}", test.name),
            _ => "behind the surface".to_owned(),
        };
        let angle = Vector3::from(hit.normal).angle(l).to_degrees();
        light.values.push(("n·l", vec![cosine]));
        light.values.push(("degrees", vec![angle]));
    }
}

/// Counts the power that a Phong material takes for this light by Phong's condition; with all
/// work, it always takes one.
fn count_power(phong: &Phong, all_work: bool, ray: &Ray, hit: &Hit, light: &Illumination) {
    let (e, l) = (-ray.direction(), light.direction);
    let is_mirrored = hit.normal.dot(l) > 0.0 && e.dot(l.reflected_on(hit.normal)) > 0.0;
    let is_needed = is_mirrored && phong.specular != Color::BLACK;
    if is_needed || all_work {
        tally::count(Work::Power);
    }
    if all_work && !is_needed {
        // The compiler would remove a number that is not used.
        black_box(power(black_box(0.5), phong.exponent));
    }
}
