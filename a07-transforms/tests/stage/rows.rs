//! The rows of shapes and lights, and the tables of scene files.

use std::collections::BTreeSet;

use a05_lighting::kinds::LIGHTS;
use a07_transforms::kinds::KINDS;
use scene_file::KINDS as TABLES;

/// The names of tables that are listed in the file, and not once. A repeat is no shape: its copies
/// are uses.
fn listed(is_light: bool) -> BTreeSet<&'static str> {
    let tables = TABLES.iter().filter(|kind| kind.form.starts_with("[["));
    let names = tables.map(|kind| kind.name);
    names
        .filter(|name| *name != "repeat")
        .filter(|name| name.ends_with("_light") == is_light)
        .collect()
}

#[test]
fn each_row_of_shapes_has_a_table_and_each_table_a_row() {
    let own = KINDS.own_tables();
    let mut tables = listed(false);
    for table in &own {
        assert!(
            tables.insert(table.name),
            "keys.md lists {}, so that its row needs no keys",
            table.name
        );
    }
    for row in KINDS.rows() {
        assert!(
            tables.remove(row.key),
            "{} has neither keys in its row nor in keys.md, or two rows",
            row.key
        );
    }
    assert!(tables.is_empty(), "{tables:?} have no row");
}

#[test]
fn each_table_of_lights_has_a_row() {
    let rows: BTreeSet<_> = LIGHTS.0.iter().map(|row| row.key).collect();
    assert_eq!(rows, listed(true));
}
