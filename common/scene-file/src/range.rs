//! `Range`: an interval of numbers, as the list of keys writes it.

use common::text;

/// An interval of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least number, or the one that all are above.
    pub least: f64,
    /// The greatest number, or the one that all are below.
    pub greatest: f64,
    /// Whether its ends do not belong to it.
    pub is_open: bool,
}

impl Range {
    /// All numbers.
    pub const ALL: Self = Self {
        least: f64::NEG_INFINITY,
        greatest: f64::INFINITY,
        is_open: false,
    };

    /// The range of a text such as `0 to 1`, `at least 0` or `above 0, below 180`; all numbers if it
    /// is empty.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let number = |text: &str| text.trim().parse::<f64>().ok();
        let between = |pair: Option<(&str, &str)>, is_open| {
            let (least, greatest) = pair?;
            Some(Self {
                least: number(least)?,
                greatest: number(greatest)?,
                is_open,
            })
        };
        let at_least = || {
            let least = number(text.strip_prefix("at least ")?)?;
            Some(Self { least, ..Self::ALL })
        };
        let open = text.strip_prefix("above ");
        between(text.split_once(" to "), false)
            .or_else(|| between(open?.split_once(", below "), true))
            .or_else(at_least)
            .or_else(|| text.is_empty().then_some(Self::ALL))
    }

    /// Whether a number belongs to it.
    #[must_use]
    pub fn contains(self, number: f64) -> bool {
        let is_end = number == self.least || number == self.greatest;
        (self.least..=self.greatest).contains(&number) && !(self.is_open && is_end)
    }

    /// The numbers in words, behind "must be".
    #[must_use]
    pub fn words(self) -> String {
        let [least, greatest] = [self.least, self.greatest].map(text::number);
        match self {
            Self { is_open: true, .. } => format!("above {least} and below {greatest}"),
            Self {
                greatest: f64::INFINITY,
                ..
            } => format!("at least {least}"),
            _ => format!("from {least} to {greatest}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_read_and_ends_belong_to_closed_ranges() {
        for (text, inside, outside) in [
            ("0 to 1", [0.0, 1.0], [-1e-9, 1.1]),
            ("-1e100 to 1e100", [-1e100, 1e100], [-2e100, 2e100]),
            ("above 0, below 180", [1e-9, 179.9], [0.0, 180.0]),
            ("at least 0", [0.0, 1e300], [-0.1, f64::NAN]),
        ] {
            let range = Range::parse(text).unwrap();
            assert!(inside.iter().all(|x| range.contains(*x)), "{text}");
            assert!(!outside.iter().any(|x| range.contains(*x)), "{text}");
        }
    }
}
