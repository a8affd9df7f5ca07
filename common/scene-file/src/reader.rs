//! `SceneFile`: reads the tables of a scene file, and refuses unknown ones.

use std::cell::Cell;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::nearest;
use crate::numbers::numbers;
use crate::{Data, Error, Item, KINDS, Kind, Mesh, Place, Role};

/// Reads the file of this name, beside the scene file. The error is one clause.
pub type Files<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// The error of a name that is there twice.
const DUPLICATE: &str = "this name is taken: spheres, lights and the like have two pairs of \
    brackets, as [[sphere]], and the shapes of a group stand behind its [[group]]";

/// Most groups inside each other.
const MOST_GROUPS: usize = 32;

/// The tables of a scene file. Those that may be there once have no keys if they are missing.
#[derive(Debug)]
pub struct SceneFile {
    /// The table `[picture]`.
    pub picture: Item,
    /// The table `[camera]`.
    pub camera: Item,
    /// The table `[world]`.
    pub world: Item,
    /// The number of triangles in meshes.
    pub triangles: usize,
    /// All other tables, in their order.
    items: Vec<Item>,
}

impl SceneFile {
    /// Reads the text of a scene file for a stage.
    pub fn read(text: &str, stage: u8, files: Files) -> Result<Self, Error> {
        let reader = Reader {
            text,
            lines: text.match_indices('\n').map(|(at, _)| at + 1).collect(),
            stage,
            files,
            triangles: Cell::new(0),
        };
        let table = DeTable::parse(text).map_err(|error| Error {
            place: reader.place(error.span().unwrap_or_default().start),
            text: match error.message() {
                "duplicate key" => DUPLICATE.to_owned(),
                message => message.replace('\n', ", "),
            },
        })?;
        let mut items = Vec::new();
        for (name, value) in table.get_ref() {
            let kinds = KINDS.iter().filter(|kind| kind.role != Role::Step);
            let kinds = kinds.map(|kind| (kind.name, kind.stage(), kind));
            let kind = reader.known(kinds, name, "a scene file")?;
            reader.add_items(kind, value, 0, &mut items)?;
        }
        items.sort_by_key(|item| item.place);
        let [picture, camera, world] = [0, 1, 2].map(|i| {
            let kind = &KINDS[i];
            let found = items.iter().position(|item| item.kind.name == kind.name);
            let begin = Place { line: 1, column: 1 };
            found.map_or_else(|| Item::new(kind, begin), |found| items.remove(found))
        });
        let triangles = reader.triangles.get();
        Ok(Self {
            picture,
            camera,
            world,
            triangles,
            items,
        })
    }

    /// The tables of a role.
    pub fn all(&self, role: Role) -> impl Iterator<Item = &Item> + Clone {
        self.items.iter().filter(move |item| item.kind.role == role)
    }
}

struct Reader<'a> {
    text: &'a str,
    /// The first bytes of all lines but the first.
    lines: Vec<usize>,
    stage: u8,
    files: Files<'a>,
    triangles: Cell<usize>,
}

impl Reader<'_> {
    /// The position of a byte.
    fn place(&self, at: usize) -> Place {
        let above = self.lines.partition_point(|begin| *begin <= at);
        let begin = above.checked_sub(1).map_or(0, |last| self.lines[last]);
        let before = self.text.get(begin..at).unwrap_or_default();
        Place {
            line: above + 1,
            column: before.chars().count() + 1,
        }
    }

    /// An error at a value or a key.
    fn error<T>(&self, at: &Spanned<T>, text: String) -> Error {
        let place = self.place(at.span().start);
        Error { place, text }
    }

    /// The item of this name among those that the stage knows: names, first stages and items.
    fn known<T>(
        &self,
        known: impl Iterator<Item = (&'static str, u8, T)>,
        name: &Spanned<impl AsRef<str>>,
        within: &str,
    ) -> Result<T, Error> {
        let (text, own) = (name.get_ref().as_ref(), self.stage);
        let mut names = Vec::new();
        for (known, stage, item) in known {
            match (known == text, stage <= own) {
                (true, true) => return Ok(item),
                (true, false) => {
                    let text = format!("{text} is known from stage {stage} on, and this is {own}");
                    return Err(self.error(name, text));
                }
                (false, true) => names.push(known),
                (false, false) => (),
            }
        }
        // A key of the camera at the top of the file, or the transform of a mesh.
        let mut owners = KINDS.iter().filter(|kind| kind.stage() <= own);
        let owner = owners.find(|kind| {
            (kind.role == Role::Single || kind.name == "group") && kind.key(text).is_some()
        });
        let right = match owner {
            Some(owner) => format!("; {} has it", owner.written),
            None => nearest(&names, text),
        };
        Err(self.error(name, format!("{within} has no \"{text}\"{right}")))
    }

    /// Adds the tables of a kind.
    fn add_items(
        &self,
        kind: &'static Kind,
        value: &Spanned<DeValue>,
        groups: usize,
        items: &mut Vec<Item>,
    ) -> Result<(), Error> {
        let name = kind.name;
        let wrong = |value| {
            let text = format!("a {name} must be a table: {}", kind.written);
            self.error(value, text)
        };
        let tables: Vec<(&str, _)> = match (kind.role, value.get_ref()) {
            (Role::Single | Role::Step, _) => vec![(name, value)],
            (Role::Named, DeValue::Table(tables)) => {
                let tables = tables.iter();
                tables
                    .map(|(name, value)| (&**name.get_ref(), value))
                    .collect()
            }
            (Role::Light | Role::Shape, DeValue::Array(tables)) => {
                tables.iter().map(|value| (name, value)).collect()
            }
            _ => return Err(wrong(value)),
        };
        for (name, value) in tables {
            let DeValue::Table(table) = value.get_ref() else {
                return Err(wrong(value));
            };
            if groups > MOST_GROUPS {
                let text = format!("there are more than {MOST_GROUPS} groups inside each other");
                return Err(self.error(value, text));
            }
            let mut item = Item::new(kind, self.place(value.span().start));
            name.clone_into(&mut item.name);
            self.fill(&mut item, table, groups)?;
            items.push(item);
        }
        Ok(())
    }

    /// Adds the values and shapes of a table.
    fn fill(&self, item: &mut Item, table: &DeTable, groups: usize) -> Result<(), Error> {
        let kind = item.kind;
        for (name, value) in table {
            let shape = |shape: &&Kind| shape.role == Role::Shape && shape.name == name.get_ref();
            if kind.name == "group"
                && let Some(shape) = KINDS.iter().find(shape)
            {
                self.add_items(shape, value, groups + 1, &mut item.shapes)?;
                continue;
            }
            if groups > 0 && ["color", "material"].contains(&&**name.get_ref()) {
                let text = "a shape in a group has the color or material of the outermost group";
                return Err(self.error(name, text.to_owned()));
            }
            let keys = kind.keys.iter().map(|key| (key.name, key.stage, key));
            let key = self.known(keys, name, kind.name)?;
            let data = match (key.form, value.get_ref()) {
                ("text", DeValue::String(file)) if key.name == "file" => {
                    let mesh = (self.files)(file).and_then(|bytes| Mesh::read(&bytes));
                    let mesh = mesh.map_err(|error| {
                        self.error(value, format!("cannot open {file}: {error}"))
                    })?;
                    let triangles = self.triangles.get() + mesh.triangles().count();
                    self.triangles.set(triangles);
                    Some(Data::Mesh(mesh))
                }
                ("text", DeValue::String(text)) => Some(Data::Text(text.to_string())),
                ("true or false", DeValue::Boolean(flag)) => Some(Data::Flag(*flag)),
                ("steps", DeValue::Array(steps)) => {
                    let mut items = Vec::new();
                    for step in steps {
                        self.add_items(&KINDS[KINDS.len() - 1], step, groups, &mut items)?;
                    }
                    Some(Data::Steps(items))
                }
                (form, value) => numbers(value, form).map(Data::Numbers),
            };
            let wrong = || self.error(value, format!("{} must be {}", key.name, key.needed()));
            let data = data.ok_or_else(wrong)?;
            item.values
                .push((key.name, self.place(value.span().start), data));
        }
        item.shapes.sort_by_key(|item| item.place);
        Ok(())
    }
}
