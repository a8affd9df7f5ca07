//! `SceneFile`: reads the tables of a scene file, and refuses unknown ones.

use common::text;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::error::nearest;
use crate::kind::OwnKind;
use crate::mistake::{BACKSLASH, mistake};
use crate::numbers::numbers;
use crate::{Data, Error, Item, KINDS, Key, Kind, Mesh, OwnTable};

/// Reads the mesh of this name, beside the scene file. The error is one clause.
pub type Meshes<'a> = &'a dyn Fn(&str) -> Result<Mesh, String>;

/// Most groups inside each other.
const MOST_GROUPS: usize = 32;

/// The tables of a scene file, each kind in the order of the file. Those that may be there once
/// have no values if they are missing.
#[derive(Debug)]
pub struct SceneFile {
    /// The table `[picture]`.
    pub picture: Item,
    /// The table `[camera]`.
    pub camera: Item,
    /// The table `[world]`.
    pub world: Item,
    /// The materials.
    pub materials: Vec<Item>,
    /// The lights.
    pub lights: Vec<Item>,
    /// The shapes that are in no group, and the groups.
    pub shapes: Vec<Item>,
    /// Notes about the meshes that are drawn in another way than their files say, each a clause
    /// with the name of the file.
    pub notes: Vec<String>,
}

impl SceneFile {
    /// Reads the text of a scene file for a stage, which may have tables of its own.
    pub fn read(
        text: &str,
        stage: u8,
        own_tables: &[OwnTable],
        meshes: Meshes,
    ) -> Result<Self, Error> {
        let table = DeTable::parse(text).map_err(|error| mistake(text, &error))?;
        let reader = Reader {
            text,
            stage,
            own: own_tables.iter().map(OwnTable::kind).collect(),
            meshes,
        };
        let missing = |kind: usize| reader.item(&KINDS[kind], "", 0, &DeTable::new(), 0);
        let mut file = Self {
            picture: missing(1)?,
            camera: missing(2)?,
            world: missing(3)?,
            materials: Vec::new(),
            lights: Vec::new(),
            shapes: Vec::new(),
            notes: Vec::new(),
        };
        let tables = reader.item(&KINDS[0], "", 0, table.get_ref(), 0)?.tables;
        if tables.iter().all(|item| item.kind.name != "camera") {
            return Err(Error {
                at: 0,
                text: "the file has no table [camera], with eye, gaze and angle".to_owned(),
            });
        }
        for item in tables {
            match item.kind.name {
                "picture" => file.picture = item,
                "camera" => file.camera = item,
                "world" => file.world = item,
                "material" => file.materials.push(item),
                name if name.ends_with("_light") => file.lights.push(item),
                _ => file.shapes.push(item),
            }
        }
        for shape in &file.shapes {
            shape.add_notes(&mut file.notes);
        }
        Ok(file)
    }
}

struct Reader<'a> {
    text: &'a str,
    stage: u8,
    /// The tables of the stage that `keys.md` does not list.
    own: Vec<&'static OwnKind>,
    meshes: Meshes<'a>,
}

impl Reader<'_> {
    /// A table of a kind in a number of groups, with its values and tables.
    fn item(
        &self,
        kind: &'static Kind,
        name: &str,
        at: usize,
        table: &DeTable,
        groups: usize,
    ) -> Result<Item, Error> {
        if groups > MOST_GROUPS {
            let text = format!("there are more than {MOST_GROUPS} groups inside each other");
            return Err(Error { at, text });
        }
        let mut item = Item {
            kind,
            name: name.to_owned(),
            at,
            values: Vec::new(),
            tables: Vec::new(),
        };
        // The parser sorts the keys by their names; readers mend the first mistake of a file first.
        let mut first_mistake: Option<Error> = None;
        let mut keep = |error: Error| {
            let is_first = first_mistake
                .as_ref()
                .is_none_or(|first| error.at < first.at);
            if is_first {
                first_mistake = Some(error);
            }
        };
        for (name, value) in table {
            let own = self.own_kind(kind, name.get_ref());
            let known = match own {
                Some(own) => Ok(&own.key),
                None => self.known(kind, name),
            };
            let key = match known {
                Ok(key) => key,
                Err(error) => {
                    keep(error);
                    continue;
                }
            };
            if groups > 0 && ["color", "material"].contains(&key.name) {
                let text = "a shape in a group has the color or material of the outermost group";
                keep(error(name, text.to_owned()));
                continue;
            }
            let Some(kind) = own.map(|own| &own.kind).or_else(|| key.tables()) else {
                match self.data(key, value) {
                    Ok(data) => item.values.push((key.name, value.span().start, data)),
                    Err(error) => keep(error),
                }
                continue;
            };
            let groups = groups + usize::from(item.kind.name == "group");
            let tables = tables(key, value).unwrap_or_else(|error| {
                keep(error);
                Vec::new()
            });
            for (name, value) in tables {
                let DeValue::Table(table) = value.get_ref() else {
                    keep(wrong(key, value));
                    continue;
                };
                match self.item(kind, name, value.span().start, table, groups) {
                    Ok(table) => item.tables.push(table),
                    Err(error) => keep(error),
                }
            }
        }
        item.tables.sort_by_key(|table| table.at);
        if let Some(is_smooth) = item.flag("smooth") {
            for (.., data) in &mut item.values {
                if let Data::Mesh(mesh) = data {
                    mesh.set_smooth(is_smooth);
                }
            }
        }
        first_mistake.map_or(Ok(item), Err)
    }

    /// The stage's own kind of tables of this name, where shapes may stand.
    fn own_kind(&self, kind: &Kind, name: &str) -> Option<&'static OwnKind> {
        let mut own = self.own.iter().copied();
        own.find(|own| has_shapes(kind) && own.key.name == name)
    }

    /// The key of this name, if the stage knows it.
    fn known(&self, kind: &'static Kind, name: &Spanned<DeString>) -> Result<&'static Key, Error> {
        let (text, own) = (name.get_ref(), self.stage);
        match kind.key(text) {
            Some(key) if key.stage <= own => return Ok(key),
            Some(Key { stage, .. }) => {
                let text = text::name(text);
                let text = format!("{text} is known from stage {stage} on, and this is {own}");
                return Err(error(name, text));
            }
            None => (),
        }
        let known = |kind: &'static Kind| kind.keys.iter().filter(|key| key.stage <= own);
        // A key of the camera at the top of the file, or the transform of a mesh.
        let mut owners = KINDS[1..].iter().filter(|owner| {
            let is_near = !owner.form.starts_with("[[") || owner.name == "group";
            is_near && known(owner).any(|key| key.name == text)
        });
        let right = if let Some(owner) = owners.next() {
            format!("; {} has it", owner.form)
        } else {
            let own = self.own.iter().filter(|_| has_shapes(kind));
            let own = own.map(|own| own.key.name);
            let names: Vec<_> = known(kind).map(|key| key.name).chain(own).collect();
            nearest(&names, text)
        };
        Err(error(
            name,
            format!("{} has no \"{}\"{right}", kind.name, text::name(text)),
        ))
    }

    /// The value of a key.
    fn data(&self, key: &Key, value: &Spanned<DeValue>) -> Result<Data, Error> {
        match (key.form, value.get_ref()) {
            ("text", DeValue::String(file)) if key.name == "file" => {
                let mesh = (self.meshes)(file);
                let mut mesh = mesh.map_err(|reason| self.cannot_read(file, &reason, value))?;
                mesh.file = file.to_string();
                Ok(Data::Mesh(mesh))
            }
            ("text", DeValue::String(text)) => Ok(Data::Text(text.to_string())),
            ("true or false", DeValue::Boolean(flag)) => Ok(Data::Flag(*flag)),
            (form, numbers) => {
                let numbers = self::numbers(numbers, form).map(Data::Numbers);
                numbers.ok_or_else(|| wrong(key, value))
            }
        }
    }

    /// The error of a mesh that cannot be read. A backslash is a usual mistake in its name.
    fn cannot_read(&self, file: &str, reason: &str, value: &Spanned<DeValue>) -> Error {
        let written = self.text.get(value.span()).unwrap_or_default();
        let are_doubled = written.matches('\\').count() == 2 * file.matches('\\').count();
        let hint = if written.starts_with('"') && !are_doubled {
            format!("; {BACKSLASH}")
        } else if file.contains('\\') && cfg!(not(windows)) {
            "; between folders stands /".to_owned()
        } else {
            String::new()
        };
        let file = text::path(file.as_ref());
        error(value, format!("cannot read {file}: {reason}{hint}"))
    }
}

/// Whether shapes stand in tables of this kind: in the scene file itself, and in groups.
fn has_shapes(kind: &Kind) -> bool {
    kind.form.is_empty() || kind.name == "group"
}

/// The tables of a key, with their names.
fn tables<'a>(
    key: &'a Key,
    value: &'a Spanned<DeValue<'a>>,
) -> Result<Vec<(&'a str, &'a Spanned<DeValue<'a>>)>, Error> {
    let are_in_list = key.form.starts_with("[[") || key.form == "{ step }";
    match value.get_ref() {
        DeValue::Array(list) if are_in_list => {
            Ok(list.iter().map(|table| (key.name, table)).collect())
        }
        DeValue::Table(tables) if key.form.ends_with(".NAME]") => {
            let tables = tables.iter();
            Ok(tables
                .map(|(name, table)| (&**name.get_ref(), table))
                .collect())
        }
        DeValue::Table(_) if !are_in_list => Ok(vec![(key.name, value)]),
        _ => Err(wrong(key, value)),
    }
}

/// An error at a value or a key.
fn error<T>(at: &Spanned<T>, text: String) -> Error {
    let at = at.span().start;
    Error { at, text }
}

/// The error of a value in another form than its key has.
fn wrong(key: &Key, value: &Spanned<DeValue>) -> Error {
    let behind = match key.name {
        "group" => ", behind which its shapes stand, such as [[group.sphere]]",
        _ => "",
    };
    let (name, needed) = (key.name, key.needed());
    error(value, format!("{name} must be {needed}{behind}"))
}
