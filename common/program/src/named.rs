//! `Named`: values of a flag with their names on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use common::{Sampling, Transfer};

/// A type whose values have names on the command line.
pub trait Named: Copy + Send + Sync + 'static {
    /// The name, the value and its description in the help.
    const NAMES: &'static [(&'static str, Self, &'static str)];
}

/// The parser of these names; `--help` and errors list them.
#[must_use]
pub fn by_name<T: Named>() -> impl TypedValueParser<Value = T> {
    let names = T::NAMES.iter();
    let names = names.map(|(name, _, help)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(names).try_map(|text| {
        let mut names = T::NAMES.iter();
        let found = names.find_map(|(name, value, _)| (*name == text).then_some(*value));
        found.ok_or("there is no value of this name")
    })
}

impl Named for Sampling {
    const NAMES: &'static [(&'static str, Self, &'static str)] = &[
        ("center", Self::Center, "One sample in the middle"),
        (
            "regular",
            Self::Regular,
            "A square grid, each sample in the middle of its cell",
        ),
        ("random", Self::Random, "Anywhere in the pixel"),
        (
            "stratified",
            Self::Stratified,
            "A square grid, each sample anywhere in its cell",
        ),
    ];
}

impl Named for Transfer {
    const NAMES: &'static [(&'static str, Self, &'static str)] = &[
        (
            "linear",
            Self::Linear,
            "None: the value is written as it is, as in the course's pictures",
        ),
        ("gamma", Self::Gamma, "A plain power with exponent 1/2.2"),
        (
            "srgb",
            Self::Srgb,
            "The curve of sRGB (IEC 61966-2-1), which screens expect",
        ),
    ];
}
