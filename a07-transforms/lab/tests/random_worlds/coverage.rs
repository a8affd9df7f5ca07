//! Each kind of input that scene files allow occurs in random scenes.

use std::collections::HashMap;

use a07_transforms::registry::FORMAT;
use random_scene::{MESHES, Style};
use scene_file::TABLES;

use crate::scenes::text;

/// What several keys say together, by a part of the text.
const TOGETHER: [(&str, &str); 14] = [
    ("negative factor", "scale = [-"),
    ("tiny factor", "1e-9]"),
    ("flat mesh", "smooth = false"),
    ("smooth mesh", "smooth = true"),
    ("group in a group", "group.group."),
    ("three groups in each other", "group.group.group."),
    ("corridor of mirrors", "material = \"mirror\""),
    ("bright color", "3e20"),
    ("color of almost 0", "1e-310"),
    ("group in a repeat", "repeat.group."),
    ("repeat in a definition", "[define.whole.repeat."),
    ("definition in a definition", "[define.whole.use]]"),
    ("mesh in a definition", "[define.part.mesh]]"),
    ("light without shadows", "shadows = false"),
];

/// What whole tables say together.
const MORE: [&str; 3] = [
    "two shapes at one place",
    "over four lamps",
    "two equal lamps",
];

/// Whether two shapes stand at one place: all keys of a shape stand before its surface.
fn is_twice(text: &str) -> bool {
    let tables: Vec<_> = text.split("\n[[").collect();
    tables.windows(2).any(|pair| {
        let surface = pair[0].rfind("\nmaterial").or(pair[0].rfind("\ncolor"));
        surface
            .is_some_and(|at| pair[0][..at].contains('\n') && pair[1].starts_with(&pair[0][..at]))
    })
}

/// Whether it has over four lamps, and whether two of them are equal.
fn lamps(text: &str) -> [bool; 2] {
    let tables = text.split("\n[[").map(str::trim_end);
    let lamps: Vec<_> = tables.filter(|table| table.contains("_light]]")).collect();
    let are_equal = lamps.windows(2).any(|pair| pair[0] == pair[1]);
    [lamps.len() > 4, are_equal]
}

#[test]
#[cfg_attr(
    debug_assertions,
    ignore = "300 scenes, which a release build writes in seconds"
)]
fn every_kind_of_input_occurs_in_random_scenes() {
    let mut counts: HashMap<String, usize> = HashMap::new();
    for seed in 0..300 {
        let text = text(seed, Style::Plain, FORMAT).scene;
        let mut found = random_scene::keys(&text).unwrap();
        let together = TOGETHER.iter().filter(|(_, part)| text.contains(part));
        found.extend(together.map(|(name, _)| (*name).to_owned()));
        let meshes = MESHES.map(|name| format!("file = {name:?}"));
        found.extend(meshes.into_iter().filter(|mesh| text.contains(mesh)));
        let [has_many, are_equal] = lamps(&text);
        for (name, is_there) in MORE.iter().zip([is_twice(&text), has_many, are_equal]) {
            if is_there {
                found.insert((*name).to_owned());
            }
        }
        for name in found {
            *counts.entry(name).or_default() += 1;
        }
    }
    let mut expected: Vec<_> = MORE.map(str::to_owned).into();
    for kind in TABLES.iter() {
        // Tables in a table have no meaning of their own.
        let keys = kind.keys.iter().filter(|key| !key.about.is_empty());
        expected.extend(keys.map(|key| format!("{} {}", kind.name, key.name)));
    }
    expected.extend(TOGETHER.map(|(name, _)| name.to_owned()));
    expected.extend(MESHES.map(|name| format!("file = {name:?}")));
    for name in &expected {
        let count = counts.get(name).copied().unwrap_or_default();
        println!("{name}: {count}");
        assert!(count >= 20, "{count} of 300 scenes have: {name}");
    }
    println!("{} kinds of input", expected.len());
}
