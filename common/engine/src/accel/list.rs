//! `Listed`: shapes of one kind side by side in memory, and the tests of a leaf of them.

use common::tally::{self, Work};

use super::bvh::Leaf;
use super::search::Search;
use super::single::Nearest;
use crate::lanes::{Lanes, bits};
use crate::shape::{Corners, Mesh, Primitive, Rays, Triangle};

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
    fn splat(&self, index: usize) -> <Self::Shape<'_> as Primitive>::Four;

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
    fn four(&self, [a, b, c, d]: [usize; 4]) -> <&P as Primitive>::Four {
        <&P>::four([&self[a], &self[b], &self[c], &self[d]])
    }

    #[inline]
    fn splat(&self, index: usize) -> <&P as Primitive>::Four {
        <&P>::four([&self[index]; 4])
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.as_mut_slice().swap(a, b);
    }
}

impl List for Mesh {
    type Shape<'s> = Triangle;

    #[inline]
    fn get(&self, index: usize) -> Triangle {
        Self::get(self, index)
    }

    #[inline]
    fn four(&self, indices: [usize; 4]) -> Corners {
        self.corners_of_four(indices)
    }

    #[inline]
    fn splat(&self, index: usize) -> Corners {
        self.corners_of(index)
    }

    fn swap(&mut self, a: usize, b: usize) {
        Self::swap(self, a, b);
    }
}

/// Position of a shape in the list of the scene, which breaks ties, and the index of its
/// surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub order: u32,
    pub surface: u32,
}

/// Shapes of one kind and their places.
#[derive(Debug, Default)]
pub(crate) struct Listed<L> {
    pub shapes: L,
    pub places: Vec<Place>,
}

impl<L: List> Listed<L> {
    /// The list to which a shape with this place is to be pushed.
    pub(super) fn add(&mut self, place: Place) -> &mut L {
        self.places.push(place);
        &mut self.shapes
    }

    #[inline]
    pub(super) fn get(&self, index: u32) -> L::Shape<'_> {
        self.shapes.get(index as usize)
    }

    /// Puts the shapes in an order: an index for each place. Goes round each cycle of the
    /// permutation once.
    pub(super) fn reorder(&mut self, mut order: Vec<u32>) {
        for start in 0..order.len() {
            let mut place = start;
            loop {
                let index = std::mem::replace(&mut order[place], place as u32) as usize;
                if index == start {
                    break;
                }
                self.shapes.swap(place, index);
                self.places.swap(place, index);
                place = index;
            }
        }
    }

    /// The shapes of a leaf side by side; the last one several times in a leaf of fewer
    /// than four.
    #[inline]
    fn four(&self, leaf: Leaf) -> <L::Shape<'_> as Primitive>::Four {
        let first = leaf.first as usize;
        let last = first + usize::from(leaf.count) - 1;
        let [b, c, d] = [1, 2, 3].map(|lane| (first + lane).min(last));
        self.shapes.four([first, b, c, d])
    }

    /// Where one ray, four times, meets the shapes of a leaf; and a bit for each shape.
    #[inline]
    fn meet(&self, leaf: Leaf, ray: &Rays) -> (Lanes, u32) {
        tally::count_all(Work::IntersectionTest, leaf.count.into());
        let wanted = (1 << leaf.count) - 1;
        let t = <L::Shape<'_> as Primitive>::meet(&self.four(leaf), ray, wanted);
        (t, wanted)
    }

    /// Looks for nearer hits of one ray in a leaf.
    #[inline(never)]
    pub(super) fn nearest(&self, leaf: Leaf, ray: &Rays, nearest: &mut Nearest) {
        let (t, wanted) = self.meet(leaf, ray);
        let near = t.simd_le(Lanes::splat(nearest.t)).to_bitmask() & wanted;
        if near == 0 {
            return;
        }
        let t = t.to_array();
        for lane in bits(near) {
            let index = leaf.first + lane as u32;
            let order = self.places[index as usize].order;
            // At the same place the first of the list counts, in any order of tests.
            if t[lane] < nearest.t || t[lane] == nearest.t && order < nearest.order {
                *nearest = Nearest {
                    t: t[lane],
                    order,
                    shape: Some(leaf.shape(lane as u32)),
                };
            }
        }
    }

    /// A shape of a leaf that one ray meets before `max`.
    #[inline(never)]
    pub(super) fn any(&self, leaf: Leaf, ray: &Rays, max: f64) -> Option<u32> {
        let (t, wanted) = self.meet(leaf, ray);
        let hit = t.simd_lt(Lanes::splat(max)).to_bitmask() & wanted;
        (hit != 0).then(|| hit.trailing_zeros())
    }

    /// Tests the shapes of a leaf in some of these searches, a bit for each.
    #[inline(never)]
    pub(super) fn test<S: Search>(
        &self,
        leaf: Leaf,
        searches: &mut [S],
        some: u32,
        shared: &mut S::Shared,
    ) {
        for i in 0..u32::from(leaf.count) {
            let index = (leaf.first + i) as usize;
            let (shape, order) = (self.shapes.splat(index), self.places[index].order);
            for search in bits(some) {
                let search = &mut searches[search];
                let open = search.open();
                if open != 0 {
                    tally::count_all(Work::IntersectionTest, open.count_ones().into());
                    let t = <L::Shape<'_> as Primitive>::meet(&shape, search.rays(), open);
                    search.take(t, order, leaf.shape(i), shared);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Plane;
    use glam::DVec3;

    #[test]
    fn shapes_and_their_places_are_put_in_order() {
        let mut list = Listed::<Vec<Plane>>::default();
        for order in 0..6 {
            let plane = Plane {
                point: DVec3::splat(order.into()),
                normal: DVec3::Z,
            };
            let surface = 10 + order;
            list.add(Place { order, surface }).push(plane);
        }
        // Two cycles, of three and of two, and one that stays.
        let order = [2, 0, 1, 3, 5, 4];
        list.reorder(order.to_vec());
        for (index, was) in (0..).zip(order) {
            assert_eq!(list.get(index).point.x, f64::from(was));
            let Place { order, surface } = list.places[index as usize];
            assert_eq!([order, surface], [was, 10 + was]);
        }
    }
}
