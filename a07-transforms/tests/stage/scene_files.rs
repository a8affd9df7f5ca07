//! The scenes of `tests/scenes` and of the book, and files that no scene file of text can hold.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use a07_transforms::registry::FORMAT;
use a07_transforms::stage;
use common::{Error, Renderer, Settings, Size, Transfer};
use scene_file::{Mesh, TABLES};

use crate::scene_cases::{open, open_by, picture_of, wrong_scenes};

const SHAPES: &str = include_str!("../../scenes/shapes.toml");

#[test]
fn each_scene_gets_its_error_note_or_picture() {
    let mut wrong = String::new();
    for entry in fs::read_dir("tests/scenes").unwrap() {
        let file = entry.unwrap().path();
        // The shape of that file is the next test's.
        let is_own = file.ends_with("own-shape.txt");
        if file.extension() == Some("txt".as_ref()) && !is_own {
            wrong += &wrong_scenes(&file, stage().open.unwrap());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Keys that many tables have: the examples show each in some of them.
const SHARED: [&str; 4] = ["color", "material", "transform", "shadows"];

#[test]
fn the_examples_have_every_key() {
    let mut found = BTreeSet::new();
    for file in fs::read_dir("scenes").unwrap() {
        let path = file.unwrap().path();
        if path.extension() == Some("toml".as_ref()) {
            let text = fs::read_to_string(path).unwrap();
            found.append(&mut random_scene::keys(&text).unwrap());
        }
    }
    for kind in TABLES.iter() {
        for key in kind.keys.iter().filter(|key| !key.about.is_empty()) {
            let (table, name) = (kind.name, key.name);
            // Both are other words for what a step of the examples says.
            let is_other_step = table == "step" && ["inverse", "rotate"].contains(&name);
            assert!(
                found.contains(&format!("{table} {name}"))
                    || SHARED.contains(&name)
                    || is_other_step,
                "no file of scenes has a {table} with {name}"
            );
        }
    }
}

#[test]
fn the_scenes_of_the_book_have_no_notes_and_one_picture_by_all_renderers() {
    for file in fs::read_dir("scenes").unwrap() {
        let path = file.unwrap().path();
        if path.extension() != Some("toml".as_ref()) {
            continue;
        }
        let scene = (stage().open.unwrap())(&path).unwrap();
        assert_eq!(scene.notes, [""; 0], "{path:?}");
        picture_of(stage().open.unwrap(), &scene, Size::new(16, 12).unwrap());
    }
}

/// Negates each 0 of a scene file, of whatever meaning.
#[test]
fn the_sign_of_a_zero_changes_no_picture_of_the_book() {
    for file in fs::read_dir("scenes").unwrap() {
        let path = file.unwrap().path();
        if path.extension() != Some("toml".as_ref()) {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let mesh = |name: &str| Mesh::read(&fs::read(path.with_file_name(name)).unwrap());
        let file = FORMAT.read(&text, &mesh).unwrap();
        let numbers = file.numbers(&text);
        let mut negated = FORMAT.read(&text, &mesh).unwrap();
        for number in numbers.iter().filter(|number| number.value == 0.0) {
            negated = negated.with(Transfer::default(), number, -0.0).unwrap();
        }
        for renderer in [Renderer::Lesson, Renderer::Engine] {
            let pictures = [&file, &negated].map(|file| {
                let (settings, view) = FORMAT.scene(file).unwrap();
                let settings = Settings {
                    size: Size::new(24, 18).unwrap(),
                    renderer,
                    ..settings
                };
                view.render(&settings, &()).unwrap()
            });
            assert!(pictures[0] == pictures[1], "{path:?}, {renderer:?}");
        }
    }
}

#[test]
fn each_wrong_value_is_refused_at_its_line() {
    let lines: Vec<_> = SHAPES.lines().collect();
    for (i, line) in lines.iter().enumerate() {
        let Some((key, value)) = line.split_once(" = ") else {
            continue;
        };
        // A step stays in its braces, and a list of steps goes on behind its line.
        let end = if value.ends_with("},") { " }," } else { "" };
        for wrong in "nan|inf|[[1], 2]|1e999|{}|\"no\\u0000such\"|1979-05-27".split('|') {
            let changed = format!("{key} = {wrong}{end}");
            let text = [&lines[..i], &[&*changed], &lines[i + 1..]]
                .concat()
                .join("\n");
            let error = open(&text)
                .err()
                .unwrap_or_else(|| panic!("accepted:\n{text}"));
            let is_there = error.starts_with(&format!("{}:", i + 1));
            assert!(
                is_there || value.ends_with('['),
                "{error}, not in line {}",
                i + 1
            );
        }
    }
}

#[test]
fn files_that_are_no_text_and_those_that_are_too_large_are_refused() {
    let utf_16 = SHAPES.encode_utf16().flat_map(u16::to_le_bytes);
    let utf_16: Vec<u8> = [0xFF, 0xFE].into_iter().chain(utf_16).collect();
    let latin_1 = [SHAPES.as_bytes(), b"# gr\xFCn\n"].concat();
    let line = SHAPES.lines().count() + 1;
    let latin_1_line = format!("line {line} has a letter that is not in UTF-8");
    let camera = "[camera]\neye = [0, 0, 9]\ngaze = [0, 0, -1]\nangle = 40\n";
    let mut deep = format!("{camera}[[define.a0.sphere]]\ncenter = [0, 0, 0]\nradius = 1\n");
    let mut copies = camera.to_owned();
    for i in 0..40 {
        let _ = writeln!(deep, "[[define.a{}.use]]\nname = \"a{i}\"", i + 1);
        copies += "[[repeat]]\ncount = 10000\ntranslate = [1, 0, 0]\n";
    }
    for (bytes, expected) in [
        (utf_16, "it is a text in UTF-16; save it in UTF-8"),
        (latin_1, latin_1_line.as_str()),
        (
            vec![b'#'; (16 << 20) + 1],
            "it has more than 16777216 bytes",
        ),
        (
            format!("[[{}sphere]]", "group.".repeat(5_000)).into(),
            "more than 32 tables",
        ),
        (
            format!("a = {}", "[".repeat(100_000)).into(),
            "more than 32 tables",
        ),
        (deep.into(), "more than 32 groups, uses or repeats"),
        (copies.into(), "at most 100000 copies"),
    ] {
        let error = open_by(stage().open.unwrap(), &bytes).err().unwrap();
        assert!(error.contains(expected), "{error}");
    }
    for (letter, end) in [
        ('\0', "; save the file as text, in UTF-8"),
        ('\r', "; save the file with line ends LF or CRLF"),
        ('\u{7}', ""),
        ('\u{A0}', ""),
        ('\u{AD}', ""),
        ('\u{200B}', ""),
        ('\u{FEFF}', ""),
    ] {
        let error = open(&format!("[camera]\neye{letter} = [0, 0, 9]\n"))
            .err()
            .unwrap();
        let unseen = letter.escape_unicode();
        assert_eq!(
            error,
            format!("2:4: here is the character {unseen}, which nobody sees{end}")
        );
    }
    let opened = (stage().open.unwrap())(Path::new("scenes"));
    assert!(matches!(opened, Err(Error::Open { .. })));
}

/// A wall of one square, and of 10,082 triangles, which the program calls large.
#[test]
fn a_large_mesh_has_the_picture_of_a_small_one() {
    let corners = (0..72 * 72).map(|i| format!("v {} {} -3\n", i / 72 - 9, i % 72 - 9));
    let cells = (0..72 * 71).filter(|i| i % 72 < 71);
    let cells = cells.map(|i| format!("f {} {} {} {}\n", i + 1, i + 73, i + 74, i + 2));
    let wall = "v -9 -9 -3\nv 62 -9 -3\nv 62 62 -3\nv -9 62 -3\nf 1 2 3 4";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, SHAPES).unwrap();
    let [one, many] = [wall, &corners.chain(cells).collect::<String>()].map(|mesh| {
        fs::write(folder.path().join("pyramid.obj"), mesh).unwrap();
        let scene = (stage().open.unwrap())(&path).unwrap();
        let settings = Settings {
            size: Size::new(16, 12).unwrap(),
            renderer: Renderer::Engine,
            ..scene.defaults.clone()
        };
        let image = scene.render(&settings, &()).unwrap();
        (scene.is_large, image.to_rgb8(Transfer::Linear))
    });
    assert!(!one.0 && many == (true, one.1));
}

#[test]
fn a_pixel_of_a_color_in_bytes_has_these_bytes_by_every_transfer() {
    let scene = open(
        "[picture]\nsize = [8, 8]\n[camera]\neye = [4, 4, 9]\nlook_at = [4, 4, 0]\nscale = 7\n\
         [world]\nbackground = \"#c0ffee\"\n[[box]]\nlbf = [0, 0, 0]\nrun = [8, 4, 1]\n\
         color = \"peru\"\n",
    )
    .unwrap();
    for transfer in [Transfer::Srgb, Transfer::Linear, Transfer::Gamma] {
        for renderer in Renderer::ALL {
            let settings = Settings {
                transfer,
                renderer,
                ..scene.defaults.clone()
            };
            let bytes = scene.render(&settings, &()).unwrap().to_rgb8(transfer);
            let expected = [[0xC0, 0xFF, 0xEE], [205, 133, 63]].map(|rgb| [rgb; 32]);
            assert_eq!(
                bytes,
                expected.as_flattened().as_flattened(),
                "{transfer:?}"
            );
        }
    }
}

/// A link on a desk leads to a scene file at home. A mesh beside the link comes first.
#[cfg(unix)]
#[test]
fn a_scene_behind_a_link_finds_the_mesh_beside_the_file_itself() {
    let folder = tempfile::tempdir().unwrap();
    let [home, desk] = ["home", "desk"].map(|name| folder.path().join(name));
    for place in [&home, &desk] {
        fs::create_dir(place).unwrap();
    }
    let scene = "[camera]\neye = [0, 0, 5]\ngaze = [0, 0, -1]\nangle = 40\n\n\
        [[mesh]]\nfile = \"tri.obj\"\ncolor = \"red\"\n";
    fs::write(home.join("s.toml"), scene).unwrap();
    let link = desk.join("s.toml");
    std::os::unix::fs::symlink(home.join("s.toml"), &link).unwrap();
    let open = stage().open.unwrap();
    assert!(open(&link).is_err());
    for place in [home, desk] {
        let mesh = place.join("tri.obj");
        fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let found = fs::canonicalize(&open(&link).unwrap().files[1]).unwrap();
        assert_eq!(found, fs::canonicalize(&mesh).unwrap());
    }
}
