//! `Shapes`: the shapes of a scene, those of a kind side by side in memory.

use super::list::{Listed, Place};
use crate::shape::{
    AxisAlignedBox, Bounds, Disc, Mesh, Other, Plane, Primitive, Shape, Sphere, Transformed,
};

/// All shapes of a scene.
#[derive(Debug, Default)]
pub(crate) struct Shapes<'a> {
    pub spheres: Listed<Vec<Sphere>>,
    pub triangles: Listed<Mesh>,
    pub boxes: Listed<Vec<AxisAlignedBox>>,
    pub planes: Listed<Vec<Plane>>,
    pub discs: Listed<Vec<Disc>>,
    pub transformed: Listed<Vec<Transformed<'a>>>,
    pub others: Listed<Vec<Other<'a>>>,
}

/// A kind of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub(crate) enum Kind {
    Sphere,
    Triangle,
    Box,
    Plane,
    Disc,
    Transformed,
    Other,
}

impl Kind {
    pub const ALL: [Self; 7] = [
        Self::Sphere,
        Self::Triangle,
        Self::Box,
        Self::Plane,
        Self::Disc,
        Self::Transformed,
        Self::Other,
    ];

    /// The most shapes of a leaf: as many as are tested at once, or one if its test takes
    /// far longer than the test of its bounds.
    pub const fn most_in_leaf(self) -> usize {
        match self {
            Self::Transformed | Self::Other => 1,
            _ => 4,
        }
    }
}

/// A kind, and an index among the shapes of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeId {
    pub kind: Kind,
    pub index: u32,
}

impl ShapeId {
    /// Its bits as a number that is never computed with, for lanes.
    #[inline]
    pub const fn to_bits(self) -> f64 {
        f64::from_bits((self.kind as u64) << 32 | self.index as u64)
    }

    /// The shape whose bits these are.
    #[inline]
    pub const fn from_bits(bits: f64) -> Self {
        let bits = bits.to_bits();
        Self {
            kind: Kind::ALL[(bits >> 32) as usize % Kind::ALL.len()],
            index: bits as u32,
        }
    }
}

/// Evaluates an expression for the list of a kind.
macro_rules! with_list {
    ($shapes:expr, $kind:expr, |$list:ident| $body:expr) => {
        match $kind {
            Kind::Sphere => {
                let $list = &$shapes.spheres;
                $body
            }
            Kind::Triangle => {
                let $list = &$shapes.triangles;
                $body
            }
            Kind::Box => {
                let $list = &$shapes.boxes;
                $body
            }
            Kind::Plane => {
                let $list = &$shapes.planes;
                $body
            }
            Kind::Disc => {
                let $list = &$shapes.discs;
                $body
            }
            Kind::Transformed => {
                let $list = &$shapes.transformed;
                $body
            }
            Kind::Other => {
                let $list = &$shapes.others;
                $body
            }
        }
    };
}
pub(super) use with_list;

impl<'a> Shapes<'a> {
    /// Adds a shape to those of its kind.
    pub fn push(&mut self, shape: Shape<'a>, surface: u32) {
        let order = self.len() as u32;
        let place = Place { order, surface };
        match shape {
            Shape::Sphere(shape) => self.spheres.add(place).push(shape),
            Shape::Triangle(shape) => self.triangles.add(place).push(&shape),
            Shape::Box(shape) => self.boxes.add(place).push(shape),
            Shape::Plane(shape) => self.planes.add(place).push(shape),
            Shape::Disc(shape) => self.discs.add(place).push(shape),
            Shape::Transformed(shape) => self.transformed.add(place).push(shape),
            Shape::Other(shape) => self.others.add(place).push(shape),
        }
    }

    /// Releases the memory that only `push` needs.
    pub fn finish(&mut self) {
        self.triangles.shapes.finish();
    }

    /// How many shapes there are.
    pub fn len(&self) -> usize {
        let len = |kind: &Kind| with_list!(self, kind, |list| list.places.len());
        Kind::ALL.iter().map(len).sum()
    }

    /// How far away from its bounds a hit of a shape may be. Triangles have no error
    /// along the axis on which a ray goes farthest, unless they are transformed.
    pub fn depth_error(&self, shape: ShapeId) -> f64 {
        match shape.kind {
            Kind::Transformed => self.transformed.get(shape.index).depth_error(),
            _ => 0.0,
        }
    }

    /// All shapes.
    pub fn ids(&self) -> impl Iterator<Item = ShapeId> {
        let len = |kind| with_list!(self, kind, |list| list.places.len() as u32);
        let kinds = Kind::ALL.into_iter();
        kinds.flat_map(move |kind| (0..len(kind)).map(move |index| ShapeId { kind, index }))
    }

    /// All shapes and their bounds.
    pub fn bounds(&self) -> impl Iterator<Item = (ShapeId, Bounds)> {
        self.ids().map(|id| {
            let bounds = with_list!(self, id.kind, |list| list.get(id.index).bounds());
            (id, bounds)
        })
    }

    /// Position in the list and surface of a shape.
    #[inline]
    pub fn place(&self, shape: ShapeId) -> Place {
        with_list!(self, shape.kind, |list| list.places[shape.index as usize])
    }

    /// Puts the shapes of each kind in the order in which they are named, and names them anew.
    pub fn reorder<'s>(&mut self, shapes: impl Iterator<Item = &'s mut ShapeId>) {
        let mut orders = [const { Vec::new() }; Kind::ALL.len()];
        for shape in shapes {
            let order = &mut orders[shape.kind as usize];
            order.push(shape.index);
            shape.index = order.len() as u32 - 1;
        }
        let [
            spheres,
            triangles,
            boxes,
            planes,
            discs,
            transformed,
            others,
        ] = orders;
        self.spheres.reorder(spheres);
        self.triangles.reorder(triangles);
        self.boxes.reorder(boxes);
        self.planes.reorder(planes);
        self.discs.reorder(discs);
        self.transformed.reorder(transformed);
        self.others.reorder(others);
    }
}
