//! Writes a scene, in the numbers of the engine and of the rows of its types, as TOML and for POV-Ray. The reader
//! of scene files knows no engine, and the engine no scene file.

mod phrases;
mod shape;
mod words;

use std::collections::HashMap;
use std::rc::Rc;

use common::{Color, Settings};
use engine::{Camera, Scene, Transform};
use glam::DVec3;

pub use phrases::{POV_RAY, Phrases, TOML};

/// The values of a table, by its keys.
pub type Values = Vec<(&'static str, Vec<f64>)>;

/// A shape as the values of its table.
#[derive(Clone, Debug)]
pub struct WrittenShape {
    /// The name of its table; none if its type has none.
    pub key: Option<&'static str>,
    /// The values, by the keys of the table.
    pub values: Values,
    /// The shapes of the definition that is used here, instead of values. Uses of the same one hold
    /// the same allocation.
    pub used: Option<Rc<[Self]>>,
    /// The transforms above it, from the outermost to the innermost.
    pub transforms: Vec<Transform>,
    /// The number of its surface, from 0.
    pub surface: usize,
}

/// A light as the values of its table.
#[derive(Clone, Debug)]
pub struct WrittenLight {
    /// The name of its table; none if its type has none.
    pub key: Option<&'static str>,
    /// The values, by the keys of the table.
    pub values: Values,
}

/// Writes a scene in a language: with these shapes, the values of the materials of its surfaces, and
/// these lights. A material whose type has no table has no values. The error is a part that the language
/// has no phrase for.
pub fn export(
    language: Phrases,
    scene: &Scene,
    shapes: &[WrittenShape],
    materials: &[Option<Values>],
    lights: &[WrittenLight],
    camera: &Camera,
    settings: &Settings,
) -> Result<String, String> {
    let mut text = head(language, scene, camera, settings)?;
    // A language without words for a light that casts no shadow may have words for shapes.
    let no_shadow = if scene.lights.iter().any(|light| light.casts_shadows) {
        String::new()
    } else {
        language.word("no shadow")
    };
    // Surfaces with the same phrase share a material.
    let (mut names, mut uses) = (HashMap::new(), Vec::new());
    for values in materials {
        let [material, used] = material(language, values.as_ref(), scene.ambient)?;
        let name = format!("m{}", names.len());
        let name = names.entry(material).or_insert_with_key(|material| {
            text += &material.replace("[name]", &name);
            name
        });
        let used = used.replace("[name]", name);
        uses.push(used.replace("[no_shadow]", &no_shadow));
    }
    for (source, light) in scene.lights.iter().zip(lights) {
        let shadows = if source.casts_shadows || !no_shadow.is_empty() {
            String::new()
        } else {
            language.find("light without shadows", "", &[])?
        };
        let words = match light.key {
            Some(key) => words::of_table(language, "any light", key, &light.values)?,
            None => language.find("light by formula", "", &[])?,
        };
        text += &words.replace("[shadows]", &shadows);
    }
    let definitions = Definitions::of(shapes);
    for (number, definition) in definitions.0.iter().enumerate() {
        let name = format!("d{number}");
        let begin = language.find("definition", "", &[])?;
        text += &begin.replace("[name]", &name);
        let prefix = language
            .word("prefix in definition")
            .replace("[name]", &name);
        add_shapes(
            &mut text,
            language,
            definition,
            &definitions,
            &prefix,
            |_| "",
        )?;
        text += &language.word("end of definition");
    }
    let used = |shape: &WrittenShape| &*uses[shape.surface];
    add_shapes(&mut text, language, shapes, &definitions, "", used)?;
    Ok(text + &language.word("end"))
}

/// The definitions of a scene, each behind those that it uses.
struct Definitions(Vec<Rc<[WrittenShape]>>);

impl Definitions {
    fn of(shapes: &[WrittenShape]) -> Self {
        let mut definitions = Self(Vec::new());
        definitions.add_used(shapes);
        definitions
    }

    fn add_used(&mut self, shapes: &[WrittenShape]) {
        for definition in shapes.iter().filter_map(|shape| shape.used.as_ref()) {
            if self.number(definition).is_none() {
                self.add_used(definition);
                self.0.push(Rc::clone(definition));
            }
        }
    }

    fn number(&self, definition: &Rc<[WrittenShape]>) -> Option<usize> {
        self.0
            .iter()
            .position(|known| Rc::ptr_eq(known, definition))
    }
}

/// Adds shapes, behind a prefix of their tables, with the words for the use of their materials.
fn add_shapes<'u>(
    text: &mut String,
    language: Phrases,
    shapes: &[WrittenShape],
    definitions: &Definitions,
    prefix: &str,
    used: impl Fn(&WrittenShape) -> &'u str,
) -> Result<(), String> {
    let (begin, end) = (language.word("mesh"), language.word("end of mesh"));
    for shape in shapes {
        let used = used(shape);
        let definition = shape.used.as_ref();
        let name = definition.and_then(|definition| definitions.number(definition));
        let name = name.map(|number| format!("d{number}"));
        let words = shape::text(language, shape, name.as_deref(), prefix, used)?;
        // Triangles of one material become one mesh.
        let end = end.replace("[use]", used);
        let is_more = !begin.is_empty() && text.ends_with(&end) && words.ends_with(&end);
        let triangle = words.strip_prefix(&begin).filter(|_| is_more);
        text.truncate(text.len() - triangle.map_or(0, |_| end.len()));
        *text += triangle.unwrap_or(&words);
    }
    Ok(())
}

/// Writes a camera in a language, for a picture of the size of these settings.
pub fn write_camera(
    language: Phrases,
    camera: &Camera,
    settings: &Settings,
) -> Result<String, String> {
    let [width, height] = [settings.size.width(), settings.size.height()].map(f64::from);
    let (kind, basis, half) = match camera {
        Camera::Perspective {
            basis,
            half_tangent,
        } => ("perspective", basis, *half_tangent),
        Camera::Orthographic { basis, scale } => ("orthographic", basis, *scale),
        Camera::Other(_) => return language.find("camera by formula", "", &[]),
    };
    let angle = exact_angle(2.0 * libm::atan(half), |angle| {
        libm::tan(angle / 2.0) == half
    });
    // The sides of Tachyon's pictures are half a pixel beside ours.
    let (right, step) = (half * width / height, half / height);
    let frustum = [right + step, step - right, -half - step, half - step];
    // The y axis, which is shorter, if the camera is held upright.
    let is_upright = basis.u.y == 0.0 && basis.v.y > 0.0;
    let up = if is_upright { DVec3::Y } else { basis.v };
    let [e, up, u, v, w] = [basis.e, up, basis.u, basis.v, -basis.w].map(|v| v.to_array());
    let (gaze, angle, focus, scale) = (short(-basis.w), [angle], [0.5 / half], [half]);
    let names = "eye gaze up right upwards ahead angle focus scale frustum";
    let values: [&[f64]; 10] = [&e, &gaze, &up, &u, &v, &w, &angle, &focus, &scale, &frustum];
    language.find(kind, names, &values)
}

/// The picture, the camera, the background and the ambient light.
fn head(
    language: Phrases,
    scene: &Scene,
    camera: &Camera,
    settings: &Settings,
) -> Result<String, String> {
    let [width, height] = [settings.size.width(), settings.size.height()].map(f64::from);
    let (samples, depth) = (f64::from(settings.samples), f64::from(settings.depth));
    let size = [&[width][..], &[height], &[depth]];
    let mut text = language.find("start", "width height depth", &size)?;
    let default = Settings::default();
    text += &unless(default.samples.into(), language, "samples", &[samples]);
    text += &unless(default.depth.into(), language, "depth", &[depth]);
    text += &write_camera(language, camera, settings)?;
    text += &unless(0.0, language, "background", &scene.background.channels());
    text += &unless(0.0, language, "ambient", &scene.ambient.channels());
    Ok(text)
}

/// The phrase of numbers, unless all of them are the default.
fn unless(default: f64, language: Phrases, phrase: &str, numbers: &[f64]) -> String {
    let is_default = numbers.iter().all(|number| *number == default);
    let words = language.find(phrase, "value", &[numbers]);
    words.ok().filter(|_| !is_default).unwrap_or_default()
}

/// A material and its use by a shape.
fn material(
    language: Phrases,
    values: Option<&Values>,
    ambient: Color,
) -> Result<[String; 2], String> {
    let Some(values) = values else {
        let words = language.find("material by formula", "", &[])?;
        return Ok([words, String::new()]);
    };
    let color = words::value(values, "color");
    if !color.is_empty() {
        let words = language.find("color", "color", &[color])?;
        return Ok([words, language.find("use color", "color", &[color])?]);
    }
    let used = language.find("use material", "", &[])?;
    if let Ok(any) = language.find("any material", "", &[]) {
        let lines = words::lines("material", values);
        return Ok([any.replace("[values]", &lines), used]);
    }
    let specular = words::value(values, "specular");
    let is_gray = specular.iter().all(|channel| *channel == specular[0]);
    if !is_gray {
        return Ok([language.find("colored highlight", "", &[])?, used]);
    }
    let ambient = ambient.channels();
    let (mut keys, mut numbers) = (Vec::new(), Vec::new());
    for (key, list) in values {
        keys.push(*key);
        numbers.push(&**list);
    }
    // Words for a material have a place for its reflection, which only a mirror has.
    let names = keys.join(" ") + " ambient reflection";
    numbers.extend([&ambient[..], &[0.0; 3]]);
    keys.retain(|key| *key != "reflection");
    let phrase = format!("material with {}", keys.join(", "));
    Ok([language.find(&phrase, &names, &numbers)?, used])
}

/// A direction with a largest coordinate of 1, which often makes all of them short.
fn short(direction: DVec3) -> [f64; 3] {
    (direction / direction.abs().max_element()).to_array()
}

/// The angle in degrees, next to another in radians, for which a function has exactly a value;
/// if there is none, the other.
pub fn exact_angle(near: f64, is_exact: impl Fn(f64) -> bool) -> f64 {
    let near = near.to_degrees();
    let short = (near * 1e6).round() / 1e6;
    let away = |ulps| f64::from_bits(near.to_bits().saturating_add_signed(ulps));
    let neighbours = (0..=16).flat_map(|ulps| [away(ulps), away(-ulps)]);
    let mut candidates = std::iter::once(short).chain(neighbours);
    let exact = candidates.find(|angle| is_exact(angle.to_radians()));
    exact.unwrap_or(near)
}
