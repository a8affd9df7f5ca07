//! `Plan`: what a picture needs, and what is left out of its making.
//!
//! It is made from the scene before the first ray, so that a reader can see
//! what the renderer knows before it begins.

use std::fmt;

/// What the picture of a scene needs, and what it does not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    /// What there is: rays, objects, lights, mirrors.
    pub needs: Vec<String>,
    /// What is not done.
    pub omissions: Vec<Omission>,
}

/// Work that is not done.
#[derive(Clone, Debug, PartialEq)]
pub struct Omission {
    /// Which work.
    pub what: String,
    /// Why the picture does not need it.
    pub why: String,
    /// How far the picture can be from the one with this work.
    pub bound: Bound,
}

/// How far a picture can be from the one with all work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// It is the same, to the last bit.
    SameBits,
    /// No channel of a pixel is farther off than this, 1 being white.
    Channel(f64),
    /// The root mean square error of all channels is estimated to be at most this, 1
    /// being white.
    Error(f64),
    /// Every ray meets what it would if shapes were moved by less than this, 1
    /// being the largest distance from the origin of eye and objects: only edges
    /// and borders of shadows that pass so near to a sample change it.
    Shift(f64),
}

impl Plan {
    /// This plan and one more thing that there is.
    #[must_use]
    pub fn needing(mut self, need: impl Into<String>) -> Self {
        self.needs.push(need.into());
        self
    }

    /// This plan and work that is left out because of `why`, the picture being
    /// the same.
    #[must_use]
    pub fn without(self, what: impl Into<String>, why: impl Into<String>) -> Self {
        self.nearly_without(what, why, Bound::SameBits)
    }

    /// The same, the picture being as near as `bound` says.
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
            Self::Error(bound) => write!(f, "estimated rms error at most {bound:.2e}"),
            Self::Shift(bound) => write!(f, "shapes move by less than {bound:.2e} of the scene"),
        }
    }
}

/// One line each, without the last line's end.
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
    fn a_plan_tells_what_there_is_and_what_is_left_out() {
        let plan = Plan::default()
            .needing("lights: 2")
            .without("a ray", "it goes nowhere")
            .nearly_without("a mirror", "it is dark", Bound::Channel(0.002))
            .nearly_without("a sample", "it is like others", Bound::Error(0.004))
            .nearly_without("a turn", "it is small", Bound::Shift(3e-15));
        let lines = [
            "  needs     lights: 2",
            "  left out  a ray: it goes nowhere (same bits)",
            "  left out  a mirror: it is dark (off by less than 2.00e-3)",
            "  left out  a sample: it is like others (estimated rms error at most 4.00e-3)",
            "  left out  a turn: it is small (shapes move by less than 3.00e-15 of the scene)",
        ];
        assert_eq!(plan.to_string(), lines.join("\n"));
        let all = Plan::default().needing("lights: 2").to_string();
        assert_eq!(all, lines[0]);
        let nothing = Plan::default().to_string();
        assert!(nothing.contains("nothing to leave out"), "{nothing}");
    }
}
