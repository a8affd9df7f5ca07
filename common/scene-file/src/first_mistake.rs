//! `FirstMistake`: the first mistake of a file, in the order in which a person reads it.

use crate::{Error, SceneFile};

/// The first of all mistakes that a reader of a scene file meets in any order.
#[derive(Clone, Debug, Default)]
pub struct FirstMistake {
    first: Option<Error>,
    /// Whether the tables have mistakes already, which may be the reason why something is missing.
    ignores_missing: bool,
}

impl FirstMistake {
    /// The first mistake in the tables of a file, before anything is made of their values.
    #[must_use]
    pub fn of(file: &SceneFile) -> Self {
        Self {
            first: file.mistake.clone(),
            ignores_missing: file.mistake.is_some(),
        }
    }

    /// The value of a result. Its error is kept if it stands before the others.
    pub fn keep<T>(&mut self, result: Result<T, Error>) -> Option<T> {
        result.map_err(|error| self.add(error)).ok()
    }

    /// Keeps a mistake if it stands before the others.
    pub fn add(&mut self, error: Error) {
        let is_reason = !(error.is_missing && self.ignores_missing);
        let is_first = |first: &Error| error.at < first.at;
        if is_reason && self.first.as_ref().is_none_or(is_first) {
            self.first = Some(error);
        }
    }

    /// What was made of the values, if there is no mistake.
    pub fn result<T>(self, made: Option<T>) -> Result<T, Error> {
        match (self.first, made) {
            (None, Some(made)) => Ok(made),
            (Some(first), _) => Err(first),
            (None, None) => Err(Error::new(0, "the file cannot be read")),
        }
    }
}
