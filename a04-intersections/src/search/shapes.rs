//! `Shapes`: the parts of a world, sorted by kind, so that each is asked without
//! a detour and similar ones lie side by side in memory.

use std::any::Any;
use std::cell::OnceCell;
use std::sync::Arc;

use a03_rays_cameras::Ray;
use measure::tally::{self, Work};

use crate::triangle::ShearedRay;
use crate::{AxisAlignedBox, Bounds, Geometry, Hit, Interval, Plane, Sphere, Triangle};

/// All parts of a world.
#[derive(Debug, Default)]
pub struct Shapes {
    /// All, in the order in which the plain list asks them.
    pub in_turn: Vec<Shape>,
    pub spheres: Vec<(Sphere, Turn)>,
    pub triangles: Vec<(Triangle, Turn)>,
    pub boxes: Vec<(AxisAlignedBox, Turn)>,
    pub planes: Vec<(Plane, Turn)>,
    pub others: Vec<(Arc<dyn Geometry>, Turn)>,
}

/// Which of [`Shapes`].
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Sphere(u32),
    Triangle(u32),
    Box(u32),
    Plane(u32),
    Other(u32),
}

/// When a shape is asked in the plain list, and the object that it is part of.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    pub turn: u32,
    pub object: u32,
}

impl Shapes {
    /// Adds a part of an object, to those of its kind.
    pub fn push(&mut self, part: &Arc<dyn Geometry>, object: u32) {
        fn is<G: Geometry + Copy>(part: &Arc<dyn Geometry>) -> Option<G> {
            let any: &dyn Any = &**part;
            any.downcast_ref().copied()
        }
        fn push<G>(shapes: &mut Vec<(G, Turn)>, shape: G, turn: Turn) -> u32 {
            shapes.push((shape, turn));
            shapes.len() as u32 - 1
        }
        let turn = self.in_turn.len() as u32;
        let turn = Turn { turn, object };
        self.in_turn.push(if let Some(sphere) = is::<Sphere>(part) {
            Shape::Sphere(push(&mut self.spheres, sphere, turn))
        } else if let Some(triangle) = is::<Triangle>(part) {
            Shape::Triangle(push(&mut self.triangles, triangle, turn))
        } else if let Some(aab) = is::<AxisAlignedBox>(part) {
            Shape::Box(push(&mut self.boxes, aab, turn))
        } else if let Some(plane) = is::<Plane>(part) {
            Shape::Plane(push(&mut self.planes, plane, turn))
        } else {
            Shape::Other(push(&mut self.others, Arc::clone(part), turn))
        });
    }

    /// How many shapes there are.
    pub fn len(&self) -> usize {
        self.in_turn.len()
    }

    /// All shapes and their bounds.
    pub fn bounds(&self) -> impl Iterator<Item = (Bounds, Shape)> {
        fn of<G: Geometry>(
            shapes: &[(G, Turn)],
            shape: fn(u32) -> Shape,
        ) -> impl Iterator<Item = (Bounds, Shape)> {
            (0..)
                .zip(shapes)
                .map(move |(i, (geometry, _))| (geometry.bounds(), shape(i)))
        }
        of(&self.spheres, Shape::Sphere)
            .chain(of(&self.triangles, Shape::Triangle))
            .chain(of(&self.boxes, Shape::Box))
            .chain(of(&self.planes, Shape::Plane))
            .chain(
                (0..)
                    .zip(&self.others)
                    .map(|(i, (geometry, _))| (geometry.bounds(), Shape::Other(i))),
            )
    }

    /// Whether one shape has its turn before another.
    #[inline]
    pub fn comes_before(&self, one: Shape, other: Shape) -> bool {
        self.turn(one).turn < self.turn(other).turn
    }

    #[inline]
    pub fn turn(&self, shape: Shape) -> Turn {
        match shape {
            Shape::Sphere(i) => self.spheres[i as usize].1,
            Shape::Triangle(i) => self.triangles[i as usize].1,
            Shape::Box(i) => self.boxes[i as usize].1,
            Shape::Plane(i) => self.planes[i as usize].1,
            Shape::Other(i) => self.others[i as usize].1,
        }
    }
}

/// A ray that asks shapes, with what it wants to compute only once.
pub struct Asking<'a> {
    pub ray: &'a Ray,
    pub shapes: &'a Shapes,
    sheared: OnceCell<ShearedRay>,
}

impl<'a> Asking<'a> {
    #[inline]
    pub fn new(ray: &'a Ray, shapes: &'a Shapes) -> Self {
        Self {
            ray,
            shapes,
            sheared: OnceCell::new(),
        }
    }

    /// The ray as triangles want it.
    #[inline]
    pub fn sheared(&self) -> &ShearedRay {
        self.sheared.get_or_init(|| ShearedRay::new(self.ray))
    }

    /// What the shape answers.
    #[inline]
    pub fn hit(&self, shape: Shape, within: Interval) -> Option<Hit> {
        tally::count(Work::IntersectionTest);
        self.answer(shape, within)
    }

    /// The same, by who has counted it.
    #[inline]
    pub fn answer(&self, shape: Shape, within: Interval) -> Option<Hit> {
        let Self { ray, shapes, .. } = self;
        match shape {
            Shape::Sphere(i) => shapes.spheres[i as usize].0.hit(ray, within),
            Shape::Triangle(i) => {
                let (triangle, _) = &shapes.triangles[i as usize];
                triangle.hit_by(self.sheared(), within)
            }
            Shape::Box(i) => shapes.boxes[i as usize].0.hit(ray, within),
            Shape::Plane(i) => shapes.planes[i as usize].0.hit(ray, within),
            Shape::Other(i) => shapes.others[i as usize].0.hit(ray, within),
        }
    }
}
