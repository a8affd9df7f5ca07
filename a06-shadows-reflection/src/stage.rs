//! `traced_scene`: a world, as the recursive tracer shows it.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Sampler, render_together};
use common::{ArgumentError, Renderer, Scene, Settings};

use crate::{RecursiveTracer, ShadowedWorld, TracedLight, foci};

/// A scene whose camera looks from (`eye`, `eye`, `eye`) at the origin, as all
/// of this stage and the next do. `world` may heed the settings.
pub fn traced_scene(
    name: &'static str,
    about: &'static str,
    eye: f64,
    world: impl Fn(&Settings) -> Result<ShadowedWorld, ArgumentError> + Copy + Send + Sync + 'static,
) -> Scene {
    let camera = move || {
        let e = Point3::new(eye, eye, eye);
        let (g, t) = (Vector3::new(-1.0, -1.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
        PerspectiveCamera::new(e, g, t, FRAC_PI_4)
    };
    Scene::traced(name, about, move |settings, progress| {
        let (camera, world) = (camera()?, world(settings)?);
        let foci = foci(&camera, &world);
        let omit = settings.renderer != Renderer::AllWork;
        let world = world.omitting(omit, foci);
        let light = TracedLight {
            tracer: tracer(&world, omit, settings),
            depth: settings.depth,
        };
        render_together(&camera, light, settings, progress)
    })
    .planned(move |settings| {
        let (camera, world) = (camera()?, world(settings)?);
        let foci = foci(&camera, &world);
        let world = world.prepared(foci);
        Ok(tracer(&world, true, settings).plan(Sampler::plan(settings)))
    })
}

/// The share of the error allowed that mirrors may take; the samples take the
/// rest, and the squares of both add up to hardly more.
const UNSEEN: f64 = 1.0 / 8.0;

/// The tracer of a picture with these settings: where it may have an error, mirrors
/// have their share of that.
#[must_use]
pub fn tracer<'a>(
    world: &'a ShadowedWorld,
    omit: bool,
    settings: &Settings,
) -> RecursiveTracer<'a> {
    let unseen = settings.max_error.map(|error| error * UNSEEN);
    RecursiveTracer::new(world, omit).cut_below(unseen)
}
