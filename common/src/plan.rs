//! `Plan`: the work that a picture needs, and the work that the renderer skips.
//!
//! It is made from the scene before the first ray, so that a reader sees which facts
//! about the scene the renderer uses.

use std::fmt;

/// The work that the picture of a scene needs, and the work that it does not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    /// The work and its objects: rays, shapes, lights, mirrors.
    pub needs: Vec<String>,
    /// The work that is skipped.
    pub omissions: Vec<Omission>,
}

/// Work that is skipped.
#[derive(Clone, Debug, PartialEq)]
pub struct Omission {
    /// The work.
    pub what: String,
    /// The reason why the picture does not need it.
    pub why: String,
    /// The largest difference from the picture with this work.
    pub bound: Bound,
}

/// The largest difference of a picture from the one with all work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// None: the pictures are bit-identical.
    SameBits,
    /// No channel of a pixel differs by more than this, where 1 is white.
    Channel(f64),
    /// The root mean square error of all channels is at most this with 95 % confidence,
    /// where 1 is white.
    Error(f64),
    /// Every ray has the hits that it would have if shapes were moved by less than
    /// this, where 1 is the largest distance of eye and objects from the origin. The
    /// picture differs only where an edge or the border of a shadow passes a sample
    /// within that distance.
    Shift(f64),
}

impl Plan {
    /// Adds an entry to `needs`.
    #[must_use]
    pub fn needing(mut self, need: impl Into<String>) -> Self {
        self.needs.push(need.into());
        self
    }

    /// Adds work that is skipped because of `why`, without any change of the picture.
    #[must_use]
    pub fn without(self, what: impl Into<String>, why: impl Into<String>) -> Self {
        self.nearly_without(what, why, Bound::SameBits)
    }

    /// Adds work that is skipped because of `why`, with a change of the picture within
    /// `bound`.
    #[must_use]
    pub fn nearly_without(
        mut self,
        what: impl Into<String>,
        why: impl Into<String>,
        bound: Bound,
    ) -> Self {
        let (what, why) = (what.into(), why.into());
        self.omissions.push(Omission { what, why, bound });
        self
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::SameBits => write!(f, "same bits"),
            Self::Channel(bound) => write!(f, "off by less than {bound:.2e}"),
            Self::Error(bound) => write!(f, "rms error at most {bound:.2e}, with 95 % confidence"),
            Self::Shift(bound) => write!(f, "shapes move by less than {bound:.2e} of the scene"),
        }
    }
}

/// One line for each entry, without a newline at the end.
impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if self.needs.is_empty() && self.omissions.is_empty() {
            return write!(f, "  nothing to leave out: the picture takes no rays");
        }
        let mut lines = Vec::new();
        lines.extend(self.needs.iter().map(|need| format!("  needs     {need}")));
        lines.extend(self.omissions.iter().map(|omission| {
            let Omission { what, why, bound } = omission;
            format!("  left out  {what}: {why} ({bound})")
        }));
        write!(f, "{}", lines.join("\n"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_has_a_line_for_needed_and_for_skipped_work() {
        let plan = Plan::default()
            .needing("lights: 2")
            .without("a ray", "it goes nowhere")
            .nearly_without("a mirror", "it is dark", Bound::Channel(0.002));
        let lines = "  needs     lights: 2
  left out  a ray: it goes nowhere (same bits)
  left out  a mirror: it is dark (off by less than 2.00e-3)";
        assert_eq!(plan.to_string(), lines);
        assert_eq!(Plan::default().to_string().lines().count(), 1);
    }
}
