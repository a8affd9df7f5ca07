//! `Batch`: paths that are followed together. One batch after the other uses its memory.

use common::Color;

use crate::accel::{NearestHits, NearestQuery, Occluder, ShadowQuery};
use crate::lanes::{ColorPacket, RayPacket};
use crate::shade::{IlluminationPacket, PhongPacket};

/// Paths that are followed together.
#[derive(Default)]
pub(crate) struct Batch {
    /// The last occluder of each light, also from the batch before.
    pub(super) occluders: Vec<Occluder>,
    pub(super) paths: Vec<Path>,
    pub(super) nearest: Vec<NearestQuery>,
    /// The vertices of the paths that have hit anything.
    pub(super) vertices: Vec<Vertex>,
    /// The light of one source, and the index of the vertex that it may reach.
    pub(super) light: Vec<(usize, IlluminationPacket)>,
    pub(super) shadows: Vec<ShadowQuery>,
}

/// Four rays on their way from mirror to mirror.
pub(super) struct Path {
    pub rays: RayPacket,
    /// A bit for each ray that is followed further.
    pub active: u32,
    /// The light so far.
    pub color: ColorPacket,
    /// The product of the reflectances so far.
    pub throughput: ColorPacket,
}

/// The surfaces that the rays of a path have hit.
pub(super) struct Vertex {
    /// The index of the path.
    pub path: usize,
    pub hits: NearestHits,
    pub material: PhongPacket,
    /// The light that they scatter.
    pub color: ColorPacket,
}

impl Batch {
    /// Starts with the first `count` rays of some packets, in a scene of this many lights.
    pub(super) fn start(&mut self, packets: &[RayPacket], count: usize, lights: usize) {
        self.occluders.resize(lights, None);
        self.paths.clear();
        let first = (0..count).step_by(4);
        self.paths
            .extend(packets.iter().zip(first).map(|(rays, first)| Path {
                rays: *rays,
                active: (1 << (count - first).min(4)) - 1,
                color: ColorPacket::splat(Color::BLACK),
                throughput: ColorPacket::splat(Color::WHITE),
            }));
    }

    /// The number of active rays.
    pub(super) fn active(&self) -> u64 {
        let active = self.paths.iter().map(|path| path.active.count_ones());
        active.map(u64::from).sum()
    }
}
