//! `Shapes`: the parts of a world, sorted by kind, so that each is asked without
//! a detour and similar ones lie side by side in memory.

use std::any::Any;
use std::sync::Arc;

use a03_rays_cameras::Ray;

use crate::triangle::ShearedRay;
use crate::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};

/// All parts of a world.
#[derive(Debug, Default)]
pub struct Shapes {
    pub spheres: Vec<(Sphere, Turn)>,
    pub triangles: Vec<(Triangle, Turn)>,
    pub boxes: Vec<(AxisAlignedBox, Turn)>,
    pub planes: Vec<(Plane, Turn)>,
    pub others: Vec<(Arc<dyn Geometry>, Turn)>,
}

/// Which of [`Shapes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// Adds a part.
    pub fn push(&mut self, part: &Arc<dyn Geometry>, turn: Turn) -> Shape {
        fn add<G>(shapes: &mut Vec<(G, Turn)>, shape: G, turn: Turn) -> u32 {
            shapes.push((shape, turn));
            shapes.len() as u32 - 1
        }
        let any: &dyn Any = &**part;
        if let Some(sphere) = any.downcast_ref() {
            Shape::Sphere(add(&mut self.spheres, *sphere, turn))
        } else if let Some(triangle) = any.downcast_ref() {
            Shape::Triangle(add(&mut self.triangles, *triangle, turn))
        } else if let Some(aab) = any.downcast_ref() {
            Shape::Box(add(&mut self.boxes, *aab, turn))
        } else if let Some(plane) = any.downcast_ref() {
            Shape::Plane(add(&mut self.planes, *plane, turn))
        } else {
            Shape::Other(add(&mut self.others, Arc::clone(part), turn))
        }
    }

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

/// A ray, with what it wants to compute only once.
#[derive(Clone, Copy)]
pub struct Asking<'a> {
    pub ray: &'a Ray,
    pub sheared: Option<ShearedRay>,
}

impl<'a> Asking<'a> {
    #[inline]
    pub fn new(ray: &'a Ray, shapes: &Shapes) -> Self {
        let has_triangles = !shapes.triangles.is_empty();
        Self {
            ray,
            sheared: has_triangles.then(|| ShearedRay::new(ray)),
        }
    }

    /// What the shape answers.
    #[inline]
    pub fn hit(&self, shapes: &Shapes, shape: Shape, within: Interval) -> Option<Hit> {
        match shape {
            Shape::Sphere(i) => shapes.spheres[i as usize].0.hit(self.ray, within),
            Shape::Triangle(i) => {
                let sheared = self.sheared.as_ref()?;
                shapes.triangles[i as usize].0.hit_by(sheared, within)
            }
            Shape::Box(i) => shapes.boxes[i as usize].0.hit(self.ray, within),
            Shape::Plane(i) => shapes.planes[i as usize].0.hit(self.ray, within),
            Shape::Other(i) => shapes.others[i as usize].0.hit(self.ray, within),
        }
    }
}
