//! `Moved`: a pixel while one number of its scene file is moved.

use super::{Channels, Footprint, NumberPlace, PIXEL, Pixel, State, Unit, minus};
use crate::steps::StepKind;
use crate::{Settings, Traced};

/// A pixel, and a number of its scene file.
pub(super) struct Moved<'a> {
    pub scene: &'a dyn Traced,
    pub settings: &'a Settings,
    pixel: [u32; 2],
    pub number: &'a NumberPlace,
    /// Whether another value moves things: a colour changes no decision.
    pub moves_things: bool,
    /// How far edges are looked for.
    pub reach: f64,
}

impl<'a> Moved<'a> {
    pub(super) fn new(
        scene: &'a dyn Traced,
        settings: &'a Settings,
        pixel: [u32; 2],
        number: &'a NumberPlace,
        footprint: Footprint,
    ) -> Self {
        let mut moved = Self {
            scene,
            settings,
            pixel,
            number,
            moves_things: !matches!(number.unit, Unit::Channel | Unit::Factor),
            reach: footprint.reach(number, PIXEL),
        };
        moved.limit_reach(footprint);
        moved
    }

    /// Shortens the reach where half a pixel is less. A camera may turn far more than the footprint
    /// tells: towards a point near the eye. So its ray is compared with that of a camera that has moved
    /// a little.
    fn limit_reach(&mut self, footprint: Footprint) {
        let (value, little) = (self.number.value, self.reach / 1024.0);
        let distance = footprint.width / footprint.angle;
        let seen = [value, value + little].map(|value| self.camera_ray_at(value, distance));
        let [Some(before), Some(after)] = seen else {
            return;
        };
        let moved = minus(after, before);
        let moved = (moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2]).sqrt();
        let longest = PIXEL * footprint.width / moved * little;
        if longest < self.reach {
            self.reach = longest;
        }
    }

    /// The scene with a value of the number; none if it is not allowed.
    fn scene_at(&self, value: f64) -> Option<Box<dyn Traced>> {
        self.scene.with(self.settings, &[(self.number, value)])
    }

    /// The colour of the pixel in a scene; none if it is not finite.
    fn color_in(&self, scene: &dyn Traced) -> Option<Channels> {
        let color = scene.color(self.settings, self.pixel).ok()?;
        color.is_finite().then(|| color.channels())
    }

    /// The pixel in a scene; without margins if the number moves nothing.
    pub(super) fn state_in(&self, scene: &dyn Traced) -> Option<State> {
        if !self.moves_things {
            let (color, margins) = (self.color_in(scene)?, Vec::new());
            return Some(State { color, margins });
        }
        State::of(&scene.trace(self.settings, self.pixel).ok()?)
    }

    /// The point on the first ray of the pixel at this distance.
    fn camera_ray_at(&self, value: f64, distance: f64) -> Option<[f64; 3]> {
        if self.number.table != "[camera]" {
            return None;
        }
        let trace = self.scene_at(value)?.trace(self.settings, self.pixel);
        let trace = trace.ok()?;
        let mut steps = trace.steps.iter();
        let ray = steps.find(|step| step.kind == StepKind::CameraRay)?;
        let (o, d): ([f64; 3], [f64; 3]) = (ray.value("o")?, ray.value("d")?);
        Some(std::array::from_fn(|i| o[i] + distance * d[i]))
    }
}

impl Pixel for Moved<'_> {
    fn color(&self, value: f64) -> Option<Channels> {
        self.color_in(&*self.scene_at(value)?)
    }

    fn state(&self, value: f64) -> Option<State> {
        self.state_in(&*self.scene_at(value)?)
    }
}
