//! `Form`: the form of a value in a scene file.

use crate::kind;

/// The form of the value of a key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Form {
    /// Numbers in lists of these lengths, the outermost first; a single number has none.
    Numbers {
        /// The lengths of the lists.
        lengths: Vec<usize>,
        /// Whether the numbers are whole, from 1.
        are_whole: bool,
    },
    /// Three numbers, or a text.
    Color,
    /// A text.
    Text,
    /// The name of a mesh file.
    Mesh,
    /// True or false.
    Flag,
    /// Tables of the kind of this name.
    Tables(&'static str),
}

impl Form {
    /// The form of a cell of `keys.md`, such as `3 x 4 numbers`, `color` or `{ step }`.
    pub(crate) fn parse(text: &'static str) -> Option<Self> {
        Some(match text {
            "color" => Self::Color,
            "text" => Self::Text,
            "mesh file" => Self::Mesh,
            "true or false" => Self::Flag,
            header if header.starts_with(['[', '{']) => Self::Tables(kind::name(header)),
            numbers => {
                let before = numbers.trim_end_matches('s').strip_suffix("number")?;
                let before_whole = before.strip_suffix("whole ");
                let words = before_whole.unwrap_or(before).split_whitespace();
                let lengths = words.filter(|word| *word != "x").map(str::parse);
                Self::Numbers {
                    lengths: lengths.collect::<Result<_, _>>().ok()?,
                    are_whole: before_whole.is_some(),
                }
            }
        })
    }

    /// The lengths of the lists of numbers; none if the value has no numbers.
    #[must_use]
    pub fn lengths(&self) -> Option<&[usize]> {
        match self {
            Self::Numbers { lengths, .. } => Some(lengths),
            Self::Color => Some(&[3]),
            Self::Text | Self::Mesh | Self::Flag | Self::Tables(_) => None,
        }
    }

    /// Whether its numbers are whole.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        matches!(
            self,
            Self::Numbers {
                are_whole: true,
                ..
            }
        )
    }

    /// The form in words, behind "must be".
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Color => "a color, such as [1, 0.5, 0], \"#ff8000\" or \"orange\"".to_owned(),
            Self::Text | Self::Mesh => "a text in quotation marks".to_owned(),
            Self::Flag => "true or false".to_owned(),
            Self::Tables("step") => "a list of steps, such as [{ scale = [1, 2, 1] }]".to_owned(),
            Self::Tables(name) => format!("a table: {}", kind::find(name).header),
            Self::Numbers { lengths, are_whole } => {
                let lengths: Vec<_> = lengths.iter().map(usize::to_string).collect();
                match (lengths.join(" x "), are_whole) {
                    (none, false) if none.is_empty() => "a finite number".to_owned(),
                    (none, true) if none.is_empty() => "a whole number from 1".to_owned(),
                    (lengths, false) => format!("a list of {lengths} numbers, all of them finite"),
                    (lengths, true) => format!("a list of {lengths} whole numbers from 1"),
                }
            }
        }
    }
}
