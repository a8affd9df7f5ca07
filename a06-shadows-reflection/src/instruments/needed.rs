//! A world that reports the work that no renderer can leave out, whatever its data structures: a
//! hit takes the test of the object that is hit, a shadow that of one object in the light's way, and
//! a ray that nothing stops may take none.

use a02_math::Direction;
use a03_rays_cameras::instruments::Instruments;
use a03_rays_cameras::{Ray, TracedWorld};
use a04_intersections::instruments::objects;
use a04_intersections::kinds::{Content, ShapeKind, Shapes};
use a04_intersections::{Geometry, Hit, Interval};
use a05_lighting::{Illumination, Light, Lighting};
use common::steps::{self, StepKind};
use common::{Color, Omissions};

use crate::instruments::recorded::RecordedSurface;
use crate::kinds::responds_to_light;
use crate::shadow::ShadowRay;
use crate::{ShadowedWorld, secondary_ray};

/// A world whose work is reported as far as no renderer can leave it out.
pub struct NeededWorld {
    /// Its surfaces report powers.
    world: ShadowedWorld,
    /// The facts about each object.
    objects: Vec<NeededObject>,
}

/// The facts about an object that decide which work it needs.
#[derive(Clone, Copy)]
struct NeededObject {
    /// Whether rays are transformed to its space.
    is_transformed: bool,
    /// Whether light can change its colour.
    responds_to_light: bool,
}

impl NeededWorld {
    /// The world, whose objects may be of these shapes.
    #[must_use]
    pub fn new(world: ShadowedWorld, shapes: Shapes) -> Self {
        let objects = world.objects().objects();
        let objects = objects.map(|(geometry, surface)| NeededObject {
            is_transformed: is_transformed(geometry, shapes),
            responds_to_light: responds_to_light(&**surface),
        });
        let objects = objects.collect();
        Self {
            world: RecordedSurface::on_all(world, Omissions::ALL),
            objects,
        }
    }
}

/// Whether rays are transformed to the space of a shape, or to that of each of its parts.
fn is_transformed(geometry: &dyn Geometry, shapes: Shapes) -> bool {
    let kind = shapes.row(geometry).and_then(|row| row.get(geometry));
    match kind.map(ShapeKind::content) {
        Some(Content::Children {
            transform: None,
            shapes: parts,
        }) => parts.iter().all(|part| is_transformed(*part, shapes)),
        Some(Content::Children { .. }) => true,
        Some(Content::Values(_)) | None => false,
    }
}

impl TracedWorld for NeededWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        let mut ray = *ray;
        let mut color = Color::BLACK;
        let mut mirrored = Color::WHITE;
        let world = self.world.objects();
        for bounce in 0..depth {
            if bounce > 0 {
                steps::count(StepKind::ReflectedRay, 1);
            }
            let Some((hit, surface)) = world.hit(&ray, Interval::AHEAD) else {
                return color + mirrored * world.background();
            };
            let number = objects::nearest(world, &ray).map(|(number, _)| number - 1);
            let object = number.and_then(|number| self.objects.get(number));
            steps::count(StepKind::Test, 1);
            if object.is_some_and(|object| object.is_transformed) {
                steps::count(StepKind::ObjectRay, 1);
            }
            let lighting = NeededLighting {
                world: self,
                is_needed: object.is_none_or(|object| object.responds_to_light),
            };
            color += mirrored * surface.color_for(&ray, &hit, &lighting);
            mirrored = mirrored * surface.mirror_reflectance();
            if mirrored == Color::BLACK {
                break;
            }
            let direction = (-ray.direction()).reflected_on(hit.normal);
            ray = secondary_ray(&ray, &hit, direction);
        }
        color
    }

    fn recorded(self: Box<Self>, _: Instruments) -> Box<dyn TracedWorld> {
        self
    }
}

/// The light at a hit.
struct NeededLighting<'a> {
    world: &'a NeededWorld,
    /// Whether the light can change the colour of the surface.
    is_needed: bool,
}

impl Lighting for NeededLighting<'_> {
    fn ambient(&self) -> Color {
        self.world.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        for source in self.world.world.lights() {
            let Some(light) = source.illumination(point) else {
                continue;
            };
            if hit.normal.dot(light.direction) <= 0.0 {
                continue;
            }
            if source.casts_shadows() {
                let shadow_ray = ShadowRay::new(ray, hit, &light);
                let by_untransformed = self.is_blocked(&shadow_ray, false);
                let by_transformed = !by_untransformed && self.is_blocked(&shadow_ray, true);
                let is_blocked = by_untransformed || by_transformed;
                if self.is_needed && light.color != Color::BLACK {
                    steps::count(StepKind::ShadowRay, 1);
                    steps::count(StepKind::Test, is_blocked.into());
                    steps::count(StepKind::ObjectRay, by_transformed.into());
                }
                if is_blocked {
                    continue;
                }
            }
            shade(&light);
        }
    }
}

impl NeededLighting<'_> {
    /// Whether any of the transformed objects, or of the others, blocks a light.
    fn is_blocked(&self, shadow_ray: &ShadowRay, is_transformed: bool) -> bool {
        let blocks = |found: &Hit| shadow_ray.is_blocked_by(found);
        let before = shadow_ray.before_the_light();
        let objects = self.world.world.objects().objects();
        let mut asked = objects
            .zip(&self.world.objects)
            .filter(|(_, object)| object.is_transformed == is_transformed);
        asked.any(|((geometry, _), _)| geometry.any_hit(&shadow_ray.ray, before, &blocks))
    }
}
