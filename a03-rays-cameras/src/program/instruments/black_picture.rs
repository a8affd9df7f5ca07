//! `why_black`: why a picture is black all over, found by a few rays through it.

use a02_math::arrays::array;
use common::pixel_trace::digits;
use common::steps::{self, Outcome, StepKind};
use common::{Settings, Size};

use super::Instruments;
use crate::{Camera, Ray, View, camera_coordinates};

/// Rays along each side of the picture.
const RAYS: u32 = 6;

impl View {
    /// Why the picture is black; none if no mistake is found, so that it may be meant.
    pub(crate) fn why_black(self, settings: &Settings) -> Option<String> {
        let rays = rays(&self.camera, settings.size);
        if self.world.object_name(1).is_empty() {
            return None;
        }
        let mut seen = Vec::new();
        for ray in &rays {
            if let Some((number, _)) = self.world.nearest(ray) {
                seen.push((ray, number));
            }
        }
        let Some((_, first)) = seen.first().copied() else {
            return Some(self.looks_away(&rays, settings.size));
        };
        // Within an object it is ahead and behind.
        let is_around = |(ray, number): &(&Ray, usize)| {
            let behind = Ray::derived(ray.origin(), -ray.direction());
            let nearest = self.world.nearest(&behind);
            *number == first && nearest.is_some_and(|(number, _)| number == first)
        };
        let is_within = seen.len() == rays.len() && seen.iter().all(is_around);
        let name = self.world.object_name(first);

        let world = self.recorded(Instruments::LESSON).world;
        let mut lights = Lights::default();
        for (ray, _) in &seen {
            let (_, steps) = steps::traced(|| world.radiance(ray, settings.depth));
            for step in &steps {
                match (step.kind, &step.outcome) {
                    (StepKind::Ambient, _) => lights.materials += 1,
                    (StepKind::Light, Outcome::Arrives) => return None,
                    (StepKind::Light, Outcome::Dark) => lights.dark += 1,
                    (StepKind::Light, Outcome::BehindSurface) => lights.behind += 1,
                    (StepKind::Light, Outcome::BlockedBy(object)) => {
                        lights.blocked += 1;
                        lights.blocker.clone_from(object);
                    }
                    _ => (),
                }
            }
        }
        lights.reason(is_within.then_some(name))
    }

    /// What to say of a camera whose rays meet nothing.
    fn looks_away(&self, rays: &[Ray], size: Size) -> String {
        let (column, row) = (size.width() / 2, size.height() / 2);
        let (x, y) = camera_coordinates(size, column, row, (0.0, 0.0));
        let ray = self.camera.ray_for(size, x, y);
        let is_behind = |ray: &Ray| {
            let behind = Ray::derived(ray.origin(), -ray.direction());
            self.world.nearest(&behind).is_some()
        };
        let away = if rays.iter().any(is_behind) {
            "away from what is behind it"
        } else {
            "past all objects"
        };
        let (eye, gaze) = (array(ray.origin()), array(ray.direction()));
        format!(
            "no ray meets an object: the camera at {} looks along {}, {away}",
            digits(&eye),
            digits(&gaze)
        )
    }
}

/// Rays through the middles of equal parts of a picture.
fn rays(camera: &dyn Camera, size: Size) -> Vec<Ray> {
    let mut rays = Vec::new();
    let middle = |part: u32, side: u32| (2 * part + 1) * side / (2 * RAYS);
    for row in 0..RAYS {
        for column in 0..RAYS {
            let [column, row] = [middle(column, size.width()), middle(row, size.height())];
            let (x, y) = camera_coordinates(size, column, row, (0.5, 0.5));
            rays.push(camera.ray_for(size, x, y));
        }
    }
    rays
}

/// What became of the light of all lamps at all places that the rays meet; none of it arrives.
#[derive(Default)]
struct Lights {
    /// The places whose material asks for light.
    materials: usize,
    /// Times that a lamp does not shine at a place.
    dark: usize,
    behind: usize,
    blocked: usize,
    blocker: String,
}

impl Lights {
    /// Why no light arrives, if the camera is within the object of this name or within none.
    fn reason(&self, around: Option<String>) -> Option<String> {
        if self.materials == 0 {
            return None;
        }
        let reason = match (self.dark, self.behind, self.blocked, around) {
            (0, 0, 0, _) => "the scene has no light: no lamp, and no ambient light".to_owned(),
            (.., Some(object)) => format!("the camera is within {object}, where no light gets"),
            (_, 0, 0, _) => "every spot light is turned away from what is seen".to_owned(),
            (0, _, 0, _) => "every lamp is behind the surfaces that are seen".to_owned(),
            (0, 0, ..) => format!(
                "all light is blocked before what is seen, by {}",
                self.blocker
            ),
            _ => format!(
                "no light reaches what is seen: {} times a lamp is turned away, {} times behind the \
                 surface, {} times blocked",
                self.dark, self.behind, self.blocked
            ),
        };
        Some(reason)
    }
}
