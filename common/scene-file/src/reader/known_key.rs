//! The key that a name in a scene file is, or an error that says which one was probably meant.

use common::text;
use toml::Spanned;
use toml::de::DeString;

use super::{Reader, error};
use crate::error::nearest;
use crate::synonyms::known_for;
use crate::{Error, Item, Key, Kind, Notation, TABLES, kind};

impl Reader<'_> {
    /// The key of a table that has this name, if the stage knows it.
    pub(super) fn known(
        &self,
        item: &Item,
        name: &Spanned<DeString>,
    ) -> Result<&'static Key, Error> {
        let (kind, text) = (item.kind, name.get_ref());
        match kind.key(text) {
            Some(key) if key.stage <= self.stage => Ok(key),
            Some(Key { stage, .. }) => {
                let (text, own) = (text::name(text), self.stage);
                let text = format!("{text} is known from stage {stage} on, and this is {own}");
                Err(error(name, text))
            }
            None => {
                let right = self.right_name(item, text);
                let text = format!("{} has no \"{}\"{right}", kind.name, text::name(text));
                Err(error(name, text))
            }
        }
    }

    /// The names of the keys of a kind that the stage knows.
    fn names(&self, kind: &'static Kind) -> Vec<&'static str> {
        let known = kind.keys.iter().filter(|key| key.stage <= self.stage);
        known.map(|key| key.name).collect()
    }

    /// What was probably meant by the name of a key that a table does not have, or where it stands,
    /// as the end of an error.
    fn right_name(&self, item: &Item, name: &str) -> String {
        let names = self.names(item.kind);
        if known_for(&names, name).is_some() {
            return nearest(&names, name);
        }
        if names.contains(&"transform") {
            let steps = self.names(kind::find("step"));
            if let Some(step) = known_for(&steps, name) {
                let value = match step {
                    "translate" => "[0, 1, 0]",
                    "scale" => "[2, 2, 2]",
                    "rotate" => "[0, 30, 0]",
                    "matrix" | "inverse" => "[...]",
                    _ => "30",
                };
                return format!(
                    "; it stands in a transform, such as transform = [{{ {step} = {value} }}]"
                );
            }
        }
        if ["group", "repeat"].contains(&name) && names.contains(&"color") {
            return format!("; write [[{name}.{}]]", item.kind.name);
        }
        // A key of the camera at the top of the file, or one of a shape below a material.
        for owner in &*TABLES {
            if self.names(owner).contains(&name) && owner.notation != Notation::Many {
                return match owner.name {
                    "define" => header_missing("[[group]]", item),
                    "step" => nearest(&names, name),
                    _ => format!("; {} has it", owner.header),
                };
            }
        }
        if !names.contains(&"color") && item.kind.name != "step" {
            for owner in &*TABLES {
                if self.names(owner).contains(&name) {
                    return header_missing(owner.header, item);
                }
            }
        }
        nearest(&names, name)
    }
}

/// The end of the error of a key that belongs to another table than the one before it.
fn header_missing(header: &str, above: &Item) -> String {
    let above = above.kind.header.replace("NAME", &text::name(&above.name));
    let below = if above.is_empty() { "" } else { " below " };
    format!("; a header such as {header} is missing{below}{above}")
}
