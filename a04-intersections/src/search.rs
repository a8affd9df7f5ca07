//! `Search`: a world prepared for rays, so that each asks only the shapes that
//! it may meet.
//!
//! The answer is that of the plain list, to the last bit: whoever is asked
//! answers with the very formula of its shape, and who is not asked would have
//! said no. What is gained is who need not be asked.

mod build;
mod sphere_block;
mod tree;
mod triangle_block;

use std::any::Any;
use std::ops::ControlFlow;
use std::sync::Arc;

use a03_rays_cameras::Ray;

use crate::{Bounds, Geometry, Hit, Interval, Sphere, Triangle};
use sphere_block::{SphereBlock, SphereRay};
use tree::{Tree, WIDTH};
use triangle_block::{TriangleBlock, TriangleRay};

/// What of a world can be asked by a ray, in the order of its list.
#[derive(Debug)]
pub struct Search {
    parts: Vec<Part>,
    /// Those without bounds.
    always: Vec<u32>,
    spheres: Option<Tree<SphereBlock>>,
    triangles: Option<Tree<TriangleBlock>>,
    others: Option<Tree<[u32; WIDTH]>>,
}

/// A geometry, and the number of the object that it is part of.
#[derive(Debug)]
struct Part {
    geometry: Arc<dyn Geometry>,
    object: u32,
}

impl Search {
    /// The search of the objects with these geometries.
    pub fn new<'a>(geometries: impl Iterator<Item = &'a Arc<dyn Geometry>>) -> Self {
        let mut parts = Vec::new();
        for (object, geometry) in (0..).zip(geometries) {
            match geometry.parts() {
                Some(several) => {
                    parts.extend(
                        several
                            .into_iter()
                            .map(|geometry| Part { geometry, object }),
                    );
                }
                None => parts.push(Part {
                    geometry: Arc::clone(geometry),
                    object,
                }),
            }
        }

        let mut always = Vec::new();
        let (mut spheres, mut triangles, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for (number, part) in (0..).zip(&parts) {
            let bounds = part.geometry.bounds();
            if !bounds.are_finite() {
                always.push(number);
            } else if part.is::<Sphere>() {
                spheres.push((bounds, number));
            } else if part.is::<Triangle>() {
                triangles.push((bounds, number));
            } else {
                others.push((bounds, number));
            }
        }
        Self {
            spheres: tree(spheres, |numbers| {
                SphereBlock::new(&copies(&parts, numbers))
            }),
            triangles: tree(triangles, |numbers| {
                TriangleBlock::new(&copies(&parts, numbers))
            }),
            others: tree(others, |numbers| {
                std::array::from_fn(|i| numbers.get(i).copied().unwrap_or(u32::MAX))
            }),
            parts,
            always,
        }
    }

    /// The nearest hit within the interval and the object hit; of several at
    /// the same place, that of the first in the list.
    pub fn hit(&self, ray: &Ray, within: Interval) -> Option<(Hit, usize)> {
        let mut nearest = Nearest {
            ray,
            within,
            found: None,
        };
        let _ = self.ask(ray, within, |number, geometry| {
            nearest.ask(number, geometry);
            ControlFlow::Continue(nearest.within.max)
        });
        let (hit, number) = nearest.found?;
        Some((hit, self.parts[number as usize].object as usize))
    }

    /// Whether anything at all is met within the interval.
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        self.ask(ray, within, |_, geometry| {
            if geometry.hit(ray, within).is_some() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(within.max)
            }
        })
        .is_break()
    }

    /// Asks the parts that the ray may meet within the interval, until `visit`
    /// breaks off; it returns the `t` beyond which nothing is wanted any more.
    #[inline(always)]
    fn ask(
        &self,
        ray: &Ray,
        mut within: Interval,
        mut visit: impl FnMut(u32, &dyn Geometry) -> ControlFlow<(), f64>,
    ) -> ControlFlow<()> {
        for number in &self.always {
            within.max = visit(*number, &*self.parts[*number as usize].geometry)?;
        }
        if let Some(tree) = &self.spheres {
            let sphere_ray = SphereRay::new(ray);
            within.max = tree.search(ray, within, |block, mut max| {
                for lane in bits(block.met(&sphere_ray)) {
                    max = visit(block.numbers[lane], &block.sphere(lane))?;
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let Some(tree) = &self.triangles {
            let triangle_ray = TriangleRay::new(ray);
            within.max = tree.search(ray, within, |block, mut max| {
                for lane in bits(block.met(&triangle_ray)) {
                    let number = block.numbers[lane];
                    if let Some(part) = self.parts.get(number as usize) {
                        max = visit(number, &*part.geometry)?;
                    }
                }
                ControlFlow::Continue(max)
            })?;
        }
        if let Some(tree) = &self.others {
            tree.search(ray, within, |block, mut max| {
                for number in block {
                    if let Some(part) = self.parts.get(*number as usize) {
                        max = visit(*number, &*part.geometry)?;
                    }
                }
                ControlFlow::Continue(max)
            })?;
        }
        ControlFlow::Continue(())
    }
}

impl Part {
    fn is<G: Geometry>(&self) -> bool {
        let geometry: &dyn Any = &*self.geometry;
        geometry.is::<G>()
    }
}

/// The parts of these numbers, which are of the type `G`.
fn copies<G: Geometry + Copy>(parts: &[Part], numbers: &[u32]) -> Vec<(G, u32)> {
    let copy = |number: &u32| {
        let geometry: &dyn Any = &*parts[*number as usize].geometry;
        geometry.downcast_ref::<G>().map(|g| (*g, *number))
    };
    numbers.iter().filter_map(copy).collect()
}

fn tree<B>(shapes: Vec<(Bounds, u32)>, block: impl FnMut(&[u32]) -> B) -> Option<Tree<B>> {
    (!shapes.is_empty()).then(|| Tree::new(shapes, block))
}

/// The numbers of the bits that are set.
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
    ray: &'a Ray,
    within: Interval,
    found: Option<(Hit, u32)>,
}

impl Nearest<'_> {
    fn ask(&mut self, number: u32, geometry: &dyn Geometry) {
        // At the same place the first of the list counts, whenever it is asked.
        let wins_ties = self.found.is_some_and(|(_, found)| number < found);
        let max = if wins_ties {
            self.within.max.next_up()
        } else {
            self.within.max
        };
        if let Some(hit) = geometry.hit(self.ray, Interval { max, ..self.within }) {
            self.within.max = hit.t;
            self.found = Some((hit, number));
        }
    }
}
