//! The shapes of a world as the values of their tables in a scene file.

use std::collections::HashMap;
use std::rc::Rc;

use scene_export::WrittenShape;

use super::{Content, ShapeKind, Shapes};
use crate::{Geometry, World};

/// The shapes of each definition, by the number of the shared shapes.
type Definitions = HashMap<usize, Rc<[WrittenShape]>>;

impl Shapes {
    /// The shapes of a world as the values of their tables, each with the number of its surface,
    /// from 0.
    #[must_use]
    pub fn written<S>(self, world: &World<S>) -> Vec<WrittenShape> {
        let (mut written, mut definitions) = (Vec::new(), Definitions::new());
        for (surface, (geometry, _)) in (0..).zip(world.objects()) {
            self.write(geometry, &[], surface, &mut definitions, &mut written);
        }
        written
    }

    fn write(
        self,
        geometry: &dyn Geometry,
        transforms: &[engine::Transform],
        surface: usize,
        definitions: &mut Definitions,
        written: &mut Vec<WrittenShape>,
    ) {
        let row = self.row(geometry);
        let kind = row.and_then(|row| row.get(geometry));
        let mut shape = WrittenShape {
            key: row.map(|row| row.key),
            values: Vec::new(),
            used: None,
            transforms: transforms.to_vec(),
            surface,
        };
        let shared = kind.and_then(ShapeKind::as_shared);
        if let Some(shared) = shared.filter(|shared| shared.is_worth_sharing()) {
            if !definitions.contains_key(&shared.id()) {
                let mut of_definition = Vec::new();
                for child in shared.shapes() {
                    self.write(child, &[], surface, definitions, &mut of_definition);
                }
                definitions.insert(shared.id(), of_definition.into());
            }
            shape.used = definitions.get(&shared.id()).cloned();
            return written.push(shape);
        }
        match kind.map(ShapeKind::content) {
            Some(Content::Children { shapes, transform }) => {
                shape
                    .transforms
                    .extend(transform.map(|transform| *transform));
                for child in shapes {
                    self.write(child, &shape.transforms, surface, definitions, written);
                }
            }
            Some(Content::Values(values)) => {
                shape.values = values;
                written.push(shape);
            }
            None => written.push(shape),
        }
    }
}
