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
        writer.add_one_of(&CAMERAS);
        writer.add(REST);
        for _ in 0..writer.numbers.below(5) {
            writer.add_one_of(&LIGHTS);
        }
        writer.add("[define.part]\ntransform = [STEPS]\n");
        writer.add_shapes("define.part.", 1);
        writer.add_shapes("", 0);
        Self {
            scene: writer.text,
            mesh,
        }
    }

    /// The same files with each 0 negated.
    pub fn with_negative_zeros(&self) -> Self {
        let [scene, mesh] = [&self.scene, &self.mesh].map(|text| text.replace("0e0", "-0e0"));
        Self { scene, mesh }
    }
}

const CAMERAS: [&str; 3] = [
    "[camera]\neye = FAR\nlook_at = POINT\nangle = 40\n",
    "[camera]\neye = FAR\nlook_at = POINT\nscale = 4\nup = DIRECTION\n",
    "[camera]\neye = POINT\ngaze = DIRECTION\nangle = 90\n",
];

const REST: &str = "[world]\nbackground = COLOR\nambient = COLOR\n\
    [material.matt]\ndiffuse = COLOR\n\
    [material.shiny]\ndiffuse = COLOR\nspecular = COLOR\nexponent = 2.5\n\
    [material.mirror]\ndiffuse = COLOR\nspecular = COLOR\nexponent = 0e0\nreflection = COLOR\n";

const LIGHTS: [&str; 4] = [
    "[[point_light]]\ncolor = COLOR\nposition = POINT\n",
    "[[spot_light]]\ncolor = COLOR\nposition = FAR\ndirection = DIRECTION\nhalf_angle = 45\n",
    "[[directional_light]]\ncolor = COLOR\ndirection = DIRECTION\n",
    "[[directional_light]]\ncolor = COLOR\ndirection = DIRECTION\nshadows = false\n",
];

/// The tables and keys of shapes; the last four have shapes in them.
const SHAPES: [(&str, &str); 13] = [
    ("sphere", "center = POINT\nradius = 0.5\n"),
    ("plane", "point = POINT\nnormal = DIRECTION\n"),
    ("box", "lbf = POINT\nrun = POINT\n"),
    ("triangle", "corners = [POINT, POINT, POINT]\n"),
    (
        "triangle",
        "corners = [POINT, POINT, POINT]\nnormals = [DIRECTION, DIRECTION, DIRECTION]\n",
    ),
    ("disc", "center = POINT\nnormal = DIRECTION\nradius = 1\n"),
    ("mesh", "file = \"m\"\nsmooth = true\n"),
    ("mesh", "file = \"m\"\nsmooth = true\n"),
    ("mesh", "file = \"m\"\nsmooth = false\n"),
    ("use", "name = \"part\"\n"),
    ("group", ""),
    ("repeat", "count = 3\ntranslate = POINT\n"),
    ("repeat", "count = 2\nrotate = [0e0, ANGLE, 0e0]\n"),
];

const SURFACES: [&str; 4] = [
    "color = COLOR\n",
    "material = \"matt\"\n",
    "material = \"shiny\"\n",
    "material = \"mirror\"\n",
];

const STEPS: [&str; 9] = [
    "{ scale = [FACTOR, FACTOR, FACTOR] }, ",
    "{ scale = [FACTOR, FACTOR, FACTOR] }, ",
    "{ translate = POINT }, ",
    "{ rotate_x = ANGLE }, ",
    "{ rotate_y = ANGLE }, ",
    "{ rotate_z = ANGLE }, ",
    "{ rotate = [ANGLE, 0e0, ANGLE] }, ",
    "{ matrix = [[-1, 0e0, 0e0, 1], [0e0, 2, 0e0, 0e0], [0e0, 0e0, 1, 0e0]] }, ",
    "{ matrix = [[1, 0e0, 0e0, 2], [0e0, -1, 0e0, 0e0], [0e0, 0e0, 1, 0e0]], \
        inverse = [[1, 0e0, 0e0, -2], [0e0, -1, 0e0, 0e0], [0e0, 0e0, 1, 0e0]] }, ",
];

struct Writer {
    numbers: Numbers,
    text: String,
}

impl Writer {
    fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.numbers.below(values.len())]
    }

    fn add_one_of(&mut self, texts: &[&str]) {
        let text = self.one_of(texts);
        self.add(text);
    }

    /// Adds a text, in which random values stand for words in capitals.
    fn add(&mut self, text: &str) {
        let ends = [' ', ',', '[', ']', '\n'];
        for word in text.split_inclusive(ends) {
            let name = word.trim_end_matches(ends);
            let is_along_axis = self.numbers.below(2) == 0;
            let mut numbers = [(); 3].map(|()| self.number());
            let axis = self.numbers.below(3);
            match name {
                "FAR" => numbers[axis] = self.one_of(&[3.0, -3.0, 6.0]),
                "DIRECTION" => {
                    numbers = numbers.map(|x| if is_along_axis { 0.0 } else { x });
                    numbers[axis] = self.one_of(&[1.0, -1.0]);
                }
                // Half of all colours are black.
                "COLOR" => {
                    numbers = numbers.map(|x| if is_along_axis { 0.0 } else { x.abs() / 2.0 });
                }
                _ => {}
            }
            match name {
                "POINT" | "FAR" | "DIRECTION" | "COLOR" => self.text += &written(numbers),
                "ANGLE" => self.add_one_of(&["0e0", "90", "180", "30"]),
                "FACTOR" => self.add_one_of(&["1", "1", "-1", "0.5", "-2"]),
                "STEPS" => (0..axis).for_each(|_| self.add_one_of(&STEPS)),
                _ => self.text += name,
            }
            self.text += &word[name.len()..];
        }
    }

    /// Halves up to 2, and in one of eight cases any number.
    fn number(&mut self) -> f64 {
        match self.numbers.below(8) {
            0 => self.numbers.between(-2.0, 2.0),
            _ => self.numbers.below(9) as f64 / 2.0 - 2.0,
        }
    }

    /// Adds some shapes in the table of this prefix.
    fn add_shapes(&mut self, prefix: &str, level: usize) {
        for _ in 0..=self.numbers.below(6) {
            let kinds = SHAPES.len() - if level < 2 { 0 } else { 4 };
            let (mut kind, mut keys) = self.one_of(&SHAPES[..kinds]);
            if kind == "use" && prefix.starts_with("define") {
                (kind, keys) = SHAPES[0];
            }
            self.add(&format!("[[{prefix}{kind}]]\n{keys}"));
            self.add_one_of(&SURFACES);
            self.add_one_of(&["", "transform = [STEPS]\n"]);
            if ["group", "repeat"].contains(&kind) {
                self.add_shapes(&format!("{prefix}{kind}."), level + 1);
            }
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
            if self.numbers.below(5) == 0 {
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
