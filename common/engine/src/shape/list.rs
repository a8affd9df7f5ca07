//! `List`: shapes of one kind side by side in memory.

use super::Primitive;

/// Shapes of one kind.
pub(crate) trait List {
    /// A shape.
    type Shape<'s>: Primitive
    where
        Self: 's;

    fn get(&self, index: usize) -> Self::Shape<'_>;

    /// Four shapes side by side.
    fn four(&self, indices: [usize; 4]) -> <Self::Shape<'_> as Primitive>::Four;

    /// One shape four times.
    #[inline]
    fn splat(&self, index: usize) -> <Self::Shape<'_> as Primitive>::Four {
        self.four([index; 4])
    }

    fn swap(&mut self, a: usize, b: usize);
}

impl<P> List for Vec<P>
where
    for<'s> &'s P: Primitive,
{
    type Shape<'s>
        = &'s P
    where
        P: 's;

    #[inline]
    fn get(&self, index: usize) -> &P {
        &self[index]
    }

    #[inline]
    fn four(&self, indices: [usize; 4]) -> <&P as Primitive>::Four {
        <&P>::four(indices.map(|index| &self[index]))
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.as_mut_slice().swap(a, b);
    }
}
