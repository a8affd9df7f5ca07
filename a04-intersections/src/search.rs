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
mod tree;
mod triangle_block;

use std::ops::ControlFlow;
use std::sync::Arc;

use a03_rays_cameras::{Focus, Ray};

use crate::{Bounds, Geometry, Hit, Interval};
use pencil::Pencil;
use shapes::{Asking, Shape, Shapes, Turn};
use sphere_block::{SphereBlock, SphereRay};
use tree::Tree;
use triangle_block::{TriangleBlock, TriangleRay};

/// What of a world can be asked by a ray.
#[derive(Debug)]
pub struct Search {
    shapes: Shapes,
    /// Those without bounds, and those of kinds of which there are few.
    always: Vec<Shape>,
    spheres: Option<Tree<SphereBlock>>,
    triangles: Option<Tree<TriangleBlock>>,
    others: Option<Tree<Vec<Shape>>>,
    /// Those without bounds.
    unbounded: Vec<Shape>,
    pencils: Vec<Pencil>,
}

/// Up to so many shapes are asked sooner than a tree.
const FEW: usize = 3;

impl Search {
    /// The search of the objects with these geometries, by rays of which many
    /// go through some foci.
    pub fn new<'a>(
        geometries: impl Iterator<Item = &'a Arc<dyn Geometry>>,
        foci: impl IntoIterator<Item = Focus>,
    ) -> Self {
        let mut shapes = Shapes::default();
        let (mut bounded, mut unbounded) = (Vec::new(), Vec::new());
        let (mut turns, mut objects) = (0.., 0..);
        let mut add = |geometry: &Arc<dyn Geometry>, object| {
            let turn = turns.next().unwrap_or(u32::MAX);
            let shape = shapes.push(geometry, Turn { turn, object });
            let bounds = geometry.bounds();
            if bounds.are_finite() {
                bounded.push((bounds, shape));
            } else {
                unbounded.push(shape);
            }
        };
        for geometry in geometries {
            let object = objects.next().unwrap_or(u32::MAX);
            match geometry.parts() {
                Some(parts) => parts.iter().for_each(|part| add(part, object)),
                None => add(geometry, object),
            }
        }

        let pencils = foci.into_iter();
        let pencils = pencils
            .filter_map(|focus| Pencil::new(focus, &bounded))
            .collect();
        let (spheres, rest): (Vec<_>, Vec<_>) = bounded
            .into_iter()
            .partition(|(_, shape)| matches!(shape, Shape::Sphere(_)));
        let (triangles, others): (Vec<_>, Vec<_>) = rest
            .into_iter()
            .partition(|(_, shape)| matches!(shape, Shape::Triangle(_)));

        let mut always = unbounded.clone();
        let spheres = tree(spheres, &mut always, |block| {
            SphereBlock::new(&shapes, block)
        });
        let triangles = tree(triangles, &mut always, |block| {
            TriangleBlock::new(&shapes, block)
        });
        let others = tree(others, &mut always, <[Shape]>::to_vec);
        Self {
            shapes,
            always,
            spheres,
            triangles,
            others,
            unbounded,
            pencils,
        }
    }

    /// The nearest hit within the interval and the object hit; of several at
    /// the same place, that of the first in the list.
    #[inline]
    pub fn hit(&self, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
        let mut nearest = Nearest {
            search: self,
            asking: Asking::new(ray, &self.shapes),
            within,
            found: None,
        };
        let of_pencil = self.pencils.iter().find_map(|pencil| pencil.outwards(ray));
        if let Some((entries, start)) = of_pencil {
            for shape in &self.unbounded {
                nearest.ask(*shape);
            }
            for entry in entries {
                if f64::from(entry.near) - start > nearest.within.max {
                    break;
                }
                nearest.ask(entry.shape);
            }
        } else {
            let asking = nearest.asking;
            let _ = self.ask(&asking, within, |shape| {
                nearest.ask(shape);
                ControlFlow::Continue(nearest.within.max)
            });
        }
        let (hit, shape) = nearest.found?;
        Some((hit, self.shapes.turn(shape).object as usize))
    }

    /// Whether anything at all is met within the interval.
    #[inline]
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        let asking = Asking::new(ray, &self.shapes);
        let is_hit = |shape: Shape| asking.hit(&self.shapes, shape, within).is_some();
        let of_pencil = self
            .pencils
            .iter()
            .find_map(|pencil| pencil.inwards(ray, within));
        if let Some((entries, start)) = of_pencil {
            let between = entries
                .iter()
                .take_while(|entry| f64::from(entry.near) <= start);
            return between.map(|entry| entry.shape).any(is_hit)
                || self.unbounded.iter().copied().any(is_hit);
        }
        self.ask(&asking, within, |shape| {
            if is_hit(shape) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(within.max)
            }
        })
        .is_break()
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
        for shape in &self.always {
            within.max = visit(*shape)?;
        }
        if let Some(tree) = &self.spheres {
            let sphere_ray = SphereRay::new(ray);
            within.max = tree.search(ray, within, |block, mut max| {
                for lane in bits(block.met(&sphere_ray)) {
                    max = visit(Shape::Sphere(block.spheres[lane]))?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let (Some(tree), Some(sheared)) = (&self.triangles, &asking.sheared) {
            let triangle_ray = TriangleRay::new(sheared);
            within.max = tree.search(ray, within, |block, mut max| {
                for lane in bits(block.met(&triangle_ray)) {
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
    always: &mut Vec<Shape>,
    block: impl FnMut(&[Shape]) -> B,
) -> Option<Tree<B>> {
    if shapes.len() <= FEW {
        always.extend(shapes.iter().map(|(_, shape)| *shape));
        return None;
    }
    Some(Tree::new(shapes, block))
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
    search: &'a Search,
    asking: Asking<'a>,
    within: Interval,
    found: Option<(Hit, Shape)>,
}

impl Nearest<'_> {
    #[inline]
    fn ask(&mut self, shape: Shape) {
        let shapes = &self.search.shapes;
        let Some(hit) = self.asking.hit(shapes, shape, self.within) else {
            return;
        };
        if let Some((found, other)) = self.found
            && found.t == hit.t
            && shapes.turn(other).turn < shapes.turn(shape).turn
        {
            return;
        }
        // At the same place the first of the list counts, whenever it is asked.
        self.within.max = hit.t.next_up();
        self.found = Some((hit, shape));
    }
}
