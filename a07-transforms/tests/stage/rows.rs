//! The rows of shapes and lights, and the tables of scene files.

use std::collections::BTreeSet;
use std::fs;

use a02_math::{Point3, Vector3};
use a05_lighting::kinds::LIGHTS;
use a07_transforms::kinds::KINDS;
use common::Color;
use common::sensitivity::Unit;
use scene_file::{Form, Item, KINDS as TABLES, Key, Missing, Notation, SceneFile};

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
    for row in KINDS.rows() {
        let is_listed = tables.remove(row.key);
        assert!(is_listed, "keys.md lacks {}, or it has two rows", row.key);
    }
    assert!(tables.is_empty(), "{tables:?} have no row");
}

#[test]
fn each_table_of_lights_has_a_row() {
    let rows: BTreeSet<_> = LIGHTS.0.iter().map(|row| row.key).collect();
    assert_eq!(rows, listed(true));
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
        for seed in 0..20 {
            let mut state = seed;
            let text = light(row.key, &mut state);
            let file = SceneFile::read(&text, 7, &|_| unreachable!()).unwrap();
            let light = LIGHTS.read(&file.lights[0]).unwrap();
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

/// The table of a light with random numbers.
fn light(table: &str, state: &mut u64) -> String {
    let mut lines = vec![format!("[[{table}]]\ncolor = [1, 0.5, 0.25]")];
    for key in keys(table) {
        // Cones of all widths, and not of one degree.
        let value = match key.unit {
            Some(Unit::Degree) => format!("{}", *state % 90 + 1),
            _ => numbers(&key.form, state),
        };
        lines.push(format!("{} = {value}\n", key.name));
    }
    lines.join("\n")
}

/// With shadows and without, on a ball in front of a wall, into which coordinates above 0 lead.
#[test]
fn a_light_of_each_row_is_drawn_by_all_renderers_and_exported() {
    for row in LIGHTS.0 {
        let mut seen = 0;
        for seed in 0..20 {
            let table = light(row.key, &mut { seed });
            let pictures = ["true", "false"].map(|shadows| {
                let text = format!(
                    "[camera]\neye = [-2, 1, 4]\nlook_at = [1, 1, 1]\nangle = 40\n\
                    [material.white]\ndiffuse = [1, 1, 1]\n{table}shadows = {shadows}\n\
                    [[sphere]]\nmaterial = \"white\"\ncenter = [0.9, 0.9, 0.9]\nradius = 0.2\n\
                    [[plane]]\nmaterial = \"white\"\npoint = [1.2, 1.2, 1.2]\nnormal = [1, 1, 1]\n"
                );
                picture(&text, [16, 12])
            });
            seen += u32::from(pictures[0] != pictures[1]);
        }
        assert!(seen >= 1, "{}: no shadow is seen", row.key);
    }
}

/// Points at distances from 10^-12 to 10^5 from each vector of a table.
fn points(item: &Item) -> Vec<Point3> {
    let keys = keys(item.kind.name);
    let vector = |key: &Key| item.find_vector(key.name, Vector3::new);
    let vectors: Vec<_> = keys.iter().filter_map(vector).collect();
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
    for row in KINDS.rows() {
        assert_in_the_book(row.section);
    }
}

/// The keys of the table of a row that have numbers: those of every shape have none.
fn keys(table: &str) -> Vec<Key> {
    let listed = TABLES.iter().find(|kind| kind.name == table);
    let mut keys = listed.expect(table).keys.clone();
    keys.retain(|key| matches!(key.form, Form::Numbers { .. }));
    keys
}

/// Random numbers in the form of a key, such as `3 x 3 numbers`: distinct, and from 0.1 to 1.6.
fn numbers(form: &Form, seed: &mut u64) -> String {
    let mut number = || {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        format!(
            "{:.3}",
            0.1 + (*seed >> 33) as f64 / f64::from(1 << 30) * 0.75
        )
    };
    match form.lengths() {
        Some([count]) => list(&mut number, *count),
        Some([rows, columns]) => {
            let rows: Vec<_> = (0..*rows).map(|_| list(&mut number, *columns)).collect();
            format!("[{}]", rows.join(", "))
        }
        _ => number(),
    }
}

fn list(number: &mut impl FnMut() -> String, count: usize) -> String {
    let numbers: Vec<_> = (0..count).map(|_| number()).collect();
    format!("[{}]", numbers.join(", "))
}

/// A scene with a shape of this table; every other one has the keys, too, that may be missing, or one
/// key instead of another.
fn scene(table: &str, seed: u64) -> String {
    let mut state = seed;
    let mut values = Vec::new();
    for key in keys(table) {
        let is_odd = seed % 2 == 1;
        let is_written = match key.missing {
            Missing::Optional | Missing::InsteadOf(_) => is_odd,
            Missing::NeededOr(_) => !is_odd,
            _ => true,
        };
        if is_written {
            values.push(format!("{} = {}", key.name, numbers(&key.form, &mut state)));
        }
    }
    let values = values.join("\n");
    format!(
        "[camera]\neye = [1, 1.2, 7]\nlook_at = [0.7, 0.7, 0.7]\nangle = 40\n\
        [world]\nambient = [0.2, 0.2, 0.2]\n[material.red]\ndiffuse = [1, 0.5, 0.5]\n\
        [[point_light]]\ncolor = [1, 1, 1]\nposition = [3, 4, 5]\n\
        [[{table}]]\nmaterial = \"red\"\n{values}\n"
    )
}

/// A shape of each row that has numbers of its own, so that no row lacks a value in its export, and
/// none is drawn differently by a renderer.
#[test]
fn a_shape_of_each_row_is_drawn_by_all_renderers_and_exported() {
    for row in KINDS.rows() {
        if keys(row.key).is_empty() {
            // Meshes and groups consist of other shapes.
            continue;
        }
        let mut seen = 0;
        let valid = (0..1000).map(|seed| scene(row.key, seed));
        for text in valid.filter(|text| open(text).is_ok()).take(20) {
            let image = picture(&text, [16, 12]);
            seen += u32::from(image.pixels().iter().any(|color| *color != Color::BLACK));
        }
        let refusal = open(&scene(row.key, 0)).err().unwrap_or_default();
        assert!(seen >= 5, "{}: {seen} shapes are seen. {refusal}", row.key);
    }
}
