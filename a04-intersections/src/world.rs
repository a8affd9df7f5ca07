//! `World`: everything that is to be seen.

use std::sync::Arc;

use a02_math::{Direction, Vector3};
use a03_rays_cameras::{Focus, Ray};
use common::{ArgumentError, Color, Plan, argument};
use measure::tally::{self, Work};

use crate::search::Search;
use crate::{Geometry, Hit, Interval};

/// A background, and a plain list of geometries, each with its surface.
///
/// The surface is whatever the reader wants to know of a geometry that is hit:
/// here a [`Color`], later a material.
#[derive(Debug)]
pub struct World<S> {
    background: Color,
    objects: Vec<(Arc<dyn Geometry>, S)>,
    search: Option<Search>,
}

impl<S> World<S> {
    /// An empty world. The channels of its background are from 0
    /// to 1e50.
    pub fn new(background: Color) -> Result<Self, ArgumentError> {
        Ok(Self {
            background: argument::color("background", background)?,
            objects: Vec::new(),
            search: None,
        })
    }

    /// This world and one more object.
    #[must_use]
    pub fn with(mut self, geometry: impl Geometry + 'static, surface: S) -> Self {
        self.objects.push((Arc::new(geometry), surface));
        self.search = None;
        self
    }

    /// The same world, prepared for many rays, most of them from or to some
    /// foci: each asks only the objects that it may meet. What it meets is the
    /// same, to the last bit. Of few objects all are asked as before.
    #[must_use]
    pub fn prepared(mut self, foci: impl IntoIterator<Item = Focus>) -> Self {
        let geometries = self.objects.iter().map(|(geometry, _)| geometry);
        self.search = Some(Search::new(geometries, foci));
        self
    }

    /// The same world, not prepared, with another geometry in the place of each
    /// for which `other` has one.
    #[must_use]
    pub fn replacing(mut self, other: impl Fn(&dyn Geometry) -> Option<Arc<dyn Geometry>>) -> Self {
        for (geometry, _) in &mut self.objects {
            if let Some(other) = other(&**geometry) {
                *geometry = other;
            }
        }
        self.search = None;
        self
    }

    /// The search of a prepared world, for rays that ask together.
    #[must_use]
    pub const fn search(&self) -> Option<&Search> {
        self.search.as_ref()
    }

    /// The search for a single ray, if the world is prepared and it pays.
    fn search_for_one(&self) -> Option<&Search> {
        self.search().filter(|search| search.pays_for_one())
    }

    /// How many objects there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.objects.len()
    }

    /// Whether there is no object.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.objects.is_empty()
    }

    /// Adds to a plan what there is to be met.
    #[must_use]
    pub fn plan(&self, plan: Plan) -> Plan {
        let objects = self.objects.len();
        let plan = plan.needing(format!("objects: {objects}"));
        match self.search_for_one() {
            Some(search) => search.plan(plan),
            None => plan.without(
                "a search for a ray alone",
                "it asks so few objects one by one",
            ),
        }
    }

    /// The objects in the order of the list: geometries and surfaces.
    pub fn objects(&self) -> impl Iterator<Item = (&dyn Geometry, &S)> {
        let objects = self.objects.iter();
        objects.map(|(geometry, surface)| (&**geometry, surface))
    }

    /// The surface of an object, counted from 0 in the order of the list.
    #[must_use]
    pub fn surface(&self, object: usize) -> &S {
        &self.objects[object].1
    }

    /// The colour that a ray brings back if it meets nothing.
    #[must_use]
    pub const fn background(&self) -> Color {
        self.background
    }

    /// The nearest meeting within the interval and the surface met there; of
    /// several at the same place, that of the object listed first.
    ///
    /// Its normals are turned towards the side that the ray comes from, so that
    /// a shape looks right from inside, too.
    #[must_use]
    pub fn hit(&self, ray: &Ray, mut within: Interval) -> Option<(Hit, &S)> {
        if let Some(search) = self.search_for_one() {
            let (hit, object) = search.hit(ray, within)?;
            return Some((facing(hit, ray.direction()), &self.objects[object].1));
        }
        // ANCHOR: hit
        let mut nearest = None;
        tally::count_all(Work::IntersectionTest, self.objects.len() as u64);
        for (geometry, surface) in &self.objects {
            if let Some(hit) = geometry.hit(ray, within) {
                within.max = hit.t;
                nearest = Some((hit, surface));
            }
        }
        nearest.map(|(hit, surface)| (facing(hit, ray.direction()), surface))
        // ANCHOR_END: hit
    }

    /// Whether anything at all is met within the interval.
    #[must_use]
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        if let Some(search) = self.search_for_one() {
            return search.is_hit(ray, within);
        }
        let mut objects = self.objects.iter();
        objects.any(|(geometry, _)| {
            tally::count(Work::IntersectionTest);
            geometry.hit(ray, within).is_some()
        })
    }
}

/// The hit with its normals turned against the direction `d`.
fn facing(hit: Hit, d: Vector3) -> Hit {
    if hit.face.dot(d) > 0.0 {
        Hit {
            normal: -hit.normal,
            face: -hit.face,
            ..hit
        }
    } else {
        hit
    }
}

impl World<Color> {
    /// The colour that a ray brings back: that of the nearest object, or the
    /// background.
    #[must_use]
    pub fn color_for(&self, ray: &Ray) -> Color {
        let nearest = self.hit(ray, Interval::AHEAD);
        nearest.map_or(self.background, |(_, color)| *color)
    }
}
