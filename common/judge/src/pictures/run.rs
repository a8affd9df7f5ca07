//! `Run`: one picture that the student's program draws: a scene with a number of samples.

/// One run of the student's program.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Run {
    /// The scene.
    pub scene: String,
    /// The number of samples.
    pub samples: u32,
}

impl Run {
    /// The name of the picture's file.
    #[must_use]
    pub fn file(&self) -> String {
        format!("{}-{}.png", self.scene, self.samples)
    }

    /// The scene and the samples in words.
    #[must_use]
    pub fn words(&self) -> String {
        let plural = if self.samples == 1 { "" } else { "s" };
        format!("{}, {} sample{plural}", self.scene, self.samples)
    }
}
