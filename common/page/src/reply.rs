//! `Reply`: numbers by name, a text and bytes, for a page.

/// The reply to a request of a page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reply {
    /// Lists of numbers, each with its name.
    pub numbers: Vec<(&'static str, Vec<f64>)>,
    /// A text for the reader.
    pub text: String,
    /// Red, green, blue and opacity of the pixels of a picture.
    pub pixels: Vec<u8>,
}

impl Reply {
    /// A reply of a text.
    #[must_use]
    pub fn text(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            ..Self::default()
        }
    }

    /// The same reply with one more list of numbers.
    #[must_use]
    pub fn with(mut self, name: &'static str, numbers: impl IntoIterator<Item = f64>) -> Self {
        self.numbers.push((name, numbers.into_iter().collect()));
        self
    }

    /// The same reply with a table: for each row its numbers, by the names of their columns.
    #[must_use]
    pub fn with_rows<const N: usize>(
        mut self,
        rows: impl IntoIterator<Item = [(&'static str, f64); N]>,
    ) -> Self {
        for (name, number) in rows.into_iter().flatten() {
            match self.numbers.iter_mut().find(|(known, _)| *known == name) {
                Some((_, column)) => column.push(number),
                None => self.numbers.push((name, vec![number])),
            }
        }
        self
    }

    /// The numbers of this name; none if there are none.
    #[must_use]
    pub fn get(&self, name: &str) -> &[f64] {
        let found = self.numbers.iter().find(|(known, _)| *known == name);
        found.map_or(&[], |(_, numbers)| numbers)
    }
}
