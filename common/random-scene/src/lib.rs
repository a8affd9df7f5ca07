//! Random scene files, made of the list of all tables and keys: a new shape, light or key is in them by its row
//! there.

mod meshes;
mod numbers;

use std::collections::BTreeMap;
use std::fmt::Write;

use common::sensitivity::Unit;
use scene_file::{Form, KINDS, Key, Kind, Mesh, Missing, Notation};

pub use meshes::MESHES;
use meshes::mesh;
pub use numbers::{Below, Numbers, Style};

/// The names of materials.
const MATERIALS: [&str; 3] = ["a", "b", "c"];

/// The tables in which shapes stand.
const GROUPS: [&str; 2] = ["group", "repeat"];

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
        let mut writer = Writer {
            numbers: Numbers::new(below, style),
            stage,
            accepts,
            head: String::new(),
            text: String::new(),
            meshes: BTreeMap::new(),
        };
        writer.add_all();
        Self {
            scene: writer.head + &writer.text,
            meshes: writer.meshes,
        }
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

struct Writer<'a> {
    numbers: Numbers<'a>,
    stage: u8,
    accepts: &'a dyn Fn(&SceneText) -> bool,
    /// What tables need beside them: the camera, the materials and the definitions, without their shapes.
    head: String,
    /// All other tables.
    text: String,
    meshes: BTreeMap<&'static str, String>,
}

impl Writer<'_> {
    fn add_all(&mut self) {
        for _ in 0..8 {
            let camera = format!("[camera]\n{}", self.keys(kind("camera")));
            if self.head.is_empty() && self.is_accepted(&camera) {
                self.head = camera;
            }
        }
        if self.head.is_empty() {
            let eye = self.numbers.at([3.0, 4.0, 7.0]);
            let at = self.numbers.at([0.0; 3]);
            self.head = format!("[camera]\neye = {eye:?}\nlook_at = {at:?}\nangle = 35\n");
        }
        let world = format!("[world]\n{}", self.keys(kind("world")));
        let materials = MATERIALS.map(|name| {
            let keys = self.keys(kind("material"));
            format!("[material.{name}]\n{keys}")
        });
        for table in [world].iter().chain(&materials) {
            if self.is_accepted(table) {
                self.head += table;
            }
        }
        let lights = KINDS.iter().filter(|kind| kind.is_light());
        let lights: Vec<_> = lights.collect();
        for _ in 0..self.numbers.below(5) {
            let light = self.numbers.one_of(&lights);
            let light = format!("[[{}]]\n{}", light.name, self.keys(light));
            self.add(&light, &light);
        }
        for name in ["part", "whole"] {
            let keys = self.keys(kind("define")) + &self.surface();
            let table = format!("[define.{name}]\n{keys}");
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
        let kinds = KINDS.iter().filter(is_shape);
        let kinds: Vec<_> = kinds
            .filter(|kind| kind.keys[0].stage <= self.stage)
            .collect();
        for _ in 0..count {
            let kind = self.numbers.one_of(&kinds);
            let has_shapes = GROUPS.contains(&kind.name);
            let is_in_itself = kind.name == "use" && prefix.starts_with("define.part");
            if is_in_itself || has_shapes && level > 1 {
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

    /// Random values for the keys of a table, but not for the surface of a shape.
    fn keys(&mut self, kind: &Kind) -> String {
        let (mut text, is_other) = (String::new(), self.numbers.below(2) == 0);
        let stage = self.stage;
        for key in kind.keys.iter().filter(|key| key.stage <= stage) {
            let is_there = match key.missing {
                Missing::NeededOr("material") | Missing::InsteadOf("color") => false,
                Missing::Needed | Missing::NeededWith(_) => true,
                Missing::NeededOr(_) => !is_other,
                Missing::InsteadOf(_) => is_other,
                // Tables in a table have no meaning of their own.
                Missing::Optional => !key.about.is_empty() && self.numbers.below(3) > 0,
            };
            if is_there {
                let value = self.value(key);
                let _ = writeln!(text, "{} = {value}", key.name);
            }
        }
        text
    }

    fn value(&mut self, key: &Key) -> String {
        match &key.form {
            Form::Color => self.color(),
            Form::Flag => self.numbers.one_of(&["true", "false"]).to_owned(),
            Form::Text if key.name == "file" => {
                let name = self.numbers.one_of(&MESHES);
                let numbers = &mut self.numbers;
                self.meshes
                    .entry(name)
                    .or_insert_with(|| mesh(name, numbers));
                format!("{name:?}")
            }
            Form::Text => format!("{:?}", self.numbers.one_of(&["part", "whole"])),
            Form::Tables(_) => {
                let steps: Vec<_> = (0..self.numbers.below(3)).map(|_| self.step()).collect();
                format!("[{}]", steps.join(", "))
            }
            Form::Numbers { lengths, .. } => match lengths[..] {
                [] => self.numbers_of(key, 1).trim_matches(['[', ']']).to_owned(),
                [count] => self.numbers_of(key, count),
                [rows, columns, ..] => {
                    let rows: Vec<_> = (0..rows).map(|_| self.numbers_of(key, columns)).collect();
                    format!("[{}]", rows.join(", "))
                }
            },
        }
    }

    /// A list of numbers of the unit of a key, and mostly in its range.
    fn numbers_of(&mut self, key: &Key, count: usize) -> String {
        let numbers = &mut self.numbers;
        let in_range = |numbers: &mut Numbers, values: &[f64]| {
            let values: Vec<_> = values
                .iter()
                .copied()
                .filter(|x| key.range.contains(*x))
                .collect();
            (0..count).map(|_| numbers.one_of(&values)).collect()
        };
        let mut values: Vec<f64> = match key.unit {
            Some(Unit::Direction(_)) => numbers.direction().to_vec(),
            Some(Unit::Length) if count == 3 => {
                let mut point = numbers.point();
                // Where it sees most of the scene.
                if key.name == "eye" && numbers.below(3) > 0 {
                    point[numbers.below(3)] += numbers.unit * numbers.one_of(&[3.0, -3.0, 6.0]);
                }
                point.to_vec()
            }
            Some(Unit::Length) => vec![numbers.unit * numbers.one_of(&[0.25, 0.5, 1.0, 0.7])],
            Some(Unit::Degree) => in_range(numbers, &[0.0, 90.0, 180.0, 30.0, 40.0, 3.0]),
            Some(Unit::Scale) => in_range(numbers, &[1.0, 1.0, 1.0, -1.0, 0.5, -2.0, 1e-9]),
            Some(Unit::Whole) => in_range(numbers, &[1.0, 2.0, 3.0]),
            _ => in_range(numbers, &[0.0, 1.0, 2.5, 64.0, 1024.0]),
        };
        if numbers.style == Style::Any && numbers.below(4) == 0 {
            values[0] = numbers.any();
        }
        if key.form.is_whole() {
            return format!("[{}]", values[0]);
        }
        list(&values)
    }

    /// Black in one of three cases.
    fn color(&mut self) -> String {
        let is_black = self.numbers.below(3) == 0;
        let channels = [(); 3].map(|()| {
            if is_black {
                0.0
            } else {
                self.numbers.below(9) as f64 / 8.0
            }
        });
        list(&channels)
    }

    /// A step of a transform.
    fn step(&mut self) -> String {
        let steps = &kind("step").keys;
        let key = &steps[self.numbers.below(steps.len())];
        match key.name {
            "matrix" => "{ matrix = [[-1, 0e0, 0e0, 1], [0e0, 2, 0e0, 0e0], [0e0, 0e0, 1, 0e0]] }"
                .to_owned(),
            "inverse" => "{ matrix = [[1, 0e0, 0e0, 2], [0e0, -1, 0e0, 0e0], [0e0, 0e0, 1, 0e0]], \
                inverse = [[1, 0e0, 0e0, -2], [0e0, -1, 0e0, 0e0], [0e0, 0e0, 1, 0e0]] }"
                .to_owned(),
            name => format!("{{ {name} = {} }}", self.value(key)),
        }
    }
}

/// The kind of tables of this name.
fn kind(name: &str) -> &'static Kind {
    let mut kinds = KINDS.iter();
    kinds.find(|kind| kind.name == name).expect(name)
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
