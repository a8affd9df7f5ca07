//! `Writer`: writes the tables of a random scene file, each by the row of its kind.

mod values;

use std::collections::BTreeMap;

use scene_file::{Kind, Notation, TABLES};

use crate::numbers::{Below, Numbers, Style};
use crate::{SceneText, list};

/// The names of materials.
const MATERIALS: [&str; 3] = ["a", "b", "c"];

/// A mirror for corridors.
const MIRROR: &str = "[material.mirror]\nreflection = [0.875, 1, 0.5]\n";

/// The tables in which shapes stand.
const GROUPS: [&str; 2] = ["group", "repeat"];

/// Adds table after table to a scene.
pub struct Writer<'a> {
    numbers: Numbers<'a>,
    stage: u8,
    accepts: &'a dyn Fn(&SceneText) -> bool,
    /// The first tables: the camera, the materials and the definitions, without their shapes.
    head: String,
    /// All other tables.
    text: String,
    meshes: BTreeMap<&'static str, String>,
}

impl<'a> Writer<'a> {
    /// An empty scene of a style, for a stage. Tables that `accepts` refuses are left out.
    pub fn new(
        below: Below<'a>,
        style: Style,
        stage: u8,
        accepts: &'a dyn Fn(&SceneText) -> bool,
    ) -> Self {
        Self {
            numbers: Numbers::new(below, style),
            stage,
            accepts,
            head: String::new(),
            text: String::new(),
            meshes: BTreeMap::new(),
        }
    }

    /// Adds tables of all kinds, and returns the scene.
    pub fn scene(mut self) -> SceneText {
        self.add_all();
        SceneText {
            scene: self.head + &self.text,
            meshes: self.meshes,
        }
    }

    /// A table of this name, without the surface of a shape.
    pub fn table(&mut self, name: &str) -> String {
        let kind = kind(name);
        format!("{}\n{}", kind.header, self.keys(kind))
    }

    fn add_all(&mut self) {
        for _ in 0..8 {
            let camera = self.table("camera");
            if self.head.is_empty() && self.is_accepted(&camera) {
                self.head = camera;
            }
        }
        if self.head.is_empty() {
            let eye = self.numbers.at([3.0, 4.0, 7.0]);
            let at = self.numbers.at([0.0; 3]);
            self.head = format!("[camera]\neye = {eye:?}\nlook_at = {at:?}\nangle = 35\n");
        }
        let world = self.table("world");
        let materials = MATERIALS.map(|name| self.table("material").replace("NAME", name));
        let picture = self.table("picture");
        for table in [picture, world, MIRROR.to_owned()].iter().chain(&materials) {
            if self.is_accepted(table) {
                self.head += table;
            }
        }
        let lights = TABLES.iter().filter(|kind| kind.is_light());
        let lights: Vec<_> = lights.collect();
        for _ in 0..self.numbers.one_of(&[0, 1, 2, 3, 9]) {
            let light = self.numbers.one_of(&lights);
            let light = self.table(light.name);
            // Some stand there twice.
            for _ in 0..=usize::from(self.numbers.below(8) == 0) {
                self.add(&light, &light);
            }
        }
        if self.numbers.below(6) == 0 {
            self.add_corridor();
        }
        for name in ["part", "whole"] {
            let table = self.table("define").replace("NAME", name) + &self.surface();
            if self.is_accepted(&table) {
                self.head += &table;
                self.add_shapes(&format!("define.{name}."), 4, 1);
            }
        }
        let (walls, single) = self.numbers.one_of(&[
            (0, 1),
            (0, 6),
            (1, 6),
            (1, 10),
            (3, 10),
            (4, 6),
            (6, 0),
            (2, 40),
        ]);
        for _ in 0..walls {
            self.add_wall();
        }
        self.add_shapes("", single, 0);
        // The others are small beside the whole, so that the engine bundles rays that meet several of them.
        if self.numbers.below(4) > 0 {
            let far = self.numbers.signed(50.0);
            let sphere = format!(
                "[[sphere]]\ncenter = {}\nradius = {:?}\ncolor = [1, 1, 0]\n",
                list(&self.numbers.at([far; 3])),
                self.numbers.unit
            );
            self.add(&sphere, &sphere);
        }
    }

    /// Whether a table is accepted beside the head.
    fn is_accepted(&self, table: &str) -> bool {
        let text = SceneText {
            scene: format!("{}{table}", self.head),
            meshes: self.meshes.clone(),
        };
        (self.accepts)(&text)
    }

    /// Adds a table in which nothing depends on others, if it is accepted alone.
    fn add(&mut self, table: &str, alone: &str) -> bool {
        let is_accepted = self.is_accepted(alone);
        if is_accepted {
            self.text += table;
        }
        is_accepted
    }

    /// Two mirrors that face each other: between them a ray ends by the depth alone.
    fn add_corridor(&mut self) {
        let (axis, distance) = (self.numbers.below(3), self.numbers.one_of(&[2.5, 9.0]));
        for side in [-distance, distance] {
            let (mut at, mut normal) = ([0.0; 3], [0.0; 3]);
            (at[axis], normal[axis]) = (side, -side);
            let plane = format!(
                "[[plane]]\npoint = {}\nnormal = {}\nmaterial = \"mirror\"\n",
                list(&self.numbers.at(at)),
                list(&normal)
            );
            self.add(&plane, &plane);
        }
    }

    /// Shapes side by side, with gaps, across an axis: rays along this axis that it mirrors stay neighbours, and others
    /// go on to the wall behind it.
    fn add_wall(&mut self) {
        let (middle, axis) = (self.numbers.middle, self.numbers.below(3));
        let depth = self.numbers.number();
        for cell in 0..16_u32 {
            let mut at = [depth, f64::from(cell / 4) - 1.5, f64::from(cell % 4) - 1.5];
            at.rotate_right(axis);
            self.numbers.middle = self.numbers.at(at);
            self.numbers.reach = [0.25; 3];
            self.numbers.reach[axis] = [0.0, 0.125][self.numbers.below(2)];
            self.add_shapes("", 1, 0);
            (self.numbers.middle, self.numbers.reach) = (middle, [1.0; 3]);
        }
    }

    /// Adds shapes in the table of this prefix, inside of so many other tables.
    fn add_shapes(&mut self, prefix: &str, count: usize, level: usize) {
        let is_shape = |kind: &&Kind| kind.notation == Notation::Many && !kind.is_light();
        let kinds = TABLES.iter().filter(is_shape);
        let kinds: Vec<_> = kinds
            .filter(|kind| kind.keys[0].stage <= self.stage)
            .collect();
        for _ in 0..count {
            let kind = self.numbers.one_of(&kinds);
            let has_shapes = GROUPS.contains(&kind.name);
            let is_in_itself = kind.name == "use" && prefix.starts_with("define.part");
            if is_in_itself || has_shapes && level > 2 {
                continue;
            }
            let mut keys = self.keys(kind);
            if prefix.starts_with("define") {
                keys = keys.replace("\"whole\"", "\"part\"");
            }
            // Two shapes at the same place have surfaces of their own.
            for _ in 0..=usize::from(!has_shapes && self.numbers.below(8) == 0) {
                let surface = if level == 0 || has_shapes || self.numbers.below(2) == 0 {
                    self.surface()
                } else {
                    String::new()
                };
                let table = format!("[[{prefix}{}]]\n{keys}{surface}", kind.name);
                let own = if surface.is_empty() {
                    "color = [1, 1, 1]\n"
                } else {
                    &surface
                };
                let alone = format!("[[{}]]\n{keys}{own}", kind.name);
                if self.add(&table, &alone) && has_shapes {
                    let count = 1 + self.numbers.below(3);
                    self.add_shapes(&format!("{prefix}{}.", kind.name), count, level + 1);
                }
            }
        }
    }

    fn surface(&mut self) -> String {
        if self.stage < 5 || self.numbers.below(4) == 0 {
            return format!("color = {}\n", self.color());
        }
        format!("material = {:?}\n", self.numbers.one_of(&MATERIALS))
    }
}

/// The kind of tables of this name.
pub fn kind(name: &str) -> &'static Kind {
    let mut kinds = TABLES.iter();
    kinds.find(|kind| kind.name == name).expect(name)
}
