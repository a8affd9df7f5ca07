//! Definitions and their uses: copies of a repeat become uses of a definition without a name, and
//! each use gets the index of its definition.
//!
//! A definition is read once, however often it is used.

use common::text;

use crate::error::nearest;
use crate::{Data, Error, Item, kind};

/// Most groups, repeats, uses and transforms inside each other.
pub const MAX_LEVELS: usize = 32;

/// Most copies that all repeats of a file make, and most shapes after all copies are made. A mesh
/// counts as one shape.
pub const MAX_COPIES: f64 = 100_000.0;
const MAX_SHAPES: u64 = 1_000_000;

/// The copies of a repeat, as uses of the definition with this index: copy i is rotated by i times
/// the angles, and then displaced by i times the translation.
pub fn copies(repeat: &Item, definition: usize) -> Vec<Item> {
    let find = |key: &str| repeat.find_rows::<3, 1>(key).map(|[numbers]| numbers);
    let (translate, rotate) = (find("translate"), find("rotate"));
    let at = |key: &str| repeat.error(key, "").at;
    let count = repeat.number("count").unwrap_or(0.0);
    let step = |key: &'static str, numbers: [f64; 3], i: u32| {
        let numbers = numbers.map(|number| f64::from(i) * number);
        Item {
            values: vec![(key, at(key), Data::Numbers(numbers.to_vec()))],
            ..Item::new(kind::find("step"), "", at(key))
        }
    };
    let copy = |i: u32| {
        let translate = translate.map(|numbers| step("translate", numbers, i));
        let rotate = rotate.map(|numbers| step("rotate", numbers, i));
        Item {
            tables: translate.into_iter().chain(rotate).collect(),
            used: Some(definition),
            ..Item::new(kind::find("use"), "", repeat.at)
        }
    };
    (0..count as u32).map(copy).collect()
}

/// Gives each use in these shapes and definitions the index of its definition. The error is a
/// definition that is missing or that uses itself, or too many shapes.
pub fn resolve(shapes: &mut [Item], definitions: &mut [Item]) -> Result<(), Error> {
    let names: Vec<_> = definitions.iter().map(|item| item.name.clone()).collect();
    for item in shapes.iter_mut().chain(&mut *definitions) {
        find_definitions(item, &names)?;
    }
    let mut extents = Extents {
        definitions,
        known: vec![Known::No; definitions.len()],
    };
    let mut all = 0;
    for (index, definition) in definitions.iter().enumerate() {
        // Those of repeats are found where their copies are, so that an error names another one.
        if !definition.name.is_empty() {
            extents.of_definition(index, definition, 1)?;
        }
    }
    // Definitions that nobody uses do not count.
    for item in &*shapes {
        all = extents.of_item(item, 1)?.shapes.saturating_add(all);
        if all > MAX_SHAPES {
            let text =
                format!("the scene has more than {MAX_SHAPES} shapes, with all of its copies");
            return Err(item.error("", text));
        }
    }
    Ok(())
}

fn find_definitions(item: &mut Item, names: &[String]) -> Result<(), Error> {
    if let Some(Data::Text(name)) = item.find("name").filter(|_| item.kind.name == "use") {
        let found = names.iter().position(|known| known == name);
        if found.is_none() {
            // The definitions of repeats have no names.
            let named = names.iter().map(String::as_str);
            let named: Vec<_> = named.filter(|name| !name.is_empty()).collect();
            let (nearest, name) = (nearest(&named, name), text::name(name));
            let text = format!("there is no definition \"{name}\"{nearest}");
            return Err(Error {
                is_missing: true,
                ..item.error("name", text)
            });
        }
        item.used = found;
    }
    for table in &mut item.tables {
        find_definitions(table, names)?;
    }
    Ok(())
}

/// How large a table is after all copies are made.
#[derive(Clone, Copy)]
struct Extent {
    shapes: u64,
    levels: usize,
}

/// What is known about the extent of a definition.
#[derive(Clone, Copy)]
enum Known {
    No,
    /// It is being measured: who asks for it again is a part of it.
    Begun,
    Extent(Extent),
}

struct Extents<'a> {
    definitions: &'a [Item],
    known: Vec<Known>,
}

impl Extents<'_> {
    /// The extent of a definition that `user` uses at a level.
    fn of_definition(&mut self, index: usize, user: &Item, level: usize) -> Result<Extent, Error> {
        match self.known[index] {
            Known::Extent(extent) => return Ok(extent),
            Known::Begun => {
                let name = text::name(&self.definitions[index].name);
                let text = format!("the definition \"{name}\" uses itself");
                return Err(user.error("name", text));
            }
            Known::No => self.known[index] = Known::Begun,
        }
        let extent = self.of_tables(&self.definitions[index], level)?;
        self.known[index] = Known::Extent(extent);
        Ok(extent)
    }

    fn of_item(&mut self, item: &Item, level: usize) -> Result<Extent, Error> {
        match (item.used, item.kind.name) {
            (Some(index), _) => {
                let used = self.of_definition(index, item, level + 1)?;
                around(used, item)
            }
            (None, "group" | "repeat") => self.of_tables(item, level),
            (None, _) => around(
                Extent {
                    shapes: 1,
                    levels: 0,
                },
                item,
            ),
        }
    }

    /// The extent of a table with shapes.
    fn of_tables(&mut self, item: &Item, level: usize) -> Result<Extent, Error> {
        if level > MAX_LEVELS {
            return Err(too_deep(item));
        }
        let mut all = Extent {
            shapes: 0,
            levels: 0,
        };
        for table in item.shapes() {
            let extent = self.of_item(table, level + 1)?;
            all.shapes = all.shapes.saturating_add(extent.shapes);
            all.levels = all.levels.max(extent.levels);
        }
        around(all, item)
    }
}

/// The extent with a table around it.
fn around(inside: Extent, item: &Item) -> Result<Extent, Error> {
    let levels = inside.levels + 1;
    if levels > MAX_LEVELS {
        return Err(too_deep(item));
    }
    Ok(Extent { levels, ..inside })
}

/// The error of a table that is too deep inside of others.
pub fn too_deep(item: &Item) -> Error {
    let text =
        format!("there are more than {MAX_LEVELS} groups, uses or repeats inside each other");
    item.error("", text)
}
