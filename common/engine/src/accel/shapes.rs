//! `Shapes`: the shapes of a scene, sorted by kind, so that similar ones lie side by
//! side in memory and each is tested without a virtual call.

use std::cell::OnceCell;

use measure::tally::{self, Work};

use crate::shape::{
    AxisAlignedBox, Bounds, Disc, Other, Plane, Shape, ShearedRay, Sphere, Transformed, Triangle,
};
use crate::{Hit, Interval, Ray};

/// All shapes of a scene.
#[derive(Debug, Default)]
pub(crate) struct Shapes<'a> {
    /// All, in the order of the list.
    pub in_order: Vec<ShapeId>,
    pub spheres: Vec<(Sphere, Listed)>,
    pub triangles: Vec<(Triangle, Listed)>,
    pub boxes: Vec<(AxisAlignedBox, Listed)>,
    pub planes: Vec<(Plane, Listed)>,
    pub discs: Vec<(Disc, Listed)>,
    pub transformed: Vec<(Transformed<'a>, Listed)>,
    pub others: Vec<(Other<'a>, Listed)>,
}

/// The kind of a shape and its index among those of its kind.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ShapeId {
    Sphere(u32),
    Triangle(u32),
    Box(u32),
    Plane(u32),
    Disc(u32),
    Transformed(u32),
    Other(u32),
}

/// Position of a shape in the list, which breaks ties, and the index of its surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Listed {
    pub order: u32,
    pub surface: u32,
}

impl<'a> Shapes<'a> {
    /// Adds a shape to those of its kind.
    pub fn push(&mut self, shape: Shape<'a>, surface: u32) {
        fn push<T>(shapes: &mut Vec<(T, Listed)>, shape: T, listed: Listed) -> u32 {
            shapes.push((shape, listed));
            shapes.len() as u32 - 1
        }
        let order = self.in_order.len() as u32;
        let listed = Listed { order, surface };
        self.in_order.push(match shape {
            Shape::Sphere(shape) => ShapeId::Sphere(push(&mut self.spheres, shape, listed)),
            Shape::Triangle(shape) => ShapeId::Triangle(push(&mut self.triangles, shape, listed)),
            Shape::Box(shape) => ShapeId::Box(push(&mut self.boxes, shape, listed)),
            Shape::Plane(shape) => ShapeId::Plane(push(&mut self.planes, shape, listed)),
            Shape::Disc(shape) => ShapeId::Disc(push(&mut self.discs, shape, listed)),
            Shape::Transformed(shape) => {
                ShapeId::Transformed(push(&mut self.transformed, shape, listed))
            }
            Shape::Other(shape) => ShapeId::Other(push(&mut self.others, shape, listed)),
        });
    }

    /// How many shapes there are.
    pub fn len(&self) -> usize {
        self.in_order.len()
    }

    /// All shapes and their bounds.
    pub fn bounds(&self) -> impl Iterator<Item = (Bounds, ShapeId)> {
        fn of<T>(
            shapes: &[(T, Listed)],
            id: fn(u32) -> ShapeId,
            bounds: impl Fn(&T) -> Bounds,
        ) -> impl Iterator<Item = (Bounds, ShapeId)> {
            let numbered = (0..).zip(shapes);
            numbered.map(move |(i, (shape, _))| (bounds(shape), id(i)))
        }
        of(&self.spheres, ShapeId::Sphere, Sphere::bounds)
            .chain(of(&self.triangles, ShapeId::Triangle, Triangle::bounds))
            .chain(of(&self.boxes, ShapeId::Box, AxisAlignedBox::bounds))
            .chain(of(&self.planes, ShapeId::Plane, |_| Bounds::EVERYWHERE))
            .chain(of(&self.discs, ShapeId::Disc, Disc::bounds))
            .chain(of(&self.transformed, ShapeId::Transformed, |shape| {
                shape.bounds()
            }))
            .chain(of(&self.others, ShapeId::Other, |_| Bounds::EVERYWHERE))
    }

    /// Position in the list and surface of a shape.
    #[inline]
    pub fn listed(&self, shape: ShapeId) -> Listed {
        match shape {
            ShapeId::Sphere(i) => self.spheres[i as usize].1,
            ShapeId::Triangle(i) => self.triangles[i as usize].1,
            ShapeId::Box(i) => self.boxes[i as usize].1,
            ShapeId::Plane(i) => self.planes[i as usize].1,
            _ => self.listed_rare(shape),
        }
    }

    /// Like `listed`, for the kinds that are rare in large scenes.
    #[inline(never)]
    fn listed_rare(&self, shape: ShapeId) -> Listed {
        match shape {
            ShapeId::Disc(i) => self.discs[i as usize].1,
            ShapeId::Transformed(i) => self.transformed[i as usize].1,
            ShapeId::Other(i) => self.others[i as usize].1,
            _ => self.listed(shape),
        }
    }
}

/// A ray that is tested against shapes, with the numbers that are computed only once.
pub(crate) struct SingleRay<'r, 'a> {
    pub ray: &'r Ray,
    pub shapes: &'r Shapes<'a>,
    sheared: OnceCell<ShearedRay>,
}

impl<'r, 'a> SingleRay<'r, 'a> {
    #[inline]
    pub fn new(ray: &'r Ray, shapes: &'r Shapes<'a>) -> Self {
        Self {
            ray,
            shapes,
            sheared: OnceCell::new(),
        }
    }

    /// The ray as triangles need it.
    #[inline]
    pub fn sheared(&self) -> &ShearedRay {
        self.sheared.get_or_init(|| ShearedRay::new(self.ray))
    }

    /// Tests a shape.
    #[inline]
    pub fn hit(&self, shape: ShapeId, within: Interval) -> Option<Hit> {
        tally::count(Work::IntersectionTest);
        self.hit_uncounted(shape, within)
    }

    /// Like `hit`, for a test that is counted elsewhere.
    #[inline]
    pub fn hit_uncounted(&self, shape: ShapeId, within: Interval) -> Option<Hit> {
        let Self { ray, shapes, .. } = self;
        match shape {
            ShapeId::Sphere(i) => shapes.spheres[i as usize].0.hit(ray, within),
            ShapeId::Triangle(i) => shapes.triangles[i as usize].0.hit(self.sheared(), within),
            ShapeId::Box(i) => shapes.boxes[i as usize].0.hit(ray, within),
            ShapeId::Plane(i) => shapes.planes[i as usize].0.hit(ray, within),
            ShapeId::Disc(i) => shapes.discs[i as usize].0.hit(ray, within),
            ShapeId::Transformed(i) => shapes.transformed[i as usize].0.hit(ray, within),
            ShapeId::Other(i) => shapes.others[i as usize].0.hit(ray, within),
        }
    }
}
