//! Values of flags with their names on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use common::{Sampling, Transfer};

/// A name on the command line, its value and its description in the help.
pub type Named<T> = (&'static str, T, &'static str);

/// The parser of these names; `--help` and errors list them.
#[must_use]
pub fn by_name<T>(values: &'static [Named<T>]) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let names = values.iter();
    let names = names.map(|(name, _, help)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(names).try_map(|text| {
        let mut names = values.iter();
        let found = names.find_map(|(name, value, _)| (*name == text).then_some(*value));
        found.ok_or("there is no value of this name")
    })
}

/// The places of samples.
pub const SAMPLINGS: &[Named<Sampling>] = &[
    ("center", Sampling::Center, "One sample in the middle"),
    (
        "regular",
        Sampling::Regular,
        "A square grid, each sample in the middle of its cell",
    ),
    ("random", Sampling::Random, "Anywhere in the pixel"),
    (
        "stratified",
        Sampling::Stratified,
        "A square grid, each sample anywhere in its cell",
    ),
];

/// The curves between light and the values in a file.
pub const TRANSFERS: &[Named<Transfer>] = &[
    (
        "linear",
        Transfer::Linear,
        "None: the value is written as it is, as in the course's pictures",
    ),
    (
        "gamma",
        Transfer::Gamma,
        "A plain power with exponent 1/2.2",
    ),
    (
        "srgb",
        Transfer::Srgb,
        "The curve of sRGB (IEC 61966-2-1), which screens expect",
    ),
];
