//! `SceneFile`: reads the tables of a scene file, and refuses unknown ones.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::error::nearest;
use crate::numbers::numbers;
use crate::{Data, Error, Item, KINDS, Key, Kind, Mesh};

/// Reads the mesh of this name, beside the scene file. The error is one clause.
pub type Meshes<'a> = &'a dyn Fn(&str) -> Result<Mesh, String>;

/// Beginnings of the parser's errors, and words for readers who do not know its terms.
const MISTAKES: [(&str, &str); 5] = [
    (
        "duplicate key",
        "this name is taken: a key stands once in its table, spheres, lights and the like have \
         two pairs of brackets, as [[sphere]], and the shapes of a group stand behind its [[group]]",
    ),
    (
        "string values must be",
        "a text stands in quotation marks, and a list has commas, as [0, 1, 0]",
    ),
    (
        "missing comma between array elements",
        "the list before this place has no ] at its end, or lacks a comma",
    ),
    (
        "missing key for inline table element",
        "the braces before this place have no } at their end, or lack a key",
    ),
    (
        "unexpected key or value",
        "a line has one value, and a number a point, as 0.8",
    ),
];

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
    /// Reads the text of a scene file for a stage.
    pub fn read(text: &str, stage: u8, meshes: Meshes) -> Result<Self, Error> {
        let table = DeTable::parse(text).map_err(|error| Error {
            at: error.span().unwrap_or_default().start,
            text: MISTAKES
                .iter()
                .find(|(begin, _)| error.message().starts_with(begin))
                .map_or_else(
                    || error.message().replace('\n', ", "),
                    |(_, text)| text.to_string(),
                ),
        })?;
        let reader = Reader { stage, meshes };
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
        for item in reader.item(&KINDS[0], "", 0, table.get_ref(), 0)?.tables {
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
    stage: u8,
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
        for (name, value) in table {
            let key = self.known(kind, name)?;
            if groups > 0 && ["color", "material"].contains(&key.name) {
                let text = "a shape in a group has the color or material of the outermost group";
                return Err(error(name, text.to_owned()));
            }
            let Some(kind) = key.tables() else {
                let data = self.data(key, value)?;
                item.values.push((key.name, value.span().start, data));
                continue;
            };
            let groups = groups + usize::from(item.kind.name == "group");
            for (name, value) in tables(key, value)? {
                let DeValue::Table(table) = value.get_ref() else {
                    return Err(wrong(key, value));
                };
                let at = value.span().start;
                item.tables.push(self.item(kind, name, at, table, groups)?);
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
        Ok(item)
    }

    /// The key of this name, if the stage knows it.
    fn known(&self, kind: &'static Kind, name: &Spanned<DeString>) -> Result<&'static Key, Error> {
        let (text, own) = (name.get_ref(), self.stage);
        match kind.key(text) {
            Some(key) if key.stage <= own => return Ok(key),
            Some(Key { stage, .. }) => {
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
        let right = match owners.next() {
            Some(owner) => format!("; {} has it", owner.form),
            None => nearest(&known(kind).map(|key| key.name).collect::<Vec<_>>(), text),
        };
        Err(error(
            name,
            format!("{} has no \"{text}\"{right}", kind.name),
        ))
    }

    /// The value of a key.
    fn data(&self, key: &Key, value: &Spanned<DeValue>) -> Result<Data, Error> {
        match (key.form, value.get_ref()) {
            ("text", DeValue::String(file)) if key.name == "file" => {
                let cannot = |reason| error(value, format!("cannot read {file}: {reason}"));
                let mut mesh = (self.meshes)(file).map_err(cannot)?;
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
    error(value, format!("{} must be {}", key.name, key.needed()))
}
