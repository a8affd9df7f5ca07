//! `ShapeId` names a shape of a scene, and `Leaf` up to four shapes of one kind.

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

    /// Capacity of a leaf: the number of shapes that are tested at once, or one if the test of a
    /// shape takes far longer than the test of its bounds.
    pub const fn leaf_capacity(self) -> usize {
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
    /// The id as the bits of a number, for lanes. No arithmetic is done with it.
    #[inline]
    pub const fn to_bits(self) -> f64 {
        f64::from_bits((self.kind as u64) << 32 | self.index as u64)
    }

    /// The inverse of `to_bits`.
    #[inline]
    pub const fn from_bits(bits: f64) -> Self {
        let bits = bits.to_bits();
        Self {
            kind: Kind::ALL[(bits >> 32) as usize % Kind::ALL.len()],
            index: bits as u32,
        }
    }
}

/// Shapes of one kind with consecutive indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Leaf {
    pub kind: Kind,
    /// From 1 to 4.
    pub count: u8,
    pub first: u32,
}

impl Leaf {
    /// A leaf of one shape.
    pub const fn of(shape: ShapeId) -> Self {
        Self {
            kind: shape.kind,
            count: 1,
            first: shape.index,
        }
    }

    /// A shape of the leaf.
    #[inline]
    pub const fn shape(self, i: u32) -> ShapeId {
        ShapeId {
            kind: self.kind,
            index: self.first + i,
        }
    }

    /// Shapes with consecutive indices, in as few leaves as possible.
    pub fn of_all(shapes: &[ShapeId]) -> Vec<Self> {
        let runs = shapes.chunk_by(|a, b| a.kind == b.kind);
        let leaves = runs.flat_map(|run| run.chunks(run[0].kind.leaf_capacity()));
        let leaf = |shapes: &[ShapeId]| Self {
            count: shapes.len() as u8,
            ..Self::of(shapes[0])
        };
        leaves.map(leaf).collect()
    }
}
