//! `Omission`: work that a renderer leaves out because no picture shows it, and `Omissions`, a set of
//! them. `render --explain` puts the work back, kind by kind, and counts it.

/// Work that does not change a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omission {
    /// The search behind the first object between a surface and a light.
    FartherOccluders,
    /// Shadow rays to lights that cast no shadows.
    LightsWithoutShadows,
    /// Shadow rays to lights behind the surface.
    LightsBehind,
    /// Shadow rays to lights of which the surface reflects nothing.
    UnreflectedLight,
    /// Powers of highlights that are black or mirrored away from the eye.
    UnseenHighlights,
    /// Reflected rays from surfaces that mirror nothing.
    BlackMirrors,
    /// Reflected rays that bring back less than the allowed error.
    FaintReflections,
    /// Moving rays into the space of nodes that leave them as they are.
    IdentityTransforms,
    /// Tests of objects whose bounding boxes the ray misses.
    DistantObjects,
}

impl Omission {
    /// All kinds, in the order in which a measurement puts them back: each with those before it, so
    /// that work which several of them leave out counts for the last check that the ray would pass.
    pub const ALL: [Self; 9] = [
        Self::FartherOccluders,
        Self::LightsWithoutShadows,
        Self::LightsBehind,
        Self::UnreflectedLight,
        Self::UnseenHighlights,
        Self::BlackMirrors,
        Self::FaintReflections,
        Self::IdentityTransforms,
        Self::DistantObjects,
    ];

    /// The omissions of the lesson.
    pub const OF_LESSON: [Self; 6] = [
        Self::FartherOccluders,
        Self::LightsWithoutShadows,
        Self::LightsBehind,
        Self::UnreflectedLight,
        Self::UnseenHighlights,
        Self::BlackMirrors,
    ];
}

/// A set of kinds of work that are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Omissions(u16);

impl Omissions {
    /// Nothing is left out.
    pub const NONE: Self = Self(0);

    /// Everything is left out that can be.
    pub const ALL: Self = Self(u16::MAX);

    /// Whether this work is left out.
    #[inline]
    #[must_use]
    pub const fn contains(self, omission: Omission) -> bool {
        self.0 & (1 << omission as u16) != 0
    }

    /// The set without this work, which is then done.
    #[must_use]
    pub const fn without(self, omission: Omission) -> Self {
        Self(self.0 & !(1 << omission as u16))
    }
}
