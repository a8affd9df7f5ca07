//! The JSON schema of scene files, by which editors complete and check them, is made of the list of
//! tables and keys.

use std::{env, fs};

use scene_file::{KINDS, Key, Kind};

#[test]
fn the_schema_is_current() {
    let path = "scenes/schema.json";
    if env::var_os("INSTA_UPDATE").is_some() {
        fs::write(path, schema()).unwrap();
    }
    assert_eq!(fs::read_to_string(path).unwrap(), schema());
}

/// The schema (draft 7) of all kinds.
fn schema() -> String {
    let definition = |kind: &Kind| format!("\"{}\": {{\n{}\n}}", kind.name, object(kind));
    let definitions: Vec<_> = KINDS[1..].iter().map(definition).collect();
    let draft = "http://json-schema.org/draft-07/schema#";
    format!(
        "{{\n\"$schema\": \"{draft}\",\n{},\n\"definitions\": {{\n{}\n}}\n}}\n",
        object(&KINDS[0]),
        definitions.join(",\n")
    )
}

/// A table with the keys of a kind, and no others.
fn object(kind: &Kind) -> String {
    let properties: Vec<_> = kind.keys.iter().map(property).collect();
    let head = r#""type": "object", "additionalProperties": false"#;
    format!("{head}, \"properties\": {{\n{}\n}}", properties.join(",\n"))
}

fn property(key: &Key) -> String {
    let table = key.tables().map_or_else(String::new, |kind| {
        format!(r##""$ref": "#/definitions/{}""##, kind.name)
    });
    let form = match key.form {
        "text" => r#""type": "string""#.to_owned(),
        "true or false" => r#""type": "boolean""#.to_owned(),
        form if form.ends_with(".NAME]") => {
            format!(r#""type": "object", "additionalProperties": {{ {table} }}"#)
        }
        form if form.starts_with("[[") || form.starts_with('{') => {
            format!(r#""type": "array", "items": {{ {table} }}"#)
        }
        form if form.starts_with('[') => table,
        numbers => {
            let lengths = numbers.split(' ').rev();
            let lengths = lengths.filter_map(|word| word.parse::<u8>().ok());
            let number = if numbers.contains("whole") {
                r#""type": "integer", "minimum": 1"#
            } else {
                r#""type": "number""#
            };
            lengths.fold(number.to_owned(), |row, n| {
                let length = format!(r#""minItems": {n}, "maxItems": {n}"#);
                format!(r#""type": "array", {length}, "items": {{ {row} }}"#)
            })
        }
    };
    match key.about {
        "" => format!(r#""{}": {{ {form} }}"#, key.name),
        about => format!(r#""{}": {{ {form}, "description": {about:?} }}"#, key.name),
    }
}
