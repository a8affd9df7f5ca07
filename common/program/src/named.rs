//! `Named`: values of a flag with their names on the command line.

use clap::ValueEnum;
use clap::builder::{EnumValueParser, PossibleValue, TypedValueParser};
use common::{Sampling, Transfer};

/// A value that has a name on the command line.
#[derive(Clone)]
pub struct Named<T>(T);

/// The parser of these names; `--help` and errors list them.
#[must_use]
pub fn by_name<T>() -> impl TypedValueParser<Value = T>
where
    Named<T>: ValueEnum + Send + Sync + 'static,
    T: Clone + Send + Sync + 'static,
{
    EnumValueParser::<Named<T>>::new().map(|named| named.0)
}

impl ValueEnum for Named<Sampling> {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self(Sampling::Center),
            Self(Sampling::Regular),
            Self(Sampling::Random),
            Self(Sampling::Stratified),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self.0 {
            Sampling::Center => ("center", "One sample in the middle"),
            Sampling::Regular => (
                "regular",
                "A square grid, each sample in the middle of its cell",
            ),
            Sampling::Random => ("random", "Anywhere in the pixel"),
            Sampling::Stratified => (
                "stratified",
                "A square grid, each sample anywhere in its cell",
            ),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

impl ValueEnum for Named<Transfer> {
    fn value_variants<'a>() -> &'a [Self] {
        &[
            Self(Transfer::Linear),
            Self(Transfer::Gamma),
            Self(Transfer::Srgb),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self.0 {
            Transfer::Linear => (
                "linear",
                "None: the value is written as it is, as in the course's pictures",
            ),
            Transfer::Gamma => ("gamma", "A plain power with exponent 1/2.2"),
            Transfer::Srgb => (
                "srgb",
                "The curve of sRGB (IEC 61966-2-1), which screens expect",
            ),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_has_its_name() {
        let sampling = |name| Named::<Sampling>::from_str(name, false).map(|named| named.0);
        assert_eq!(sampling("center"), Ok(Sampling::Center));
        assert_eq!(sampling("regular"), Ok(Sampling::Regular));
        assert_eq!(sampling("random"), Ok(Sampling::Random));
        assert_eq!(sampling("stratified"), Ok(Sampling::Stratified));
        let transfer = |name| Named::<Transfer>::from_str(name, false).map(|named| named.0);
        assert_eq!(transfer("linear"), Ok(Transfer::Linear));
        assert_eq!(transfer("gamma"), Ok(Transfer::Gamma));
        assert_eq!(transfer("srgb"), Ok(Transfer::Srgb));
    }
}
