//! Random scene files, with every table and key that a scene file can have. Most numbers are whole
//! or halves, so that lights and rays run along faces, and each 0 is written `0e0`.

use std::fmt::Write;

use a04_lab::support::Numbers;

/// A scene file and the mesh that it names.
pub struct Written {
    pub scene: String,
    pub mesh: String,
}

impl Written {
    /// The scene file with this number.
    pub fn new(seed: u64) -> Self {
        let mut writer = Writer {
            numbers: Numbers::new(seed, 0),
            text: String::new(),
        };
        let mesh = writer.mesh();
        writer.camera();
        writer.materials();
        writer.lights();
        writer.line("[define.part]", "");
        writer.transform(1);
        writer.shapes("define.part.", 1);
        writer.shapes("", 0);
        Self {
            scene: writer.text,
            mesh,
        }
    }

    /// The same files with each 0 negated.
    pub fn with_negative_zeros(&self) -> Self {
        let negated = |text: &str| text.replace("0e0", "-0e0");
        Self {
            scene: negated(&self.scene),
            mesh: negated(&self.mesh),
        }
    }
}

/// Names of materials, of which the last mirrors.
const MATERIALS: [&str; 3] = ["matt", "shiny", "mirror"];

/// The kinds of shapes; the last three have shapes in them.
const SHAPES: [&str; 10] = [
    "sphere", "plane", "box", "triangle", "disc", "mesh", "mesh", "group", "repeat", "use",
];

struct Writer {
    numbers: Numbers,
    text: String,
}

fn written(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers.map(|x| {
        if x == 0.0 {
            "0e0".into()
        } else {
            format!("{x:?}")
        }
    });
    format!("[{x}, {y}, {z}]")
}

impl Writer {
    fn line(&mut self, key: &str, value: impl AsRef<str>) {
        let equals = if key.starts_with('[') { "" } else { " = " };
        let _ = writeln!(self.text, "{key}{equals}{}", value.as_ref());
    }

    /// Whether one of `count` cases is this one.
    fn once_in(&mut self, count: usize) -> bool {
        self.numbers.below(count) == 0
    }

    fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.numbers.below(values.len())]
    }

    /// Halves up to 2, and in one of eight cases any number.
    fn number(&mut self) -> f64 {
        if self.once_in(8) {
            return self.numbers.between(-2.0, 2.0);
        }
        self.numbers.below(9) as f64 / 2.0 - 2.0
    }

    fn point(&mut self) -> String {
        let point = [(); 3].map(|()| self.number());
        written(point)
    }

    /// In half of all cases along an axis.
    fn direction(&mut self) -> String {
        let is_along_axis = self.once_in(2);
        let mut direction = [(); 3].map(|()| if is_along_axis { 0.0 } else { self.number() });
        direction[self.numbers.below(3)] = self.one_of(&[1.0, -1.0]);
        written(direction)
    }

    /// Black in one of four cases.
    fn color(&mut self) -> String {
        let is_black = self.once_in(4);
        let channel = |i: usize| if is_black { 0.0 } else { i as f64 / 4.0 };
        let color = [(); 3].map(|()| channel(self.numbers.below(5)));
        written(color)
    }

    fn camera(&mut self) {
        let away = self.one_of(&[3.0, 6.0]);
        let mut eye = [(); 3].map(|()| self.number());
        eye[self.numbers.below(3)] = self.one_of(&[away, -away]);
        self.line("[camera]", "");
        self.line("eye", written(eye));
        if self.once_in(4) {
            self.line("gaze", written(eye.map(|x| -x)));
        } else {
            let middle = self.point();
            self.line("look_at", middle);
        }
        let (key, size) = self.one_of(&[("angle", 40.0), ("angle", 90.0), ("scale", 4.0)]);
        self.line(key, format!("{size:?}"));
        if self.once_in(2) {
            let up = self.direction();
            self.line("up", up);
        }
        self.line("[world]", "");
        for key in ["background", "ambient"] {
            let color = self.color();
            self.line(key, color);
        }
    }

    fn materials(&mut self) {
        for (i, name) in MATERIALS.iter().enumerate() {
            self.line(&format!("[material.{name}]"), "");
            for key in &["diffuse", "specular", "reflection"][..=i] {
                let color = self.color();
                self.line(key, color);
            }
            let exponent = self.one_of(&["0e0", "1.0", "2.5", "64.0"]);
            self.line("exponent", exponent);
        }
    }

    fn lights(&mut self) {
        for _ in 0..self.numbers.below(5) {
            let kind = self.one_of(&["point", "spot", "directional"]);
            self.line(&format!("[[{kind}_light]]"), "");
            let (color, position, direction) = (self.color(), self.point(), self.direction());
            self.line("color", color);
            if kind != "directional" {
                self.line("position", position);
            }
            if kind != "point" {
                self.line("direction", direction);
            }
            if kind == "spot" {
                self.line("half_angle", "45.0");
            }
            if self.once_in(4) {
                self.line("shadows", "false");
            }
        }
    }

    /// Some shapes in the table of this prefix.
    fn shapes(&mut self, prefix: &str, level: usize) {
        for _ in 0..=self.numbers.below(6) {
            let kinds = if level < 2 { 10 } else { 7 };
            let kind = self.one_of(&SHAPES[..kinds]);
            let is_recursive = kind == "use" && prefix.starts_with("define");
            self.shape(prefix, if is_recursive { "mesh" } else { kind }, level);
        }
    }

    fn shape(&mut self, prefix: &str, kind: &str, level: usize) {
        self.line(&format!("[[{prefix}{kind}]]"), "");
        let radius = format!("{:?}", self.one_of(&[0.25, 0.5, 1.0]));
        let points = [(); 3].map(|()| self.point());
        let directions = [(); 3].map(|()| self.direction());
        let some = self.once_in(2);
        let mut keys = match kind {
            "sphere" => vec![("center", points[0].clone()), ("radius", radius)],
            "plane" => vec![
                ("point", points[0].clone()),
                ("normal", directions[0].clone()),
            ],
            "box" => vec![("lbf", points[0].clone()), ("run", points[1].clone())],
            "triangle" => vec![("corners", format!("[{}]", points.join(", ")))],
            "disc" => vec![
                ("center", points[0].clone()),
                ("normal", directions[0].clone()),
                ("radius", radius),
            ],
            "mesh" => vec![
                ("file", "\"m\"".into()),
                ("smooth", (!self.once_in(4)).to_string()),
            ],
            "repeat" => vec![("count", "3".into())],
            "use" => vec![("name", "\"part\"".into())],
            _ => vec![],
        };
        match kind {
            "triangle" if some => keys.push(("normals", format!("[{}]", directions.join(", ")))),
            "repeat" if some => keys.push(("rotate", "[0e0, 90.0, 0e0]".into())),
            "repeat" => keys.push(("translate", points[0].clone())),
            _ => {}
        }
        let surface = if self.once_in(5) {
            ("color", self.color())
        } else {
            ("material", format!("\"{}\"", self.one_of(&MATERIALS)))
        };
        keys.push(surface);
        for (key, value) in keys {
            self.line(key, value);
        }
        self.transform(2);
        if ["group", "repeat"].contains(&kind) {
            self.shapes(&format!("{prefix}{kind}."), level + 1);
        }
    }

    /// Up to three steps, in one of `cases`.
    fn transform(&mut self, cases: usize) {
        if !self.once_in(cases) {
            return;
        }
        let steps: Vec<_> = (0..self.numbers.below(4)).map(|_| self.step()).collect();
        self.line("transform", format!("[{}]", steps.join(", ")));
    }

    /// Mirrors, moves, turns by quarters, and leaves as they are.
    fn step(&mut self) -> String {
        let factors = [(); 3].map(|()| self.one_of(&[1.0, 1.0, -1.0, 0.5, -2.0]));
        let (to, angle) = (self.point(), self.one_of(&["0e0", "90.0", "180.0", "30.0"]));
        match self.numbers.below(8) {
            0 => format!("{{ translate = {to} }}"),
            1 => format!("{{ rotate = [{angle}, 0e0, 90.0] }}"),
            2 => {
                let axis = self.one_of(&["x", "y", "z"]);
                format!("{{ rotate_{axis} = {angle} }}")
            }
            3 => {
                let [x, y, z] = factors;
                let matrix = |[x, y, z]: [f64; 3], t: f64| {
                    format!(
                        "[[{x:?}, 0e0, 0e0, {t:?}], [0e0, {y:?}, 0e0, 0e0], [0e0, 0e0, {z:?}, 0e0]]"
                    )
                };
                let (forth, back) = (
                    matrix(factors, 1.0),
                    matrix([1.0 / x, 1.0 / y, 1.0 / z], -1.0 / x),
                );
                if self.once_in(2) {
                    format!("{{ matrix = {forth}, inverse = {back} }}")
                } else {
                    format!("{{ matrix = {forth} }}")
                }
            }
            _ => format!("{{ scale = {} }}", written(factors)),
        }
    }

    /// An OBJ file: five by five points in a plane across an axis, some of them above or below it.
    /// Light along the plane shines on smooth faces beside these points.
    fn mesh(&mut self) -> String {
        let (axis, mut obj) = (self.numbers.below(3), String::new());
        for i in 0..25 {
            let mut at = [
                f64::from(i % 5) / 2.0 - 1.0,
                f64::from(i / 5) / 2.0 - 1.0,
                0.0,
            ];
            if self.once_in(5) {
                at[2] = self.number() / 4.0;
            }
            at.rotate_right(axis);
            let point = written(at).replace(['[', ']', ','], "");
            let _ = writeln!(obj, "v {point}");
        }
        for [row, column] in (0..16).map(|cell| [cell / 4, cell % 4]) {
            let [a, b] = [5 * row + column + 1, 5 * row + column + 6];
            let _ = writeln!(obj, "f {a} {} {b}\nf {b} {} {}", a + 1, a + 1, b + 1);
        }
        obj
    }
}
