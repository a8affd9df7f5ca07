//! `Renderer`: a scene and a camera, prepared for rendering.

use common::{Bound, Color, Error, Image, Plan, Progress, Settings};

use crate::accel::Accelerator;
use crate::adaptive;
use crate::flatten::flatten;
use crate::lanes::{RayPacket, in_fours};
use crate::shade::RadianceBound;
use crate::trace::{Batch, Tracer};
use crate::view::View;
use crate::{Camera, Ray, Sampler, Scene};

/// The share of the allowed error for reflections that are cut off. The samples may use
/// all of it, because the sum of both squares is hardly larger.
const OF_MIRRORS: f64 = 1.0 / 8.0;

/// A scene and a camera, prepared for rendering.
#[derive(Debug)]
pub struct Renderer<'a> {
    pub(crate) camera: Camera<'a>,
    pub(crate) tracer: Tracer<'a>,
    /// Upper bound of the displacement of flattened shapes, as a share of the scene, and
    /// their number.
    flattened: (f64, usize),
}

impl<'a> Renderer<'a> {
    /// Prepares a scene. Where the settings allow an error, nested transforms are
    /// flattened and reflections cut off within their share of it.
    #[must_use]
    pub fn new(scene: Scene<'a>, camera: Camera<'a>, settings: &Settings) -> Self {
        let Scene {
            background,
            ambient,
            depth,
            mut shapes,
            surfaces,
            lights,
        } = scene;
        let mut flattened = (0.0_f64, 0);
        if let Some(max_error) = settings.max_error {
            let max_distance = max_distance(shapes.bounds(), &camera);
            for shape in &mut shapes.transformed.shapes {
                if let Some(displacement) = flatten(shape, max_distance, max_error) {
                    flattened = (
                        flattened.0.max(displacement / max_distance),
                        flattened.1 + 1,
                    );
                }
            }
        }
        let accelerator = Accelerator::new(shapes);
        let cutoff = settings.max_error.map(|max_error| {
            let threshold = max_error * OF_MIRRORS;
            RadianceBound::new(background, ambient, &lights, &surfaces, threshold)
        });
        let tracer = Tracer {
            background,
            ambient,
            depth,
            accelerator,
            surfaces,
            lights,
            cutoff,
        };
        Self {
            camera,
            tracer,
            flattened,
        }
    }

    /// Computes the light along some rays. `light` has one element for each ray.
    pub fn trace(&self, rays: &[Ray], light: &mut [Color]) {
        let fours = in_fours(rays);
        let packets: Vec<_> = fours.map(|four| RayPacket::new(four.each_ref())).collect();
        self.tracer.trace(&packets, light, &mut Batch::default());
    }

    /// Renders a picture.
    ///
    /// [`Error::Stopped`] if `progress` stops the rendering, [`Error::Memory`] if the
    /// picture does not fit into memory.
    pub fn render(
        &self,
        sampler: &impl Sampler,
        settings: &Settings,
        progress: &dyn Progress,
    ) -> Result<Image, Error> {
        let view = View {
            renderer: self,
            settings,
            progress,
        };
        match settings.max_error {
            Some(max_error) => adaptive::render_image(max_error, &view, settings, progress),
            None => view.render(sampler),
        }
    }

    /// Adds to a plan the work that the engine skips.
    #[must_use]
    pub fn plan(&self, plan: Plan) -> Plan {
        let Tracer {
            accelerator,
            surfaces,
            cutoff,
            ..
        } = &self.tracer;
        let mut plan = accelerator.plan(plan);
        let unlit = surfaces
            .iter()
            .filter(|surface| !surface.responds_to_light());
        let unlit = unlit.count();
        if unlit > 0 {
            plan = plan.without(
                format!("light on {unlit} of {} surfaces", surfaces.len()),
                "their colour does not depend on it",
            );
        }
        if let (displacement, count @ 1..) = self.flattened {
            plan = plan.nearly_without(
                format!("the nested transforms of {count} shapes"),
                "one matrix moves a ray as far as all in turn",
                Bound::Shift(displacement),
            );
        }
        match cutoff {
            Some(cutoff) if surfaces.iter().any(|s| s.reflection != Color::BLACK) => plan
                .nearly_without(
                    "reflected rays that nobody could see",
                    "the light that they can bring back is bounded",
                    Bound::Channel(cutoff.threshold()),
                ),
            _ => plan,
        }
    }
}

/// The largest distance from the origin of the eye and of bounded shapes.
fn max_distance(
    bounds: impl Iterator<Item = (impl Sized, crate::shape::Bounds)>,
    camera: &Camera,
) -> f64 {
    let eye = match camera {
        Camera::Perspective { basis, .. } => basis.e.length(),
        _ => 0.0,
    };
    let bounded = bounds.filter(|(_, bounds)| bounds.are_finite());
    let corners = bounded.flat_map(|(_, bounds)| bounds.corners());
    corners.map(glam::DVec3::length).fold(eye, f64::max)
}
