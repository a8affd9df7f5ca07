//! Reports powers, light and colours, by wrappers around materials; with all work, every material asks
//! all lights, and a Phong material takes a power for each.

use std::cell::Cell;
use std::hint::black_box;

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a04_intersections::instruments::instrumented as geometries;
use common::steps::{self, Outcome, Step, StepKind, type_name};
use common::{Color, Omission, Omissions};

use crate::power::power;
use crate::registry::Materials;
use crate::{Illumination, Lambert, Lighting, Material, Phong};

/// Wraps this material, whose type may have one of these rows, to report its work; it leaves
/// out the work of `omissions`.
pub fn material(
    material: Box<dyn Material>,
    rows: Materials,
    omissions: Omissions,
) -> Box<dyn Material> {
    Box::new(InstrumentedMaterial {
        material,
        rows,
        gets_all_light: true,
        omissions,
    })
}

/// A material whose work is reported.
#[derive(Debug)]
pub struct InstrumentedMaterial {
    /// The material.
    pub material: Box<dyn Material>,
    /// The rows of materials.
    pub rows: Materials,
    /// Whether black light, and light from behind the surface, reaches the material.
    pub gets_all_light: bool,
    /// The work that it leaves out.
    pub omissions: Omissions,
}

impl Material for InstrumentedMaterial {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        let light = InstrumentedLighting {
            ray,
            hit,
            instrumented: self,
            lighting,
            is_used: Cell::new(false),
        };
        let color = shaded(ray, hit, self.rows, &*self.material, || {
            self.material.color_for(ray, hit, &light)
        });
        if !light.is_used.get() && !self.omissions.contains(Omission::UnreflectedLight) {
            steps::untraced(|| light.for_each_light(ray, hit, &mut |_| ()));
        }
        color
    }
}

/// Reports the nearest hit, and the colour of its material with the steps of `shade`, which
/// computes it.
pub fn shaded(
    ray: &Ray,
    hit: &Hit,
    rows: Materials,
    material: &dyn Material,
    shade: impl FnOnce() -> Color,
) -> Color {
    geometries::shaded(ray, hit, || {
        let color = shade();
        steps::heading(StepKind::Color, |kind| {
            step(kind, "colour", rows, material).with("c", color.channels())
        });
        color
    })
}

/// The step of a part of a material's colour. A material that mirrors is about the Phong material in it.
fn step(kind: StepKind, part: &str, rows: Materials, material: &dyn Material) -> Step {
    let name = format!("{part} of {}", type_name(material));
    let about = match rows.as_phong(material) {
        Some(phong) => type_name(phong),
        None => type_name(material),
    };
    Step::new(kind, name, rows.section(material)).about(about)
}

impl InstrumentedMaterial {
    /// Counts the power that a Phong material takes for a light. Of a highlight that nobody sees it takes one
    /// here, where this work is not left out.
    fn count_power(&self, ray: &Ray, hit: &Hit, light: &Illumination) {
        let Some(phong) = self.rows.as_phong(&*self.material) else {
            return;
        };
        let cosine = (-ray.direction()).dot(light.direction.reflected_on(hit.normal));
        let is_mirrored = hit.normal.dot(light.direction) > 0.0 && cosine > 0.0;
        if is_mirrored && phong.specular != Color::BLACK {
            steps::count(StepKind::Power, 1);
        } else if !self.omissions.contains(Omission::UnseenHighlights) {
            black_box(power(cosine.clamp(0.0, 1.0), phong.exponent));
            steps::count(StepKind::Power, 1);
        }
    }

    /// The ambient light that the material reflects.
    fn ambient(&self, kind: StepKind, ray: &Ray, hit: &Hit, ambient: Color) -> Step {
        let of = |ambient| self.material.color_for(ray, hit, &OneLight(ambient, None));
        step(kind, "ambient light", self.rows, &*self.material)
            .with("ca", ambient.channels())
            .with("cd", of(Color::WHITE).channels())
            .with("c", of(ambient).channels())
    }

    /// The part of one light that the material reflects, and both terms of a Phong material.
    fn reflected(&self, kind: StepKind, ray: &Ray, hit: &Hit, light: &Illumination) -> Step {
        let only = OneLight(Color::BLACK, Some(*light));
        let mut step = step(kind, "light", self.rows, &*self.material);
        if let Some(phong) = self.rows.as_phong(&*self.material) {
            let diffuse = Color::BLACK;
            let highlight = Phong {
                matt: Lambert { diffuse },
                ..*phong
            };
            let r = light.direction.reflected_on(hit.normal);
            step = step
                .with("diffuse", phong.matt.diffuse_term(hit, light).channels())
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
struct InstrumentedLighting<'a> {
    instrumented: &'a InstrumentedMaterial,
    /// The ray and the hit that are shaded.
    ray: &'a Ray,
    hit: &'a Hit,
    lighting: &'a dyn Lighting,
    /// Whether the material has used the lights.
    is_used: Cell<bool>,
}

impl Lighting for InstrumentedLighting<'_> {
    fn ambient(&self) -> Color {
        let ambient = self.lighting.ambient();
        steps::push(StepKind::Ambient, |kind| {
            self.instrumented.ambient(kind, self.ray, self.hit, ambient)
        });
        ambient
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.is_used.set(true);
        let instrumented = self.instrumented;
        let first = steps::so_far(|steps| steps.len()).unwrap_or(0);
        self.lighting.for_each_light(ray, hit, &mut |light| {
            instrumented.count_power(ray, hit, light);
            // These are the conditions of the lesson.
            let is_dark = light.color == Color::BLACK || hit.normal.dot(light.direction) <= 0.0;
            if instrumented.gets_all_light || !is_dark {
                steps::push(StepKind::ReflectedLight, |kind| {
                    instrumented.reflected(kind, ray, hit, light)
                });
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
        let arrives = parts
            .iter()
            .any(|step| step.kind == StepKind::ReflectedLight);
        light.values.push(("arrives", vec![f64::from(arrives)]));
        let Some(l) = light.value("l").map(|l| Vector3::from_glam(l.into())) else {
            light.outcome = Outcome::Dark;
            continue;
        };
        let cosine = hit.normal.dot(l);
        // The search ends at the object that blocks the light; an object before it in the
        // list may hold the lamp.
        let mut tests = parts.iter().filter(|step| step.kind == StepKind::Test);
        light.outcome = match tests.rfind(|test| test.outcome == Outcome::Hit) {
            _ if arrives => Outcome::Arrives,
            _ if light.value("cl") == Some([0.0; 3]) => Outcome::Dark,
            Some(test) if cosine > 0.0 => Outcome::BlockedBy(test.name.clone()),
            _ => Outcome::BehindSurface,
        };
        let angle = Vector3::from(hit.normal).angle(l).to_degrees();
        light.values.push(("n·l", vec![cosine]));
        light.values.push(("degrees", vec![angle]));
    }
}
