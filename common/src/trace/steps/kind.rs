//! `StepKind`: what a step of a computation does.

/// What a step does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StepKind {
    /// Chooses the position of a sample in its pixel.
    Sample,
    /// Sends a ray from the camera.
    CameraRay,
    /// Sends a ray to a light, to see whether anything is in its way.
    ShadowRay,
    /// Sends a ray that a surface mirrors.
    ReflectedRay,
    /// Offsets the origin of a ray from the surface that it leaves.
    Offset,
    /// Transforms a ray into the space of an object.
    ObjectRay,
    /// Tests a geometry for a hit. A node tests its children in turn.
    Test,
    /// Finds the nearest hit, which is shaded.
    Hit,
    /// Adds the ambient light.
    Ambient,
    /// Asks a light what arrives at a hit.
    Light,
    /// Adds the part of a light that a material reflects.
    ReflectedLight,
    /// Computes a power, for a highlight.
    Power,
    /// Finds the colour of an object.
    Color,
    /// Takes the colour of the background, for a ray without a hit.
    Background,
    /// Asks a surface how much it mirrors.
    Mirror,
    /// Sums up the light along a ray from the camera.
    Radiance,
    /// Takes the mean over the samples.
    Mean,
}

impl StepKind {
    /// The number of kinds.
    pub const COUNT: usize = Self::Mean as usize + 1;

    /// The word for programs that read a trace.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Sample => "sample",
            Self::CameraRay => "ray",
            Self::ShadowRay => "shadow ray",
            Self::ReflectedRay => "reflected ray",
            Self::Offset => "offset",
            Self::ObjectRay => "object ray",
            Self::Test => "test",
            Self::Hit => "hit",
            Self::Ambient => "ambient",
            Self::Light => "light",
            Self::ReflectedLight => "reflected light",
            Self::Power => "power",
            Self::Color | Self::Background => "color",
            Self::Mirror => "mirror",
            Self::Radiance => "radiance",
            Self::Mean => "mean",
        }
    }
}
