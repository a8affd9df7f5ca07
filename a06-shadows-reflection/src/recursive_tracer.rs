//! `RecursiveTracer`: follows a ray from mirror to mirror.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a05_lighting::{Illumination, Light, Lighting, LitWorld};
use common::{Bound, Color, Plan};
use measure::tally::{self, Work};

use crate::cut::Cut;
use crate::shadow::has_occluder;
use crate::{LightSource, Surface, is_shadowed, secondary_ray};

/// A world of surfaces that may mirror and lights that may cast shadows.
pub type ShadowedWorld = LitWorld<Box<dyn Surface>, LightSource>;

/// Finds the colours that rays bring back from a world.
#[derive(Clone, Copy, Debug)]
pub struct RecursiveTracer<'a> {
    world: &'a ShadowedWorld,
    omit: bool,
    cut: Option<Cut>,
}

impl<'a> RecursiveTracer<'a> {
    /// A tracer of this world. If `omit`, it leaves out work that cannot change
    /// a colour: rays to lights behind a surface or that cast no shadows, whatever
    /// is behind the first thing in a light's way, and rays from surfaces that do
    /// not mirror.
    #[must_use]
    pub const fn new(world: &'a ShadowedWorld, omit: bool) -> Self {
        Self {
            world,
            omit,
            cut: None,
        }
    }

    /// The same tracer, which follows no mirrored ray whose light changes no
    /// channel by as much as `bound`, if there is one and work is left out.
    #[must_use]
    pub fn cut_below(mut self, bound: Option<f64>) -> Self {
        let bound = bound.filter(|_| self.omit);
        self.cut = bound.map(|bound| Cut::new(self.world, bound));
        self
    }

    pub(crate) const fn world(&self) -> &'a ShadowedWorld {
        self.world
    }

    pub(crate) const fn cut(&self) -> Option<Cut> {
        self.cut
    }

    /// The colour that a ray brings back which may meet `depth` surfaces; what
    /// the last of them mirrors stays black.
    ///
    /// By its definition this is a recursion: the colour of a surface is
    /// `c + cr f`, with its own colour `c`, the share `cr` that it mirrors, and
    /// the colour `f` that the reflected ray brings back. As each surface
    /// reflects one ray only, a loop can carry the product of all `cr` so far
    /// instead, and no depth overflows the stack.
    #[must_use]
    // ANCHOR: trace
    pub fn trace(&self, ray: &Ray, depth: u32) -> Color {
        let mut ray = *ray;
        let mut color = Color::BLACK;
        let mut mirrored = Color::WHITE;
        for met in 0..depth {
            if met > 0 {
                tally::count(Work::ReflectedRay);
            }
            let Some((hit, surface)) = self.world.objects().hit(&ray, Interval::AHEAD) else {
                return color + mirrored * self.world.objects().background();
            };
            color += mirrored * surface.color_for(&ray, &hit, self);
            mirrored = mirrored * surface.reflection();
            if self.omit && mirrored == Color::BLACK {
                break;
            }
            if self.cut.is_some_and(|cut| cut.is_due(mirrored)) {
                break;
            }
            let direction = (-ray.direction()).reflected_on(hit.normal);
            ray = secondary_ray(&ray, &hit, direction);
        }
        color
    }
    // ANCHOR_END: trace
}

impl RecursiveTracer<'_> {
    /// Adds to a plan what there is to be met, to be lit and to be mirrored.
    #[must_use]
    pub fn plan(&self, plan: Plan) -> Plan {
        let (objects, lights) = (self.world.objects().len(), self.world.lights().len());
        let sources = self.world.lights().iter();
        let casting = sources.filter(|source| source.casts_shadows()).count();
        let surfaces = self.world.objects().objects();
        let mirrors = surfaces.filter(|(_, surface)| surface.reflection() != Color::BLACK);
        let mirrors = mirrors.count();
        let mut plan = self.world.plan(plan);
        if let Some(search) = self.world.objects().search() {
            plan = search.plan_together(plan);
        }
        if casting < lights {
            plan = plan.without(
                format!("shadow rays to {} of {lights} lights", lights - casting),
                "no object keeps their light away",
            );
        }
        if casting > 0 {
            plan = plan
                .without(
                    "shadow rays from what faces away from a light",
                    "it is dark",
                )
                .without(
                    "the search behind the first object in the way of a light",
                    "one keeps it away as well as two",
                );
        }
        if mirrors < objects {
            plan = plan.without(
                format!(
                    "reflected rays from {} of {objects} objects",
                    objects - mirrors
                ),
                "they do not mirror",
            );
        }
        match self.cut {
            Some(cut) if mirrors > 0 => plan.nearly_without(
                "mirrored rays that nobody would see",
                "what they can bring back is bounded",
                Bound::Channel(cut.bound()),
            ),
            _ => plan,
        }
    }
}

/// The lights that shine on the hit and that nothing keeps away from it.
impl Lighting for RecursiveTracer<'_> {
    fn ambient(&self) -> Color {
        self.world.ambient()
    }

    fn for_each_light(&self, ray: &Ray, hit: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        let point = ray.at(hit.t);
        for source in self.world.lights() {
            let Some(light) = source.illumination(point) else {
                continue;
            };
            if self.omit && hit.normal.dot(light.direction) <= 0.0 {
                continue;
            }
            let objects = self.world.objects();
            let is_shadowed = if self.omit {
                source.casts_shadows() && is_shadowed(objects, ray, hit, &light)
            } else {
                has_occluder(objects, ray, hit, &light) && source.casts_shadows()
            };
            if !is_shadowed {
                shade(&light);
            }
        }
    }

    fn omits(&self) -> bool {
        self.omit
    }
}
