//! `Shapes`: the shapes of a scene, those of a kind side by side in memory.

use std::mem;

use super::ids::{Kind, ShapeId};
use super::shape_list::{Attributes, ShapeList};
use crate::lanes::{Lanes, PacketHit, Simd};
use crate::shape::{
    AxisAlignedBox, Bounds, Counts, Disc, List, Mesh, Other, Plane, Primitive, Rays, Shape, Sphere,
    Transformed, hits, hits_around_identities,
};

/// All shapes of a scene.
#[derive(Default)]
pub(crate) struct Shapes<'a> {
    pub spheres: ShapeList<Vec<Sphere>>,
    pub triangles: ShapeList<Mesh>,
    pub boxes: ShapeList<Vec<AxisAlignedBox>>,
    pub planes: ShapeList<Vec<Plane>>,
    pub discs: ShapeList<Vec<Disc>>,
    pub transformed: ShapeList<Vec<Transformed<'a>>>,
    pub others: ShapeList<Vec<Other<'a>>>,
}

/// Evaluates an expression for the list of a kind.
macro_rules! with_list {
    ($shapes:expr, $kind:expr, |$list:ident| $body:expr) => {
        with_list!(
            $shapes, $kind, |$list| $body,
            Sphere spheres, Triangle triangles, Box boxes, Plane planes, Disc discs,
            Transformed transformed, Other others
        )
    };
    ($shapes:expr, $kind:expr, |$list:ident| $body:expr, $($variant:ident $field:ident),*) => {
        match $kind {
            $(Kind::$variant => {
                let $list = &$shapes.$field;
                $body
            })*
        }
    };
}
pub(super) use with_list;

impl<'a> Shapes<'a> {
    /// Adds a shape to those of its kind.
    pub fn push(&mut self, shape: Shape<'a>, surface: u32) {
        let order = self.len() as u32;
        let own = Attributes {
            order,
            surface,
            identities: 0,
        };
        self.add(shape, own);
    }

    /// Moves no rays by the identity. A shape under no other transform joins those of its kind.
    pub fn omit_identities(&mut self) {
        let ShapeList { shapes, attributes } = mem::take(&mut self.transformed);
        for (mut transformed, own) in shapes.into_iter().zip(attributes) {
            let is_instance = matches!(*transformed.shape, Shape::Instance(_));
            if transformed.omit_identities() && !is_instance {
                let identities = transformed.steps.len() as u32;
                self.add(*transformed.shape, Attributes { identities, ..own });
            } else {
                self.add(Shape::Transformed(transformed), own);
            }
        }
    }

    fn add(&mut self, shape: Shape<'a>, own: Attributes) {
        match shape {
            Shape::Sphere(shape) => self.spheres.with(own).push(shape),
            Shape::Triangle(shape) => self.triangles.with(own).push(&shape),
            Shape::Box(shape) => self.boxes.with(own).push(shape),
            Shape::Plane(shape) => self.planes.with(own).push(shape),
            Shape::Disc(shape) => self.discs.with(own).push(shape),
            Shape::Transformed(shape) => self.transformed.with(own).push(shape),
            Shape::Other(shape) => self.others.with(own).push(shape),
            Shape::Instance(_) => self.transformed.with(own).push(Transformed {
                steps: Vec::new(),
                shape: Box::new(shape),
            }),
        }
    }

    /// The number of shapes.
    pub fn len(&self) -> usize {
        let len = |kind: &Kind| with_list!(self, kind, |list| list.attributes.len());
        Kind::ALL.iter().map(len).sum()
    }

    /// The depth error of a shape. Triangles have none along the dominant axis of a ray, unless
    /// they are transformed.
    pub fn depth_error(&self, shape: ShapeId) -> f64 {
        match shape.kind {
            Kind::Transformed => self.transformed.shapes[shape.index as usize].depth_error(),
            _ => 0.0,
        }
    }

    /// Whether a shape is an instance, whose test takes far longer than that of its bounds.
    pub fn have_instances(&self) -> bool {
        let mut transformed = self.transformed.shapes.iter();
        transformed.any(|shape| matches!(*shape.shape, Shape::Instance(_)))
    }

    /// The largest depth error of a shape, in a space in which rays have directions of any length.
    pub fn largest_depth_error(&self) -> f64 {
        let errors = self.ids().map(|id| {
            let index = id.index as usize;
            with_list!(self, id.kind, |list| list.shapes.get(index).depth_error())
        });
        errors.fold(0.0, f64::max)
    }

    /// Order and surface of a shape.
    pub fn attributes(&self, id: ShapeId) -> Attributes {
        with_list!(self, id.kind, |list| list.attributes[id.index as usize])
    }

    /// The hits of four rays on a shape at these `t`, which its test has found in the active lanes.
    #[inline]
    pub fn hits_on<S: Simd>(
        &self,
        shape: ShapeId,
        rays: &Rays<S>,
        t: Lanes<S>,
        active: u32,
    ) -> PacketHit<S> {
        let index = shape.index as usize;
        with_list!(self, shape.kind, |list| {
            let hit = hits(list.shapes.get(index), rays, t, active);
            match list.attributes[index].identities {
                0 => hit,
                count => hits_around_identities(count, hit, &rays.packet),
            }
        })
    }

    /// [`Primitive::any_hit_of_parts`] of a shape.
    #[inline(never)]
    pub fn any_hit_of_parts<S: Simd>(
        &self,
        shape: ShapeId,
        rays: &Rays<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<S>,
    ) -> u32 {
        let index = shape.index as usize;
        let count = self.attributes(shape).identities;
        let counts =
            |hit: &PacketHit<S>| counts(&hits_around_identities(count, *hit, &rays.packet));
        before.simd.vectorize(
            #[inline(always)]
            || {
                with_list!(self, shape.kind, |list| list
                    .shapes
                    .get(index)
                    .any_hit_of_parts(rays, before, active, &counts))
            },
        )
    }

    /// All shapes.
    pub fn ids(&self) -> impl Iterator<Item = ShapeId> {
        let len = |kind| with_list!(self, kind, |list| list.attributes.len() as u32);
        let kinds = Kind::ALL.into_iter();
        kinds.flat_map(move |kind| (0..len(kind)).map(move |index| ShapeId { kind, index }))
    }

    /// All shapes and their bounds.
    pub fn bounds(&self) -> impl Iterator<Item = (ShapeId, Bounds)> {
        self.ids().map(|id| {
            let index = id.index as usize;
            let bounds = with_list!(self, id.kind, |list| list.shapes.get(index).bounds());
            (id, bounds)
        })
    }

    /// Sorts the shapes of each kind in the order of these ids, and renumbers the ids.
    pub fn reorder<'s>(&mut self, shapes: impl Iterator<Item = &'s mut ShapeId>) {
        let mut orders = [const { Vec::new() }; Kind::ALL.len()];
        for shape in shapes {
            let order = &mut orders[shape.kind as usize];
            order.push(shape.index);
            shape.index = order.len() as u32 - 1;
        }
        let mut order = |kind: Kind| mem::take(&mut orders[kind as usize]);
        self.spheres.reorder(order(Kind::Sphere));
        self.triangles.reorder(order(Kind::Triangle));
        self.boxes.reorder(order(Kind::Box));
        self.planes.reorder(order(Kind::Plane));
        self.discs.reorder(order(Kind::Disc));
        self.transformed.reorder(order(Kind::Transformed));
        self.others.reorder(order(Kind::Other));
    }
}
