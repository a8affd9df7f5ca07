//! `Batch`: paths that are followed together. One batch after the other uses its memory.

use common::Color;

use crate::accel::{NearestHits, Occluder, PACKETS, Query};
use crate::lanes::{ColorPacket, RayPacket, Simd};
use crate::shade::{IlluminationPacket, PhongPacket};

/// Paths that are followed together.
pub(crate) struct Batch<S: Simd> {
    /// The instructions for its lanes.
    pub(super) simd: S,
    /// The last occluder of each light, also from the batch before.
    pub(super) occluders: Vec<Occluder>,
    pub(super) paths: Vec<Path<S>>,
    /// For the hits of the paths, or for shadows of one source.
    pub(super) queries: Vec<Query<'static, S>>,
    /// The vertices of the paths that have hit anything.
    pub(super) vertices: Vec<Vertex<S>>,
    /// The light of one source, and the index of the vertex that it may reach.
    pub(super) light: Vec<(usize, IlluminationPacket<S>)>,
}

/// Four rays on their way from mirror to mirror.
pub(super) struct Path<S: Simd> {
    pub rays: RayPacket<S>,
    /// A bit for each ray that is followed further.
    pub active: u32,
    /// The light so far.
    pub color: ColorPacket<S>,
    /// The product of the reflectances so far.
    pub throughput: ColorPacket<S>,
}

/// The surfaces that the rays of a path have hit.
pub(super) struct Vertex<S: Simd> {
    /// The index of the path.
    pub path: usize,
    pub hits: NearestHits<S>,
    pub material: PhongPacket<S>,
    /// The light that they scatter.
    pub color: ColorPacket<S>,
}

impl<S: Simd> Batch<S> {
    /// A batch without paths.
    pub fn new(simd: S) -> Self {
        Self {
            simd,
            occluders: Vec::new(),
            paths: Vec::with_capacity(PACKETS),
            queries: Vec::with_capacity(PACKETS),
            vertices: Vec::with_capacity(PACKETS),
            light: Vec::with_capacity(PACKETS),
        }
    }

    /// Starts with the first `count` rays of some packets, in a scene of this many lights.
    #[inline(always)]
    pub(super) fn start(&mut self, packets: &[RayPacket<S>], count: usize, lights: usize) {
        self.occluders.resize(lights, None);
        self.paths.clear();
        let first = (0..count).step_by(4);
        self.paths
            .extend(packets.iter().zip(first).map(|(rays, first)| Path {
                rays: *rays,
                active: (1 << (count - first).min(4)) - 1,
                color: ColorPacket::splat(self.simd, Color::BLACK),
                throughput: ColorPacket::splat(self.simd, Color::WHITE),
            }));
    }

    /// The number of active rays.
    pub(super) fn active(&self) -> u64 {
        let active = self.paths.iter().map(|path| path.active.count_ones());
        active.map(u64::from).sum()
    }
}
