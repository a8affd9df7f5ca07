//! `why_black`: why a picture is black all over. The engine draws it again with one change at a time,
//! such as no shadows. A reason says what such a picture proves, and nothing about places that no ray has met.

use std::sync::atomic::{AtomicBool, Ordering};

use a02_math::Point3;
use a02_math::arrays::array;
use common::pixel_trace::digits;
use common::{Color, Progress, Renderer, Settings, Size};
use engine::{Emitter, Light, Scene, Shading, Surface};

use crate::{Ray, View, camera_coordinates, registry};

/// Rays along each side of the picture that look for objects behind the camera.
const RAYS: u32 = 6;

impl View {
    /// Why the picture is black; none if no reason is sure, so that it may be meant. The picture of a
    /// scene `of_stage` is made by code alone, which may be wrong.
    pub(crate) fn why_black(self, settings: &Settings, of_stage: bool) -> Option<String> {
        if self.world.object_name(1).is_empty() {
            return None;
        }
        if settings.renderer != Renderer::Engine && self.is_lit(settings, |_| ()) {
            let reason = "a formula of the lesson is wrong, because --fast draws light";
            return Some(reason.to_owned());
        }
        let meets_objects = |scene: &mut Scene| {
            for surface in &mut scene.surfaces {
                *surface = Surface::matt(Shading::SingleColor(Color::WHITE));
            }
        };
        let reason = if self.is_lit(settings, meets_objects) {
            self.why_unlit(settings)?
        } else {
            self.looks_away(settings.size)
        };
        let code = if of_stage {
            ", or a formula is wrong"
        } else {
            ""
        };
        Some(reason + code)
    }

    /// Whether the engine's picture has light after this change of the scene.
    fn is_lit(&self, settings: &Settings, change: impl FnOnce(&mut Scene)) -> bool {
        let Some(mut scene) = self.world.for_engine(settings.depth) else {
            return false;
        };
        change(&mut scene);
        let light = FirstLight::default();
        // An error says that the light ended the rendering, or that there is no picture.
        let _ = registry::render(scene, &*self.camera, settings, &light);
        light.0.into_inner()
    }

    /// Why the objects that rays meet are black.
    fn why_unlit(&self, settings: &Settings) -> Option<String> {
        let eye = self.middle_ray(settings.size).origin();
        let scene = self.world.for_engine(settings.depth)?;
        let is_black = |light: &Light| light.max_radiance() == Color::BLACK;
        if scene.ambient == Color::BLACK && scene.lights.iter().all(is_black) {
            let lamps = if scene.lights.is_empty() {
                "no lamp"
            } else {
                "its lamps are black"
            };
            let reason = format!("the scene has no light: {lamps}, and no ambient light");
            return self
                .is_lit(settings, |scene| add_light(scene, eye))
                .then_some(reason);
        }
        let mut reasons = REASONS.iter();
        let (_, reason) = reasons.find(|(change, _)| self.is_lit(settings, |s| change(s, eye)))?;
        Some((*reason).to_owned())
    }

    /// The camera's place and direction, if its rays meet nothing.
    fn looks_away(&self, size: Size) -> String {
        let ray = self.middle_ray(size);
        let places = (0..RAYS * RAYS).map(|i| {
            let [x, y] = [(i % RAYS, size.width()), (i / RAYS, size.height())];
            let middle = |(part, side): (u32, u32)| (2 * part + 1) * side / (2 * RAYS);
            camera_coordinates(size, middle(x), middle(y), (0.5, 0.5))
        });
        let is_behind = |(x, y)| {
            let ray = self.camera.ray_for(size, x, y);
            let behind = Ray::derived(ray.origin(), -ray.direction());
            self.world.nearest(&behind).is_some()
        };
        let away = if places.into_iter().any(is_behind) {
            ", away from what is behind it"
        } else {
            ""
        };
        format!(
            "no ray meets an object: the camera at {} looks along {}{away}",
            digits(&array(ray.origin())),
            digits(&array(ray.direction()))
        )
    }

    /// The ray through the middle of the picture.
    fn middle_ray(&self, size: Size) -> Ray {
        let [x, y] = [size.width(), size.height()].map(|side| (f64::from(side) - 1.0) / 2.0);
        self.camera.ray_for(size, x, y)
    }
}

/// Whether a picture has light; the first light ends its rendering.
#[derive(Default)]
struct FirstLight(AtomicBool);

impl Progress for FirstLight {
    fn row(&self, _: u32, pixels: &mut dyn Iterator<Item = Color>) {
        for color in pixels {
            if color != Color::BLACK {
                self.0.store(true, Ordering::Relaxed);
                return;
            }
        }
    }

    fn stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A change of a scene whose camera is at this place.
type Change = fn(&mut Scene, Point3);

/// Changes, and what is true if a change brings light into the picture and those above it do not.
const REASONS: [(Change, &str); 4] = [
    (
        |scene, _| open_spots(scene),
        "a spot light is turned away from what is seen, or its cone is too narrow: a point light in \
         its place would light it",
    ),
    (
        |scene, _| end_shadows(scene),
        "objects block the light: without shadows it would arrive",
    ),
    (
        |scene, _| {
            open_spots(scene);
            end_shadows(scene);
        },
        "spot lights are turned away from what is seen, and objects block them",
    ),
    (
        move_lamps,
        "what is seen, by its normals and colors, sends no light of the lamps to the camera: lamps at \
         the camera's place would light it",
    ),
];

/// Adds white ambient light, and a white lamp at the eye.
fn add_light(scene: &mut Scene, eye: Point3) {
    scene.ambient = Color::WHITE;
    let lamp = Emitter::Point {
        color: Color::WHITE,
        position: eye.to_glam(),
    };
    scene.add_light(Light {
        kind: lamp,
        casts_shadows: false,
    });
}

/// Makes each spot light a point light.
fn open_spots(scene: &mut Scene) {
    for light in &mut scene.lights {
        if let Emitter::Spot {
            color, position, ..
        } = light.kind
        {
            light.kind = Emitter::Point { color, position };
        }
    }
}

fn end_shadows(scene: &mut Scene) {
    for light in &mut scene.lights {
        light.casts_shadows = false;
    }
}

/// Makes each lamp a point light at the eye without shadows.
fn move_lamps(scene: &mut Scene, eye: Point3) {
    end_shadows(scene);
    for light in &mut scene.lights {
        if let Emitter::Point { color, .. }
        | Emitter::Spot { color, .. }
        | Emitter::Directional { color, .. } = light.kind
        {
            light.kind = Emitter::Point {
                color,
                position: eye.to_glam(),
            };
        }
    }
}
