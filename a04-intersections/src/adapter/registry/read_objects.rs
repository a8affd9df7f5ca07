//! Reads the shapes of a scene file as objects: geometries that have a surface each.
//!
//! A node has one surface, so that a group whose shapes have several becomes as many nodes with the
//! same transform. They keep the order of the file, which decides between equal hits.

use scene_file::{Error, FirstMistake, Item, SceneFile};

use super::{Content, ShapeKind, Shapes, Shared};
use crate::Geometry;

/// By how much the transforms of a group and of those in it may make lengths longer or shorter.
/// Within these limits no coordinate of a ray becomes infinite or 0.
const MAX_SCALE: f64 = 1e200;

/// A geometry, and the table that has its color or material; none if one around it has.
struct Part<'f> {
    geometry: Box<dyn Geometry>,
    surface: Option<&'f Item>,
    /// The table of its first shape, or of a use.
    first: &'f Item,
    /// By how much its transforms make lengths longer or shorter, at most.
    scale: f64,
}

/// The parts of a definition: shapes, their surface, and the scale of their transforms.
type SharedParts<'f> = Vec<(Shared, Option<&'f Item>, f64)>;

struct Reader<'f> {
    shapes: Shapes,
    definitions: &'f [Item],
    /// The parts of each definition that has been used.
    known: Vec<Option<SharedParts<'f>>>,
}

impl Shapes {
    /// The shapes of a file, each with its surface. Mistakes are kept in `first`.
    pub fn read_objects<S>(
        self,
        file: &SceneFile,
        first: &mut FirstMistake,
        surface: impl Fn(&Item) -> Result<S, Error>,
    ) -> Vec<(Box<dyn Geometry>, S)> {
        let mut reader = Reader {
            shapes: self,
            definitions: &file.definitions,
            known: file.definitions.iter().map(|_| None).collect(),
        };
        let mut objects = Vec::new();
        for item in &file.shapes {
            let Some(parts) = first.keep(reader.parts(item)) else {
                // Whether it lacks a surface could only be said of its parts.
                if has_surface(item) {
                    first.keep(surface(item));
                }
                continue;
            };
            let some_have_one = parts.iter().any(|part| part.surface.is_some());
            for part in parts {
                // A table without a surface is an error of this function.
                let without = if some_have_one { part.first } else { item };
                let surface = surface(part.surface.unwrap_or(without));
                if let Some(surface) = first.keep(surface) {
                    objects.push((part.geometry, surface));
                }
            }
        }
        objects
    }
}

impl Shapes {
    /// By how much the transform of a group makes lengths longer or shorter, at most.
    fn scale(self, group: &dyn Geometry) -> f64 {
        let kind = self.row(group).and_then(|row| row.get(group));
        match kind.map(ShapeKind::content) {
            Some(Content::Children {
                transform: Some(transform),
                ..
            }) => transform.scale(),
            _ => 1.0,
        }
    }
}

fn has_surface(item: &Item) -> bool {
    item.find("color").or(item.find("material")).is_some()
}

impl<'f> Reader<'f> {
    /// The geometries of a table, each with its surface if that is inside of the table.
    fn parts(&mut self, item: &'f Item) -> Result<Vec<Part<'f>>, Error> {
        let is_group = item.kind.name == "group";
        let has_steps = item.steps().next().is_some();
        if has_steps {
            // The steps stand before the shapes.
            self.shapes.read_group(item, Vec::new())?;
        }
        let mut parts = match (item.used, item.kind.name) {
            (Some(definition), _) => self.parts_of_definition(definition, item)?,
            (None, "group" | "repeat") => self.parts_of_tables(item)?,
            (None, "use") => return Err(item.lacks("name")),
            (None, _) => vec![Part {
                geometry: self.shapes.read(item)?,
                surface: None,
                first: item,
                scale: 1.0,
            }],
        };
        if is_group || has_steps {
            parts = self.grouped(item, parts)?;
        }
        for part in &mut parts {
            part.surface = part.surface.or(has_surface(item).then_some(item));
        }
        Ok(parts)
    }

    /// The parts of the shapes in a table.
    fn parts_of_tables(&mut self, item: &'f Item) -> Result<Vec<Part<'f>>, Error> {
        let mut parts = Vec::new();
        for table in item.shapes() {
            parts.extend(self.parts(table)?);
        }
        Ok(parts)
    }

    /// The parts of a definition that a table uses.
    fn parts_of_definition(
        &mut self,
        definition: usize,
        user: &'f Item,
    ) -> Result<Vec<Part<'f>>, Error> {
        if self.known[definition].is_none() {
            let item = &self.definitions[definition];
            let mut parts = self.parts_of_tables(item)?;
            if item.steps().next().is_some() {
                parts = self.grouped(item, parts)?;
            }
            let mut shared = Vec::new();
            for run in runs(parts) {
                let shapes = Shared::new(run.geometries, self.shapes);
                let surface = run.surface.or(has_surface(item).then_some(item));
                shared.push((shapes, surface, run.scale));
            }
            self.known[definition] = Some(shared);
        }
        let mut parts = Vec::new();
        for (shapes, surface, scale) in self.known[definition].iter().flatten() {
            parts.push(Part {
                geometry: Box::new(shapes.clone()),
                surface: *surface,
                first: user,
                scale: *scale,
            });
        }
        Ok(parts)
    }

    /// Nodes with the steps of a table around its parts, one for each run of equal surfaces.
    fn grouped(&self, item: &Item, parts: Vec<Part<'f>>) -> Result<Vec<Part<'f>>, Error> {
        let mut nodes = Vec::new();
        for run in runs(parts) {
            let geometry = self.shapes.read_group(item, run.geometries)?;
            let scale = run.scale * self.shapes.scale(&*geometry);
            if scale > MAX_SCALE {
                let text = "the transforms here and inside make lengths more than 1e200 times as \
                    long, or as short";
                return Err(item.error("transform", text));
            }
            nodes.push(Part {
                geometry,
                surface: run.surface,
                first: run.first,
                scale,
            });
        }
        Ok(nodes)
    }
}

/// The geometries of parts that follow each other and have the same surface.
struct Run<'f> {
    geometries: Vec<Box<dyn Geometry>>,
    surface: Option<&'f Item>,
    /// The table of the first one.
    first: &'f Item,
    /// The greatest scale of them.
    scale: f64,
}

/// The parts as runs.
fn runs<'f>(parts: Vec<Part<'f>>) -> Vec<Run<'f>> {
    let mut runs: Vec<Run<'f>> = Vec::new();
    for part in parts {
        let is_same = |run: &&mut Run| match (run.surface, part.surface) {
            (Some(last), Some(next)) => last.has_surface_of(next),
            (None, None) => true,
            _ => false,
        };
        match runs.last_mut().filter(is_same) {
            Some(run) => {
                run.geometries.push(part.geometry);
                run.scale = run.scale.max(part.scale);
            }
            None => runs.push(Run {
                geometries: vec![part.geometry],
                surface: part.surface,
                first: part.first,
                scale: part.scale,
            }),
        }
    }
    runs
}
