//! The rows of shapes, lights and materials, and the tables of scene files.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use a02_math::{Point3, Vector3};
use a05_lighting::registry::{ALL_MATERIALS as LIT_MATERIALS, LIGHTS};
use a06_shadows_reflection::registry::ALL_MATERIALS;
use a07_transforms::registry::ALL_SHAPES;
use common::Color;
use scene_file::{Data, Form, Item, Key, Notation, SceneFile, TABLES};
use testing::Random;

use crate::scene_cases::{open, picture};

/// The names of tables that are listed in the file, and not once. A repeat is no shape: its copies
/// are uses.
fn listed(is_light: bool) -> BTreeSet<&'static str> {
    let tables = TABLES.iter().filter(|kind| kind.notation == Notation::Many);
    tables
        .filter(|kind| kind.name != "repeat" && kind.is_light() == is_light)
        .map(|kind| kind.name)
        .collect()
}

#[test]
fn each_row_of_shapes_has_a_table_and_each_table_a_row() {
    let mut tables = listed(false);
    for row in ALL_SHAPES.rows() {
        let is_listed = tables.remove(row.key);
        assert!(is_listed, "keys.md lacks {}, or it has two rows", row.key);
    }
    assert!(tables.is_empty(), "{tables:?} have no row");
}

#[test]
fn each_table_of_lights_has_a_row() {
    let rows: BTreeSet<_> = LIGHTS.0.iter().map(|row| row.key).collect();
    assert_eq!(rows, listed(true), "keys.md and LIGHTS list other lights");
    for kind in TABLES.iter().filter(|kind| kind.is_light()) {
        let has_shadows = kind.keys.iter().any(|key| key.name == "shadows");
        assert!(has_shadows, "keys.md lacks `shadows` of {}", kind.name);
    }
}

/// Far away and next to the lamp: points lie on lines through the vectors of the light's table, in their
/// directions, so that some are around its place, and on the axis of its beam.
#[test]
fn no_light_is_brighter_than_its_bound_for_the_engine() {
    for row in LIGHTS.0 {
        let mut lit = 0;
        for seed in 0..40 {
            let text = table(row.key, seed);
            let file = SceneFile::read(&text, 7, &|_| unreachable!()).unwrap();
            let Ok(light) = LIGHTS.read(&file.lights[0]) else {
                continue;
            };
            let bound = engine::Light {
                kind: LIGHTS.for_engine(&*light),
                casts_shadows: true,
            };
            let bound = bound.max_radiance().channels();
            for point in points(&file.lights[0]) {
                let Some(light) = light.illumination(point) else {
                    continue;
                };
                lit += 1;
                let channels = light.color.channels();
                let is_below = (0..3).all(|i| channels[i] <= bound[i]);
                assert!(
                    is_below,
                    "{channels:?} at {point:?}, above {bound:?}:\n{text}"
                );
            }
        }
        assert!(lit >= 100, "{}: {lit} points are lit", row.key);
    }
}

/// A table with random values of its keys.
fn table(name: &str, seed: u64) -> String {
    let mut random = Random::new(seed);
    random_scene::table(name, &mut |end| random.below(end), 7)
}

/// With shadows and without, on a ball in a room: lights outside of it shine through walls that cast no shadows.
#[test]
fn a_light_of_each_row_is_drawn_by_all_renderers_and_exported() {
    for row in LIGHTS.0 {
        let mut seen = 0;
        let lights = (0..200).map(|seed| table(row.key, seed));
        for light in lights.filter(|light| light.contains("shadows = true")) {
            let without_shadows = light.replace("shadows = true", "shadows = false");
            let pictures = [light, without_shadows].map(|light| {
                let text = format!(
                    "[camera]\neye = [2.5, 2.5, 2.5]\nlook_at = [0, 0, 0]\nangle = 80\n\
                    [material.white]\ndiffuse = [1, 1, 1]\n{light}\
                    [[sphere]]\nmaterial = \"white\"\ncenter = [0, 0, 0]\nradius = 0.8\n\
                    [[box]]\nmaterial = \"white\"\nlbf = [-3, -3, -3]\nrun = [3, 3, 3]\n"
                );
                // A direction may be no numbers but 0.
                open(&text).is_ok().then(|| picture(&text, [16, 12]))
            });
            seen += u32::from(pictures[0] != pictures[1]);
        }
        assert!(seen >= 5, "{}: {seen} shadows are seen", row.key);
    }
}

/// Each key of a material's table, which is not black, is in the values of the material that is read: by
/// the stages of which it is known, no key is left out.
#[test]
fn no_key_of_a_material_is_left_out_by_the_stages_that_know_it() {
    for (stage, rows) in [(5, LIT_MATERIALS), (6, ALL_MATERIALS)] {
        let mut seen = BTreeMap::new();
        for seed in 0..200 {
            let mut random = Random::new(seed);
            let camera = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nangle = 40\n".to_owned();
            let text =
                camera + &random_scene::table("material", &mut |end| random.below(end), stage);
            let file = SceneFile::read(&text, stage, &|_| unreachable!()).unwrap();
            assert_eq!(file.mistake, None, "{text}");
            let item = &file.materials[0];
            let material = rows.read(item).unwrap();
            let written = rows.written(&*material).unwrap();
            for (key, _, value) in &item.values {
                let Data::Numbers(numbers) = value else {
                    continue;
                };
                let is_without_highlight =
                    *key == "exponent" && item.color("specular") == Color::BLACK;
                if numbers.iter().all(|number| *number == 0.0) || is_without_highlight {
                    continue;
                }
                let is_written = written.contains(&(*key, numbers.clone()));
                assert!(
                    is_written,
                    "stage {stage} leaves out {key}: `read` and `content` lack it, or a key here is not \
                    \"instead of\" it in keys.md:\n{text}"
                );
                *seen.entry(*key).or_insert(0) += 1;
            }
        }
        let kind = TABLES.iter().find(|kind| kind.name == "material");
        let keys = kind.iter().flat_map(|kind| &kind.keys);
        for key in keys.filter(|key| key.stage <= stage) {
            let times = seen.get(key.name).copied().unwrap_or(0);
            assert!(times >= 10, "{}: {times} times", key.name);
        }
    }
}

/// A ball in the light of two lamps.
#[test]
fn materials_of_all_keys_are_drawn_by_all_renderers_and_exported() {
    for seed in 0..60 {
        let material = table("material", seed);
        let text = format!(
            "[camera]\neye = [1, 1.2, 7]\nlook_at = [0, 0, 0]\nangle = 20\n\
            [world]\nambient = [0.2, 0.2, 0.2]\nbackground = [0.5, 0.25, 0]\n{material}\
            [[point_light]]\ncolor = [1, 1, 1]\nposition = [3, 4, 5]\n\
            [[directional_light]]\ncolor = [0.5, 0.5, 1]\ndirection = [1, 0, -1]\n\
            [[sphere]]\nmaterial = \"NAME\"\ncenter = [0, 0, 0]\nradius = 1\n"
        );
        picture(&text, [16, 12]);
    }
}

/// Points at distances from 10^-12 to 10^5 from each vector of a table, and from the vector downwards.
fn points(item: &Item) -> Vec<Point3> {
    let vector = |key: &Key| item.find_vector(key.name, Vector3::new);
    let keys = item.kind.keys.iter().filter(|key| has_numbers(key));
    let mut vectors: Vec<_> = keys.filter_map(vector).collect();
    // A light's table may have no vector.
    vectors.push(Vector3::new(0.0, -1.0, 0.0));
    let mut points = Vec::new();
    for place in &vectors {
        for direction in &vectors {
            for exponent in -12..6 {
                let way = *direction * libm::exp10(f64::from(exponent));
                points.push(Point3::ORIGIN + *place + way);
            }
        }
    }
    points
}

/// Checks that the book has the section that a row or a step names, as `PAGE.md#heading`.
pub fn assert_in_the_book(section: &str) {
    let (page, anchor) = section.split_once('#').expect(section);
    let page = fs::read_to_string(format!("../book/src/{page}")).expect(section);
    let headings = page.lines().filter_map(|line| line.strip_prefix("## "));
    let mut anchors = headings.map(|heading| {
        let kept = heading.replace([':', ',', '?'], "");
        kept.replace(' ', "-").to_lowercase()
    });
    assert!(
        anchors.any(|known| known == anchor),
        "the book has no {section}"
    );
}

#[test]
fn the_book_has_the_section_of_each_row() {
    for row in ALL_SHAPES.rows() {
        assert_in_the_book(row.section);
    }
    for row in ALL_MATERIALS.rows() {
        assert_in_the_book(row.section);
    }
}

fn has_numbers(key: &Key) -> bool {
    matches!(key.form, Form::Numbers { .. })
}

/// A shape of each row that has numbers of its own, so that no row lacks a value in its export, and
/// none is drawn differently by a renderer.
#[test]
fn a_shape_of_each_row_is_drawn_by_all_renderers_and_exported() {
    for row in ALL_SHAPES.rows() {
        let mut tables = TABLES.iter();
        let kind = tables.find(|kind| kind.name == row.key).expect(row.key);
        if !kind.keys.iter().any(has_numbers) {
            // Meshes and groups consist of other shapes.
            continue;
        }
        let scene = |seed| {
            format!(
                "[camera]\neye = [1, 1.2, 7]\nlook_at = [0, 0, 0]\nangle = 40\n\
                [world]\nambient = [0.2, 0.2, 0.2]\n[material.red]\ndiffuse = [1, 0.5, 0.5]\n\
                [[point_light]]\ncolor = [1, 1, 1]\nposition = [3, 4, 5]\n\
                {}material = \"red\"\n",
                table(row.key, seed)
            )
        };
        let mut seen = 0;
        for text in (0..1000)
            .map(scene)
            .filter(|text| open(text).is_ok())
            .take(20)
        {
            let image = picture(&text, [16, 12]);
            seen += u32::from(image.pixels().iter().any(|color| *color != Color::BLACK));
        }
        let refusal = open(&scene(0)).err().unwrap_or_default();
        assert!(seen >= 5, "{}: {seen} shapes are seen. {refusal}", row.key);
    }
}
