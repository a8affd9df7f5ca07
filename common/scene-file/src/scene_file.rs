//! `SceneFile`: the tables of a scene file.

use std::borrow::Cow;

use common::Transfer;
use toml::de::DeTable;

use crate::mistake::mistake;
use crate::reader::Reader;
use crate::{Error, FILE, FirstMistake, Item, Mesh, kind, uses};

/// Reads the mesh of this name, beside the scene file. The error is one clause.
pub type Meshes<'a> = &'a dyn Fn(&str) -> Result<Mesh, String>;

/// The tables of a scene file, each kind in the order of the file. Those that may be there once
/// have no values if they are missing.
#[derive(Clone, Debug)]
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
    /// The shapes that are in no group, the groups, and the uses of definitions.
    pub shapes: Vec<Item>,
    /// The definitions, also those that the copies of a repeat are uses of.
    pub definitions: Vec<Item>,
    /// The transfer by which the colours in bytes are decoded.
    transfer: Transfer,
    /// Notes about the meshes that are drawn in another way than their files say, each a clause
    /// with the name of the file.
    pub notes: Vec<String>,
    /// The first mistake in the tables. What is made of their values may have others, before it:
    /// see [`FirstMistake`](crate::FirstMistake).
    pub mistake: Option<Error>,
}

impl SceneFile {
    /// Reads the text of a scene file for a stage. The error is a text that is no TOML.
    pub fn read(text: &str, stage: u8, meshes: Meshes) -> Result<Self, Error> {
        let table = DeTable::parse(text).map_err(|error| mistake(text, &error))?;
        let mut reader = Reader::new(text, stage, meshes);
        let tables = reader.item(&FILE, "", 0, table.get_ref(), 0).tables;
        let missing = |name| Item::new(kind::find(name), "", 0);
        let mut file = Self {
            picture: missing("picture"),
            camera: missing("camera"),
            world: missing("world"),
            materials: Vec::new(),
            lights: Vec::new(),
            shapes: Vec::new(),
            definitions: reader.definitions,
            transfer: Transfer::Linear,
            notes: Vec::new(),
            mistake: reader.mistake,
        };
        let has_camera = tables.iter().any(|item| item.kind.name == "camera");
        if !has_camera && file.mistake.is_none() {
            let text = "the file has no table [camera], with eye, gaze and angle";
            file.mistake = Some(Error::missing(0, text));
        }
        for item in tables {
            match item.kind.name {
                "picture" => file.picture = item,
                "camera" => file.camera = item,
                "world" => file.world = item,
                "material" => file.materials.push(item),
                "define" => file.definitions.push(item),
                _ if item.kind.is_light() => file.lights.push(item),
                _ => file.shapes.push(item),
            }
        }
        if let Err(error) = uses::resolve(&mut file.shapes, &mut file.definitions) {
            let mut first = FirstMistake::of(&file);
            first.add(error);
            file.mistake = first.result(Some(())).err();
            // Nobody could follow the uses.
            file.shapes.clear();
            file.definitions.clear();
        }
        let mut first = FirstMistake::of(&file);
        for shape in file.shapes.iter().chain(&file.definitions) {
            shape.add_notes(&mut file.notes);
            check_materials(shape, &file.materials, &mut first);
        }
        file.mistake = first.result(Some(())).err();
        Ok(file)
    }

    /// The file with its colours in bytes as those of pictures with this transfer. After reading it
    /// is the linear one.
    #[must_use]
    pub fn with_transfer(&self, transfer: Transfer) -> Cow<'_, Self> {
        if transfer == self.transfer {
            return Cow::Borrowed(self);
        }
        let mut file = self.clone();
        file.transfer = transfer;
        file.world.set_transfer(transfer);
        let lists = [
            &mut file.materials,
            &mut file.lights,
            &mut file.shapes,
            &mut file.definitions,
        ];
        for item in lists.into_iter().flatten() {
            item.set_transfer(transfer);
        }
        Cow::Owned(file)
    }
}

/// Keeps the names of materials that are missing, in a table and those inside of it, also where
/// all shapes have another one.
fn check_materials(item: &Item, materials: &[Item], first: &mut FirstMistake) {
    if item.find("material").is_some() {
        first.keep(item.named("material", materials));
    }
    for table in item.shapes() {
        check_materials(table, materials, first);
    }
}
