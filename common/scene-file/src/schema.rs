//! `schema`: the list of tables and keys as a JSON schema, by which editors complete and check
//! scene files.

use crate::{KINDS, Key, Kind, Role};

/// The JSON schema (draft 7) of scene files.
#[must_use]
pub fn schema() -> String {
    let definitions = KINDS.iter().map(|kind| {
        let keys = kind.keys.iter().map(property);
        let is_inside = |shape: &&Kind| kind.name == "group" && shape.role == Role::Shape;
        let shapes = KINDS.iter().filter(is_inside).map(table);
        format!("\"{}\": {{\n{}\n}}", kind.name, object(keys.chain(shapes)))
    });
    let definitions = definitions.collect::<Vec<_>>().join(",\n");
    let tables = KINDS.iter().filter(|kind| kind.role != Role::Step);
    let (tables, draft) = (
        object(tables.map(table)),
        "http://json-schema.org/draft-07/schema#",
    );
    format!(
        "{{\n\"$schema\": \"{draft}\",\n{tables},\n\"definitions\": {{\n{definitions}\n}}\n}}\n"
    )
}

/// The properties of a table, which has no others.
fn object(properties: impl Iterator<Item = String>) -> String {
    let properties = properties.collect::<Vec<_>>().join(",\n");
    let head = r#""type": "object", "additionalProperties": false"#;
    format!("{head}, \"properties\": {{\n{properties}\n}}")
}

fn table(kind: &Kind) -> String {
    let name = kind.name;
    let one = format!("{{ \"$ref\": \"#/definitions/{name}\" }}");
    match kind.role {
        Role::Single | Role::Step => format!(r#""{name}": {one}"#),
        Role::Named => {
            format!(r#""{name}": {{ "type": "object", "additionalProperties": {one} }}"#)
        }
        Role::Light | Role::Shape => format!(r#""{name}": {{ "type": "array", "items": {one} }}"#),
    }
}

fn property(key: &Key) -> String {
    let form = match key.form {
        "text" => r#""type": "string""#.to_owned(),
        "true or false" => r#""type": "boolean""#.to_owned(),
        "steps" => r##""type": "array", "items": { "$ref": "#/definitions/step" }"##.to_owned(),
        numbers => {
            let lengths = numbers.split(' ').rev();
            let lengths = lengths.filter_map(|word| word.parse::<u8>().ok());
            lengths.fold(r#""type": "number""#.to_owned(), |row, n| {
                let length = format!(r#""minItems": {n}, "maxItems": {n}"#);
                format!(r#""type": "array", {length}, "items": {{ {row} }}"#)
            })
        }
    };
    format!(
        r#""{}": {{ {form}, "description": {:?} }}"#,
        key.name, key.about
    )
}
