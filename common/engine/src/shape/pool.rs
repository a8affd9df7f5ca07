//! `Pool`: vectors, each stored once.
//!
//! The triangles of a mesh share normals, but a scene has them triangle by triangle. A hash table
//! finds equal ones.

use glam::DVec3;

/// Vectors, each stored once.
#[derive(Debug, Default)]
pub(super) struct Pool {
    vectors: Vec<DVec3>,
    /// An open-addressing hash table: the index of a vector, or `EMPTY`. Its size is a
    /// power of two.
    table: Vec<u32>,
}

const EMPTY: u32 = u32::MAX;

impl Pool {
    /// The index of a vector with these bits, which is added if there is none.
    pub fn add(&mut self, vector: DVec3) -> u32 {
        // A table that is no more than three quarters full has short chains.
        if 4 * self.vectors.len() >= 3 * self.table.len() {
            self.table = vec![EMPTY; (2 * self.table.len()).max(64)];
            for index in 0..self.vectors.len() {
                let slot = self.slot(self.vectors[index]);
                self.table[slot] = index as u32;
            }
        }
        let slot = self.slot(vector);
        if self.table[slot] == EMPTY {
            self.table[slot] = self.vectors.len() as u32;
            self.vectors.push(vector);
        }
        self.table[slot]
    }

    /// The slot of a vector in the table, or the empty one for it.
    fn slot(&self, vector: DVec3) -> usize {
        let bits = |v: DVec3| v.to_array().map(f64::to_bits);
        let last = self.table.len() - 1;
        let mut slot = hash(bits(vector)) as usize & last;
        while self.table[slot] != EMPTY
            && bits(self.vectors[self.table[slot] as usize]) != bits(vector)
        {
            slot = (slot + 1) & last;
        }
        slot
    }

    /// The vector of an index.
    #[inline]
    pub fn get(&self, index: u32) -> DVec3 {
        self.vectors[index as usize]
    }

    /// Releases the memory that only `add` needs.
    pub fn finish(&mut self) {
        self.table = Vec::new();
        self.vectors.shrink_to_fit();
    }
}

/// A number to which each bit contributes. (The factor is the golden ratio's: Knuth, The
/// Art of Computer Programming, volume 3, section 6.4.)
fn hash(words: [u64; 3]) -> u64 {
    words.into_iter().fold(0_u64, |hash, word| {
        let product = (hash ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        product ^ product >> 32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_vectors_are_stored_once_and_bits_count() {
        let mut pool = Pool::default();
        let vector = |i: u32| DVec3::new(f64::from(i), 0.5, -1.0);
        for _ in 0..2 {
            for i in 0..1_000 {
                assert_eq!(pool.add(vector(i)), i);
            }
        }
        assert_eq!(pool.add(DVec3::new(-0.0, 0.5, -1.0)), 1_000);
        for i in 0..1_000 {
            assert_eq!(pool.get(i), vector(i));
        }
    }
}
