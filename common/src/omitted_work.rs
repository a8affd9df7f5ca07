//! `OmittedWork`: the work that a renderer leaves out in a scene, one reason at a time.
//!
//! The reasons are put back one after the other, and each is compared with those before it. So the
//! rows add up to the work of the renderer that leaves out nothing.

use crate::comparison::WORK;
use crate::steps::{Counts, counted};
use crate::{Error, Image, Omission, Omissions, Renderer, Scene, Settings};

/// The words for a kind of work that is left out.
pub struct Words {
    /// The work.
    pub work: &'static str,
    /// Why no picture shows it.
    pub because: &'static str,
}

impl Words {
    /// The words for work that is left out, which are those of the book.
    #[must_use]
    pub const fn of(omission: Omission) -> Self {
        let (work, because) = match omission {
            Omission::FartherOccluders => (
                "the search behind the first object between a surface and a light",
                "one object casts a shadow as well as two",
            ),
            Omission::LightsWithoutShadows => (
                "shadow rays to a light that casts no shadows",
                "the light arrives, whatever is between",
            ),
            Omission::LightsBehind => (
                "shadow rays to a light behind the surface",
                "Lambert's cosine is at most 0 and counts as 0",
            ),
            Omission::UnreflectedLight => (
                "shadow rays to a light of which the surface reflects nothing",
                "the product is 0, or the colour does not depend on the light",
            ),
            Omission::UnseenHighlights => (
                "powers of highlights that nobody sees",
                "they are black, or mirrored away from the eye",
            ),
            Omission::BlackMirrors => (
                "reflected rays from surfaces that mirror nothing",
                "their colour would be multiplied by 0",
            ),
            Omission::FaintReflections => (
                "reflected rays that nobody could see",
                "what they bring back is less than the allowed error",
            ),
            Omission::IdentityTransforms => (
                "rays into the space of a group that does not move its shapes",
                "they are the same rays there",
            ),
            Omission::DistantObjects => (
                "tests of objects far from a ray",
                "the ray misses the boxes around them",
            ),
        };
        Self { work, because }
    }
}

/// A kind of work that a renderer leaves out in a scene.
#[derive(Debug)]
pub struct OmittedWork {
    /// The kind.
    pub omission: Omission,
    /// The steps that it leaves out; of a kind of which it takes more, none.
    pub steps: Counts,
}

impl OmittedWork {
    /// The work of each kind that the renderer of the settings leaves out in a scene, counted on the
    /// threads of the current pool.
    pub fn all(scene: &Scene, settings: &Settings) -> Result<Vec<Self>, Error> {
        let mut rows = Vec::new();
        let mut omissions = Omissions::ALL;
        let (_, mut before) = count(scene, settings, omissions)?;
        for omission in Omission::ALL {
            if !is_omitted(omission, settings) {
                continue;
            }
            omissions = omissions.without(omission);
            let (_, counts) = count(scene, settings, omissions)?;
            let steps = counts.without(&before);
            if WORK.iter().any(|work| steps[work.kind] > 0) {
                rows.push(Self { omission, steps });
            }
            before = counts;
        }
        Ok(rows)
    }

    /// The kinds of steps that it leaves out, and how many of each, in words.
    #[must_use]
    pub fn counts(&self) -> String {
        let mut words = Vec::new();
        for work in WORK {
            if self.steps[work.kind] > 0 {
                words.push(format!("{} {}", self.steps[work.kind], work.name));
            }
        }
        words.join(", ")
    }
}

/// Whether the renderer of the settings can leave this work out.
#[must_use]
pub fn is_omitted(omission: Omission, settings: &Settings) -> bool {
    let is_engine = settings.renderer == Renderer::Engine;
    match omission {
        Omission::IdentityTransforms | Omission::DistantObjects => is_engine,
        Omission::FaintReflections => is_engine && settings.max_error.is_some(),
        _ => true,
    }
}

/// The picture and the steps of a rendering that leaves out this work.
pub fn count(
    scene: &Scene,
    settings: &Settings,
    omissions: Omissions,
) -> Result<(Image, Counts), Error> {
    let settings = Settings {
        omissions: Some(omissions),
        ..settings.clone()
    };
    let (image, counts) = counted(|| scene.render(&settings, &()))?;
    Ok((image?, counts))
}
