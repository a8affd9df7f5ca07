//! `Search`: a world prepared for rays, so that each asks only the shapes that
//! it may meet.
//!
//! The answer is that of the plain list, to the last bit: whoever is asked
//! answers with the very formula of its shape, and who is not asked would have
//! said no. What is gained is who need not be asked.

mod build;
mod pencil;
mod shapes;
mod sphere_block;
mod together;
mod tree;
mod triangle_block;

use std::ops::ControlFlow;
use std::sync::{Arc, OnceLock};

use a03_rays_cameras::{Focus, Ray};

use common::Plan;
use measure::tally::{self, Work};

use crate::{Bounds, Geometry, Hit, Interval};
use pencil::Pencil;
use shapes::{Asking, Shape, Shapes};
use sphere_block::{SphereBlock, SphereRay};
use tree::{Tree, WIDTH};
use triangle_block::{TriangleBlock, TriangleRay};

pub use together::Hits;

/// So many shapes a single ray asks sooner one by one than searching.
const FEW_FOR_ONE: usize = 4;
/// The same, for four rays that ask together and belong to no pencil.
const FEW_FOR_FOUR: usize = 16;

/// What of a world can be asked by a ray.
#[derive(Debug)]
pub struct Search {
    shapes: Shapes,
    pays_for_one: bool,
    unbounded: Vec<Shape>,
    /// The bounded shapes, if they are so few that four rays sooner ask all.
    few: Option<Vec<Shape>>,
    pencils: Vec<Pencil>,
    /// For rays of no pencil. Where nothing mirrors there may be none.
    trees: OnceLock<Trees>,
}

impl Search {
    /// The search of the objects with these geometries, by rays of which many
    /// go through some foci.
    pub(crate) fn new<'a>(
        geometries: impl Iterator<Item = &'a Arc<dyn Geometry>>,
        foci: impl IntoIterator<Item = Focus>,
    ) -> Self {
        let mut shapes = Shapes::default();
        let mut has_parts = false;
        for (object, geometry) in (0..).zip(geometries) {
            match geometry.parts() {
                Some(parts) => {
                    has_parts = true;
                    for part in &parts {
                        shapes.push(part, object);
                    }
                }
                None => shapes.push(geometry, object),
            }
        }
        let (bounded, unbounded): (Vec<_>, Vec<_>) =
            shapes.bounds().partition(|(bounds, _)| bounds.are_finite());
        let pencils = foci.into_iter();
        let are_few = bounded.len() <= FEW_FOR_FOUR;
        Self {
            pays_for_one: has_parts || shapes.len() > FEW_FOR_ONE,
            few: are_few.then(|| bounded.iter().map(|(_, shape)| *shape).collect()),
            unbounded: unbounded.into_iter().map(|(_, shape)| shape).collect(),
            pencils: pencils
                .filter_map(|focus| Pencil::new(focus, &bounded))
                .collect(),
            trees: OnceLock::new(),
            shapes,
        }
    }

    /// Whether a single ray finds its hits sooner than by asking all in turn.
    #[inline]
    pub(crate) fn pays_for_one(&self) -> bool {
        self.pays_for_one
    }

    /// Adds to a plan what need not be asked.
    pub(crate) fn plan(&self, plan: Plan) -> Plan {
        let plan = if self.pencils.is_empty() {
            plan
        } else {
            plan.without(
                "questions to objects beside a ray of the eye or to a light",
                "cells, seen from there, list what each of these rays may meet",
            )
        };
        if self.shapes.len() - self.unbounded.len() <= FEW {
            plan.without("a tree of bounds", "so few objects are asked one by one")
        } else {
            plan.without(
                "questions to objects far from any other ray",
                "a tree of bounds finds those that it may meet",
            )
        }
    }

    /// Adds to a plan what four rays that ask together need not ask, where each of
    /// them alone would ask all.
    #[must_use]
    pub fn plan_together(&self, plan: Plan) -> Plan {
        if self.pays_for_one || self.pencils.is_empty() {
            return plan;
        }
        plan.without(
            "questions to objects beside four rays of the eye or to a light",
            "cells, seen from there, list what these may meet, and they ask together",
        )
    }

    /// Whether something may be seen between four rays, the corners of a square, that
    /// is narrower than this share of its side.
    #[must_use]
    pub fn may_hide(&self, corners: &[Ray; 4], narrow: f64) -> bool {
        // Planes are wide; of others that have no end nothing is known.
        let is_wide = |shape: &Shape| matches!(shape, Shape::Plane(_));
        if !self.unbounded.iter().all(is_wide) {
            return true;
        }
        if self.unbounded.len() == self.shapes.len() {
            return false;
        }
        let mut pencils = self.pencils.iter();
        pencils
            .find_map(|pencil| pencil.may_hide(corners, narrow))
            .unwrap_or(true)
    }

    /// The nearest hit within the interval and the object hit; of several at
    /// the same place, that of the first in the list.
    #[inline]
    pub(crate) fn hit(&self, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
        let asking = Asking::new(ray, &self.shapes);
        let mut nearest = Nearest {
            asking: &asking,
            within,
            found: None,
        };
        for shape in &self.unbounded {
            nearest.ask(*shape);
        }
        let of_pencil = self.pencils.iter().find_map(|pencil| pencil.outwards(ray));
        if let Some((entries, near)) = of_pencil {
            for entry in entries {
                if f64::from(entry.near) > near(nearest.within.max) {
                    break;
                }
                nearest.ask(entry.shape);
            }
        } else {
            self.trees().hit(&mut nearest);
        }
        let (hit, shape) = nearest.found?;
        Some((hit, self.shapes.turn(shape).object as usize))
    }

    /// Whether anything at all is met within the interval.
    #[inline]
    pub(crate) fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        let asking = Asking::new(ray, &self.shapes);
        let is_hit = |shape: &Shape| asking.hit(*shape, within).is_some();
        if self.unbounded.iter().any(is_hit) {
            return true;
        }
        for pencil in &self.pencils {
            if let Some(mut shapes) = pencil.inwards(ray, within) {
                return shapes.any(|shape| is_hit(&shape));
            }
        }
        self.trees().is_hit(&asking, within)
    }

    #[inline]
    fn trees(&self) -> &Trees {
        self.trees.get_or_init(|| Trees::new(&self.shapes))
    }
}

/// The bounded shapes: one tree for each kind that is met in a way of its own,
/// unless there are few.
#[derive(Debug)]
struct Trees {
    /// Those that are asked always.
    few: Vec<Shape>,
    spheres: Option<Tree<SphereBlock>>,
    triangles: Option<Tree<TriangleBlock>>,
    others: Option<Tree<Vec<Shape>>>,
}

/// Up to so many shapes are asked sooner than a tree.
const FEW: usize = 3;

impl Trees {
    fn new(shapes: &Shapes) -> Self {
        let (mut spheres, mut triangles, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for (bounds, shape) in shapes.bounds().filter(|(bounds, _)| bounds.are_finite()) {
            match shape {
                Shape::Sphere(_) => spheres.push((bounds, shape)),
                Shape::Triangle(_) => triangles.push((bounds, shape)),
                _ => others.push((bounds, shape)),
            }
        }
        let mut few = Vec::new();
        Self {
            spheres: tree(spheres, &mut few, |block| SphereBlock::new(shapes, block)),
            triangles: tree(triangles, &mut few, |block| {
                TriangleBlock::new(shapes, block)
            }),
            others: tree(others, &mut few, <[Shape]>::to_vec),
            few,
        }
    }

    /// Asks for a nearer hit.
    #[inline(never)]
    fn hit(&self, nearest: &mut Nearest) {
        let (asking, within) = (nearest.asking, nearest.within);
        let _ = self.ask(asking, within, |shape| {
            nearest.ask(shape);
            ControlFlow::Continue(nearest.within.max)
        });
    }

    /// Asks for any hit.
    #[inline(never)]
    fn is_hit(&self, asking: &Asking, within: Interval) -> bool {
        let ask = |shape| match asking.hit(shape, within) {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(within.max),
        };
        self.ask(asking, within, ask).is_break()
    }

    /// Visits the shapes that the ray may meet within the interval, until
    /// `visit` breaks off; it returns the `t` beyond which nothing is wanted.
    #[inline]
    fn ask(
        &self,
        asking: &Asking,
        mut within: Interval,
        mut visit: impl FnMut(Shape) -> ControlFlow<(), f64>,
    ) -> ControlFlow<()> {
        let ray = asking.ray;
        for shape in &self.few {
            within.max = visit(*shape)?;
        }
        if let Some(tree) = &self.spheres {
            let sphere_ray = SphereRay::new(ray);
            within.max = tree.search(ray, within, |block, mut max| {
                let met = block.met(&sphere_ray);
                count_unmet(&block.spheres, met);
                for lane in bits(met) {
                    max = visit(Shape::Sphere(block.spheres[lane]))?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let Some(tree) = &self.triangles {
            let triangle_ray = TriangleRay::new(asking.sheared());
            within.max = tree.search(ray, within, |block, mut max| {
                let met = block.met(&triangle_ray);
                count_unmet(&block.triangles, met);
                for lane in bits(met) {
                    max = visit(Shape::Triangle(block.triangles[lane]))?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let Some(tree) = &self.others {
            tree.search(ray, within, |block, mut max| {
                for shape in block {
                    max = visit(*shape)?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        ControlFlow::Continue(())
    }
}

/// A tree of these shapes, or none if they are few.
fn tree<B>(
    shapes: Vec<(Bounds, Shape)>,
    few: &mut Vec<Shape>,
    block: impl FnMut(&[Shape]) -> B,
) -> Option<Tree<B>> {
    if shapes.len() <= FEW {
        few.extend(shapes.iter().map(|(_, shape)| *shape));
        return None;
    }
    Some(Tree::new(shapes, block))
}

/// Notes that the shapes of a block were asked which are not met; the others are
/// asked once more, for all that there is to a hit.
#[inline]
fn count_unmet(block: &[u32; WIDTH], met: u32) {
    if tally::is_on() {
        let shapes = block.iter().filter(|index| **index != u32::MAX);
        let unmet = shapes.count() as u32 - met.count_ones();
        tally::count_all(Work::IntersectionTest, unmet.into());
    }
}

/// The numbers of the bits that are set.
#[inline]
fn bits(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = mask.trailing_zeros() as usize;
        (mask != 0).then(|| {
            mask &= mask - 1;
            bit
        })
    })
}

/// The nearest hit so far.
struct Nearest<'a> {
    asking: &'a Asking<'a>,
    within: Interval,
    found: Option<(Hit, Shape)>,
}

impl Nearest<'_> {
    #[inline]
    fn ask(&mut self, shape: Shape) {
        let Some(hit) = self.asking.hit(shape, self.within) else {
            return;
        };
        // At the same place the first of the list counts, whenever it is asked.
        if let Some((found, other)) = self.found
            && found.t == hit.t
            && self.asking.shapes.comes_before(other, shape)
        {
            return;
        }
        self.within.max = hit.t.next_up();
        self.found = Some((hit, shape));
    }
}
