//! Random scene files, made of the list of all tables and keys: a new shape, light or key is in them by its row
//! there.

mod meshes;
mod numbers;
mod writer;

use std::collections::{BTreeMap, BTreeSet};

use scene_file::{FILE, Form, Kind, Mesh};
use toml::de::{DeTable, DeValue};

pub use meshes::MESHES;
pub use numbers::{Below, Numbers, Style};
use writer::Writer;

/// A scene file and the meshes that it names.
#[derive(Clone, Debug, Default)]
pub struct SceneText {
    /// The text of the file.
    pub scene: String,
    /// The OBJ files, by their names.
    pub meshes: BTreeMap<&'static str, String>,
}

impl SceneText {
    /// A random scene of a style, for a stage. Tables that `accepts` refuses are left out, each by itself.
    pub fn new(below: Below, style: Style, stage: u8, accepts: &dyn Fn(&Self) -> bool) -> Self {
        Writer::new(below, style, stage, accepts).scene()
    }

    /// Reads the mesh of this name.
    pub fn mesh(&self, name: &str) -> Result<Mesh, String> {
        let mesh = self.meshes.get(name).ok_or("no mesh")?;
        Mesh::read(mesh.as_bytes())
    }

    /// The same files, in which each 0 is negative.
    #[must_use]
    pub fn with_negative_zeros(&self) -> Self {
        let negated = |text: &String| text.replace("-0e0", "0e0").replace("0e0", "-0e0");
        Self {
            scene: negated(&self.scene),
            meshes: self
                .meshes
                .iter()
                .map(|(name, mesh)| (*name, negated(mesh)))
                .collect(),
        }
    }
}

/// A table of this name with random values of its keys, but without the surface of a shape, for a stage.
pub fn table(name: &str, below: Below, stage: u8) -> String {
    Writer::new(below, Style::Plain, stage, &|_| true).table(name)
}

/// The tables of a scene file with their keys, such as "sphere radius".
pub fn keys(scene: &str) -> Result<BTreeSet<String>, toml::de::Error> {
    let table = DeTable::parse(scene)?.into_inner();
    let mut found = BTreeSet::new();
    add_keys(&FILE, &DeValue::Table(table), &mut found);
    Ok(found)
}

fn add_keys(kind: &Kind, value: &DeValue, found: &mut BTreeSet<String>) {
    match value {
        DeValue::Array(tables) => {
            for table in tables {
                add_keys(kind, table.get_ref(), found);
            }
        }
        DeValue::Table(table) => {
            for (name, value) in table {
                let Some(key) = kind.key(name.get_ref()) else {
                    // The name of a material or a definition.
                    add_keys(kind, value.get_ref(), found);
                    continue;
                };
                found.insert(format!("{} {}", kind.name, key.name));
                if let Form::Tables(name) = key.form {
                    add_keys(writer::kind(name), value.get_ref(), found);
                }
            }
        }
        _ => {}
    }
}

fn list(numbers: &[f64]) -> String {
    format!("[{}]", written(numbers, ", "))
}

/// Numbers with these characters between them; each 0 is `0e0`.
fn written(numbers: &[f64], between: &str) -> String {
    let number = |x: &f64| match *x {
        0.0 if x.is_sign_negative() => "-0e0".to_owned(),
        0.0 => "0e0".to_owned(),
        x => format!("{x:?}").replace("NaN", "nan"),
    };
    let numbers: Vec<_> = numbers.iter().map(number).collect();
    numbers.join(between)
}
