//! The JSON schema of scene files, by which editors complete and check them, is made of the list of
//! tables and keys.

use std::fmt::Write;
use std::{env, fs};

use common::text;
use scene_file::{FILE, Form, Key, Kind, Missing, Notation, Range, TABLES, color_names};

#[test]
fn the_schema_is_current() {
    let path = "scenes/schema.json";
    if env::var_os("INSTA_UPDATE").is_some() {
        fs::write(path, schema()).unwrap();
    }
    let is_current = fs::read_to_string(path).unwrap() == schema();
    assert!(is_current, "INSTA_UPDATE=always renews {path}");
}

/// The schema (draft 7) of all kinds.
fn schema() -> String {
    let definition = |kind: &Kind| format!("\"{}\": {{\n{}\n}}", kind.name, object(kind));
    let mut definitions: Vec<_> = TABLES.iter().map(definition).collect();
    let names: Vec<_> = color_names().map(|name| format!("\"{name}\"")).collect();
    // The program takes names in capital letters, too, which the schema does not check.
    definitions.push(format!(
        "\"color_text\": {{\n\"anyOf\": [\n{{ \"type\": \"string\", \"pattern\": \
         \"^#([0-9a-fA-F]{{3}}){{1,2}}$\" }},\n{{ \"type\": \"string\", \"pattern\": \
         \"^[a-zA-Z]*[A-Z][a-zA-Z]*$\" }},\n{{ \"enum\": [{}] }}\n]\n}}",
        names.join(", ")
    ));
    let draft = "http://json-schema.org/draft-07/schema#";
    format!(
        "{{\n\"$schema\": \"{draft}\",\n{},\n\"required\": [\"camera\"],\n\"definitions\": \
         {{\n{}\n}}\n}}\n",
        object(&FILE),
        definitions.join(",\n")
    )
}

/// A table with the keys of a kind, and no others.
fn object(kind: &Kind) -> String {
    let is_file = kind.header.is_empty();
    let properties: Vec<_> = kind.keys.iter().map(|key| property(key, is_file)).collect();
    let mut parts = vec![
        r#""type": "object", "additionalProperties": false"#.to_owned(),
        format!("\"properties\": {{\n{}\n}}", properties.join(",\n")),
    ];
    let needed = kind
        .keys
        .iter()
        .filter(|key| key.missing == Missing::Needed);
    let needed: Vec<_> = needed.map(|key| format!("\"{}\"", key.name)).collect();
    if !needed.is_empty() {
        parts.push(format!("\"required\": [{}]", needed.join(", ")));
    }
    let mut dependencies = Vec::new();
    for key in &kind.keys {
        if let Missing::NeededWith(other) = key.missing {
            dependencies.push(format!("\"{other}\": [\"{}\"]", key.name));
        }
        if key.name == "inverse" {
            dependencies.push("\"inverse\": [\"matrix\"]".to_owned());
        }
    }
    if !dependencies.is_empty() {
        parts.push(format!(
            "\"dependencies\": {{ {} }}",
            dependencies.join(", ")
        ));
    }
    let choices = choices(kind);
    if !choices.is_empty() {
        parts.push(format!("\"allOf\": [{}]", choices.join(", ")));
    }
    parts.join(",\n")
}

/// Which of its keys a table has instead of others.
fn choices(kind: &Kind) -> Vec<String> {
    if kind.name == "step" {
        let keys = kind.keys.iter().filter(|key| key.name != "inverse");
        let one: Vec<_> = keys.map(|key| required(key.name)).collect();
        return vec![format!("{{ \"oneOf\": [{}] }}", one.join(", "))];
    }
    let mut choices = Vec::new();
    for (index, key) in kind.keys.iter().enumerate() {
        if let Missing::InsteadOf(others) = &key.missing {
            for other in others {
                let is_needed = matches!(
                    kind.key(other),
                    Some(Key {
                        missing: Missing::NeededOr(_),
                        ..
                    })
                );
                if !is_needed {
                    let (one, other) = (required(key.name), required(other));
                    choices.push(format!("{{ \"not\": {{ \"allOf\": [{one}, {other}] }} }}"));
                }
            }
        }
        let Missing::NeededOr(other) = key.missing else {
            continue;
        };
        let is_same_choice = |known: &Key| known.missing == Missing::NeededOr(key.name);
        if kind.keys[..index].iter().any(is_same_choice) {
            continue;
        }
        let is_other_needed = kind
            .key(other)
            .is_some_and(|other| matches!(other.missing, Missing::NeededOr(_)));
        let (one, other) = (required(key.name), required(other));
        choices.push(match (key.name, is_other_needed) {
            // The table around it may have the other one: see `property`.
            ("color", _) => format!("{{ \"not\": {{ \"allOf\": [{one}, {other}] }} }}"),
            (_, true) => format!("{{ \"anyOf\": [{one}, {other}] }}"),
            (_, false) => format!("{{ \"oneOf\": [{one}, {other}] }}"),
        });
    }
    choices
}

fn required(key: &str) -> String {
    format!("{{ \"required\": [\"{key}\"] }}")
}

/// A key of a table. A shape that is in no other table has a surface of its own.
fn property(key: &Key, is_of_file: bool) -> String {
    let has_shapes = |kind: &Kind| kind.key("sphere").is_some() || kind.name == "use";
    let form = match key.form {
        Form::Text | Form::Mesh => r#""type": "string""#.to_owned(),
        Form::Flag => r#""type": "boolean""#.to_owned(),
        Form::Color => format!(
            r##""anyOf": [{{ {} }}, {{ "$ref": "#/definitions/color_text" }}]"##,
            numbers(key)
        ),
        Form::Numbers { .. } => numbers(key),
        Form::Tables(name) => {
            let kind = TABLES.iter().find(|kind| kind.name == name).expect(name);
            let mut table = format!(r##""$ref": "#/definitions/{name}""##);
            if is_of_file && kind.key("material").is_some() && !has_shapes(kind) {
                let surface = ["color", "material"].map(required).join(", ");
                table = format!("\"allOf\": [{{ {table} }}, {{ \"anyOf\": [{surface}] }}]");
            }
            match kind.notation {
                Notation::Single => table,
                Notation::Named => {
                    format!(r#""type": "object", "additionalProperties": {{ {table} }}"#)
                }
                Notation::Many | Notation::Inline => {
                    format!(r#""type": "array", "items": {{ {table} }}"#)
                }
            }
        }
    };
    match key.about {
        "" => format!(r#""{}": {{ {form} }}"#, key.name),
        about => format!(r#""{}": {{ {form}, "description": {about:?} }}"#, key.name),
    }
}

/// The numbers of a key.
fn numbers(key: &Key) -> String {
    let kind = if key.form.is_whole() {
        "integer"
    } else {
        "number"
    };
    let mut number = format!(r#""type": "{kind}""#);
    let Range {
        least,
        greatest,
        is_open,
    } = key.range;
    let open = if is_open { "exclusiveM" } else { "m" };
    if least.is_finite() {
        let _ = write!(number, r#", "{open}inimum": {}"#, text::number(least));
    }
    if greatest.is_finite() {
        let _ = write!(number, r#", "{open}aximum": {}"#, text::number(greatest));
    }
    let lengths = key.form.lengths().unwrap_or_default().iter();
    lengths.rev().fold(number, |row, n| {
        let length = format!(r#""minItems": {n}, "maxItems": {n}"#);
        format!(r#""type": "array", {length}, "items": {{ {row} }}"#)
    })
}
