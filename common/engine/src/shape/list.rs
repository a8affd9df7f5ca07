//! `List`: shapes of one kind side by side in memory.

use super::Primitive;
use crate::lanes::Simd;

/// Shapes of one kind.
pub(crate) trait List {
    /// A shape.
    type Shape<'s>: Primitive
    where
        Self: 's;

    fn get(&self, index: usize) -> Self::Shape<'_>;

    /// Four shapes side by side.
    fn four<S: Simd>(
        &self,
        simd: S,
        indices: [usize; 4],
    ) -> <Self::Shape<'_> as Primitive>::Four<S>;

    /// One shape four times.
    #[inline(always)]
    fn splat<S: Simd>(&self, simd: S, index: usize) -> <Self::Shape<'_> as Primitive>::Four<S> {
        self.four(simd, [index; 4])
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

    #[inline(always)]
    fn four<S: Simd>(&self, simd: S, indices: [usize; 4]) -> <&P as Primitive>::Four<S> {
        <&P>::four(simd, indices.map(|index| &self[index]))
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.as_mut_slice().swap(a, b);
    }
}
