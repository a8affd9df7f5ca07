//! `why_black`: why a picture is black all over. The engine draws it again with one change at a time,
//! such as no shadows: a change that brings light into the picture is the reason.

use std::sync::atomic::{AtomicBool, Ordering};

use a02_math::arrays::array;
use a02_math::{Point3, Vector3};
use common::pixel_trace::digits;
use common::{Color, Progress, Renderer, Settings, Size};
use engine::{Emitter, Phong, Scene, Shading, Surface};

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
        let shows_light =
            |phong: &Phong| phong.diffuse != Color::BLACK || phong.specular != Color::BLACK;
        if !self.is_lit(settings, |scene| whiten(scene, shows_light)) {
            return None;
        }
        let scene = self.world.for_engine(settings.depth)?;
        let mut lamps = Vec::new();
        for light in &scene.lights {
            lamps.push(match light.kind {
                Emitter::Point { color, .. }
                | Emitter::Spot { color, .. }
                | Emitter::Directional { color, .. } => color,
                Emitter::Other(_) => return None,
            });
        }
        if lamps.iter().all(|lamp| *lamp == Color::BLACK) {
            let lamps = if lamps.is_empty() {
                "no lamp"
            } else {
                "its lamps are black"
            };
            let reason = format!("the scene has no light: {lamps}, and no ambient light");
            return (scene.ambient == Color::BLACK).then_some(reason);
        }
        if let Some(object) = self.object_around(&scene, settings.size) {
            return Some(format!(
                "the camera is within {object}, where no light gets"
            ));
        }
        if self.is_lit(settings, open_spots) {
            let reason = "a spot light is turned away from what is seen, or its cone is too narrow: \
                          a point light in its place would light it";
            return Some(reason.to_owned());
        }
        if self.is_lit(settings, end_shadows) {
            let reason = "objects block the light: without shadows it would arrive";
            return Some(reason.to_owned());
        }
        let with_both = |scene: &mut Scene| {
            open_spots(scene);
            end_shadows(scene);
        };
        if self.is_lit(settings, with_both) {
            let reason = "spot lights are turned away from what is seen, and objects block them";
            return Some(reason.to_owned());
        }
        // A surface that can show each lamp is black because all cosines are 0.
        let shows_each_lamp = |surface: &Surface| match &surface.shading {
            Shading::SingleColor(_) => true,
            Shading::Phong(phong) if phong.diffuse == Color::BLACK => true,
            Shading::Phong(phong) => {
                let black = |lamp: &Color| phong.diffuse * *lamp == Color::BLACK;
                !lamps.iter().any(black)
            }
            Shading::Other(_) => false,
        };
        let is_behind = scene.surfaces.iter().all(shows_each_lamp)
            && self.is_lit(settings, |scene| {
                whiten(scene, |phong| phong.diffuse != Color::BLACK);
            });
        let reason = "no lamp is in front of the surfaces with a diffuse color that are seen";
        is_behind.then(|| reason.to_owned())
    }

    /// The name of an object with the eye in it and all lamps outside, all with shadows. It is around the
    /// eye, and between the eye and each lamp it is met once.
    fn object_around(&self, scene: &Scene, size: Size) -> Option<String> {
        let eye = self.middle_ray(size).origin();
        let (object, _) = self.world.nearest(&self.middle_ray(size))?;
        let meets = |from: Point3, direction: Vector3| {
            let (met, t) = self.world.nearest(&Ray::derived(from, direction))?;
            (met == object).then_some(t)
        };
        for i in 0..27 {
            let [x, y, z] = [i % 3, i / 3 % 3, i / 9].map(|side| f64::from(side) - 1.0);
            if i != 13 {
                meets(eye, Vector3::new(x, y, z).normalized()?)?;
            }
        }
        for light in &scene.lights {
            if !light.casts_shadows {
                return None;
            }
            match light.kind {
                Emitter::Point { position, .. } | Emitter::Spot { position, .. } => {
                    let lamp = Point3::from_glam(position);
                    let there = lamp - eye;
                    let distance = there.magnitude();
                    let there = there.normalized()?;
                    let sum = meets(eye, there)? + meets(lamp, -there)?;
                    if (sum - distance).abs() > 1e-6 * distance {
                        return None;
                    }
                }
                Emitter::Directional { direction, .. } => {
                    meets(eye, -Vector3::from_glam(direction))?;
                }
                Emitter::Other(_) => return None,
            }
        }
        Some(self.world.object_name(object))
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

/// Makes the surfaces that `is_white` white in the dark, and all others black; mirrors stay.
fn whiten(scene: &mut Scene, is_white: impl Fn(&Phong) -> bool) {
    scene.background = Color::BLACK;
    for surface in &mut scene.surfaces {
        let color = match &surface.shading {
            Shading::Phong(phong) if is_white(phong) => Color::WHITE,
            _ => Color::BLACK,
        };
        surface.shading = Shading::SingleColor(color);
    }
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
