//! Scene files: an example with every key, and what becomes of it in mistaken hands.

use std::fs;
use std::path::Path;

use a07_transforms::stage;
use common::{Error, Renderer, Scene, Settings, Size, Transfer, picture_file};

const EXAMPLE: &str = include_str!("../../scenes/shapes.toml");
const BOARD: &str = include_str!("../../scenes/board.toml");
const PYRAMID: &str = include_str!("../../scenes/pyramid.obj");

/// Opens this text as a scene file, beside the mesh; the error of a mistake as text.
fn open(folder: &Path, text: &[u8]) -> Result<Scene, String> {
    let path = folder.join("scene.toml");
    fs::write(&path, text).unwrap();
    (stage().open.unwrap())(&path).map_err(|error| {
        assert_eq!(error.exit_code(), 1);
        let error = error.to_string();
        assert_eq!(error.lines().count(), 1, "one sentence: {error}");
        assert!(error.len() < 600, "a short sentence: {error}");
        error
    })
}

/// A folder with the mesh of the example.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("pyramid.obj"), PYRAMID).unwrap();
    folder
}

#[test]
fn two_examples_have_every_key() {
    let keys = scene_file::KINDS.iter().flat_map(|kind| &kind.keys);
    for key in keys.filter(|key| !key.form.starts_with('[')) {
        let line = format!("{} = ", key.name);
        let has_it = EXAMPLE.contains(&line) || BOARD.contains(&line);
        assert!(has_it || key.name == "inverse", "{}", key.name);
    }
}

#[test]
fn all_scenes_have_the_same_picture_by_all_renderers_and_from_their_export() {
    let stage_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for file in fs::read_dir(stage_folder.join("scenes")).unwrap() {
        let path = file.unwrap().path();
        if path.extension() != Some("toml".as_ref()) {
            continue;
        }
        let scene = (stage().open.unwrap())(&path).unwrap();
        let rays = scene.rays().unwrap();
        let again = rays.export("toml", &scene.defaults).unwrap();
        let again = open(folder().path(), again.as_bytes()).unwrap();
        let render = |scene: &Scene, size, renderer| {
            let settings = Settings {
                size,
                renderer,
                ..scene.defaults.clone()
            };
            let image = scene.render(&settings, &()).unwrap();
            image.to_rgb8(Transfer::Linear)
        };
        let small = Size::new(16, 12).unwrap();
        let expected = render(&scene, small, Renderer::Engine);
        for renderer in Renderer::ALL {
            assert!(
                render(&scene, small, renderer) == expected,
                "{path:?} by {renderer:?}"
            );
            assert!(
                render(&again, small, renderer) == expected,
                "{path:?} by {renderer:?}"
            );
        }
        let name = scene.name.replace("shapes", "file");
        let book = stage_folder.join(format!("../book/src/pictures/scene-{name}.png"));
        let book = picture_file::open(&book).unwrap();
        let drawn = render(&scene, book.size(), Renderer::Engine);
        assert!(drawn == book.to_rgb8(Transfer::Linear), "the book's {name}");
    }
}

#[test]
fn each_mistake_is_refused_in_a_sentence_with_its_position() {
    let (folder, lines) = (folder(), EXAMPLE.lines().collect::<Vec<_>>());
    let wrong = "nan|inf|[[1], 2]|1e999|{}|\"no\\u0000such\"|1979-05-27";
    for (i, line) in lines
        .iter()
        .enumerate()
        .filter(|(_, line)| line.contains(" = "))
    {
        let (key, value) = line.split_once(" = ").unwrap();
        // A step stays in its braces, and a list of steps goes on behind its line.
        let end = if value.ends_with("},") { " }," } else { "" };
        for wrong in wrong.split('|') {
            let changed = format!("{key} = {wrong}{end}");
            let text = [&lines[..i], &[&*changed], &lines[i + 1..]]
                .concat()
                .join("\n");
            let error = open(folder.path(), text.as_bytes()).err();
            let error = error.unwrap_or_else(|| panic!("accepted:\n{text}"));
            let place = format!("scene.toml:{}:", i + 1);
            let is_there = error.contains(&place) || value.ends_with('[');
            assert!(is_there, "{error}, not {place}");
        }
    }
}

#[test]
fn other_files_than_scenes_and_meshes_are_refused() {
    let folder = folder();
    let utf_16: Vec<u8> = EXAMPLE.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let groups = format!("[[{}sphere]]", "group.".repeat(5_000));
    let brackets = "a = ".to_owned() + &"[".repeat(100_000);
    let large = "#".repeat((16 << 20) + 1);
    let cut_off = &EXAMPLE[..EXAMPLE.len() - 9];
    let texts = [&*groups, &brackets, &large, "", cut_off, "[camera"].map(str::as_bytes);
    for text in texts.into_iter().chain([&*utf_16, b"\xff"]) {
        assert!(open(folder.path(), text).is_err());
    }
    let mesh = folder.path().join("pyramid.obj");
    let of_mesh = |text: &str| {
        fs::write(&mesh, text).unwrap();
        open(folder.path(), EXAMPLE.as_bytes())
    };
    for text in "|f 1 2 3|v 0 0 0\nf 1 2 3|v a|ply\n|v 1e999 0 0\nf 1 1 1|f -9 1 1".split('|') {
        let error = of_mesh(text).err().unwrap();
        assert!(error.contains("scene.toml:"), "{error}");
    }
    // A wall of one square, and of 200,978 triangles.
    let corners = (0..318 * 318).map(|i| format!("v {} {} -3\n", i / 318 - 9, i % 318 - 9));
    let cells = (0..318 * 317).filter(|i| i % 318 < 317);
    let cells = cells.map(|i| format!("f {} {} {} {}\n", i + 1, i + 319, i + 320, i + 2));
    let wall = "v -9 -9 -3\nv 308 -9 -3\nv 308 308 -3\nv -9 308 -3\nf 1 2 3 4";
    let [one, many] = [wall, &corners.chain(cells).collect::<String>()].map(|text| {
        let scene = of_mesh(text).unwrap();
        let settings = Settings {
            size: Size::new(16, 12).unwrap(),
            renderer: Renderer::Engine,
            ..scene.defaults.clone()
        };
        let image = scene.render(&settings, &()).unwrap();
        (scene.is_large, image.to_rgb8(Transfer::Linear))
    });
    assert!(!one.0 && many == (true, one.1));
    fs::remove_file(&mesh).unwrap();
    assert!(open(folder.path(), EXAMPLE.as_bytes()).is_err());
    fs::create_dir(&mesh).unwrap();
    assert!(open(folder.path(), EXAMPLE.as_bytes()).is_err());
    let opened = (stage().open.unwrap())(folder.path());
    assert!(matches!(opened, Err(Error::Open { .. })));
}

/// A scene of a sphere, to which a test adds a mistake.
const SPHERE: &str = "[camera]\neye = [0, 2, 6]\ngaze = [0, -1, -6]\nangle = 40\n\n[[sphere]]\n\
    center = [0, 1, 0]\nradius = 1\ncolor = [1, 0.5, 0]\n";

/// The error of the scene of a sphere in which a text is replaced, without the path.
fn error_of(from: &str, to: &str) -> String {
    assert!(SPHERE.contains(from), "{from}");
    let error = open(folder().path(), SPHERE.replace(from, to).as_bytes());
    let error = error.err().unwrap_or_else(|| panic!("accepted: {to}"));
    let end = error.find("scene.toml:").unwrap() + "scene.toml:".len();
    error[end..].to_owned()
}

#[test]
fn a_mistake_against_toml_is_told_by_what_was_meant() {
    let comment = "a comment begins with #, such as # a green ball";
    let computed = "a value is not computed: write the result, such as 0.8";
    let unit = "a number has no unit; angles are in degrees, such as 36";
    let point = "a number has digits on both sides of its point, such as 0.8 or 8.0";
    let minus = "the minus of a number is -, and this is a longer stroke";
    let list = "a list stands in square brackets, such as [0, 3, 9]";
    let straight = "a text stands in straight quotation marks, \" or '";
    let camera = "the file has no table [camera], with eye, gaze and angle";
    for (from, to, place, text) in [
        ("= 1\n", "= 0.8 // here\n", "8:14", comment),
        ("= 1\n", "= 0.8 /* here */\n", "8:14", comment),
        ("[camera]", "// mine\n[camera]", "1:1", comment),
        ("= 1\n", "= 4/5\n", "8:10", computed),
        ("= 1\n", "= sqrt(2)\n", "8:10", computed),
        ("= 40", "= 36deg", "4:11", unit),
        ("= 40", "= 36°", "4:11", unit),
        ("[0, 1, 0]", "[0, 1cm, 0]", "7:15", unit),
        ("= 1\n", "= 0.8;\n", "8:13", "a line ends without a ;"),
        ("[0, 1, 0]", "[0, 1, 0];", "7:19", "a line ends without a ;"),
        ("= 1\n", "= .8\n", "8:10", point),
        ("= 1\n", "= 8.\n", "8:12", point),
        ("[0, 1, 0]", "[0, −2, 0]", "7:14", minus),
        ("[0, 1, 0]", "(0, 3, 9)", "7:10", list),
        ("[1, 0.5, 0]", "“red”", "9:9", straight),
        (
            "radius =",
            "radius:",
            "8:9",
            "between a key and its value stands =, such as radius = 1",
        ),
        ("= 1\n", "=\n", "8:9", "there is no value behind the ="),
        (SPHERE, "", "1:1", camera),
        (SPHERE, "# only a comment\n", "1:1", camera),
        (
            "[camera]",
            "\u{FEFF}[kamera]",
            "1:2",
            "a scene file has no \"kamera\"; the nearest is camera",
        ),
    ] {
        assert_eq!(error_of(from, to), format!("{place}: {text}"), "{to}");
    }
    let twice = "radius is in line 8 already: a key stands once in its table";
    for (from, to, place, text) in [
        ("= 1\n", "= 1\nradius = 2\n", "9:1", twice),
        (
            "[[sphere]]",
            "[camera]\n[[sphere]]",
            "6:2",
            "[camera] is in line 1 already, and a table like it stands once",
        ),
        (
            "center",
            "center = [0, 0, 0]\n[sphere]\ncenter",
            "8:2",
            "[[sphere]] is in line 6 already: write [[sphere]] here, too",
        ),
        (
            "= 1\n",
            "= 1\u{0}\n",
            "8:11",
            "here is the character \\u{0}, which nobody sees",
        ),
        (
            "= 1\n",
            "= \u{7}1\n",
            "8:10",
            "here is the character \\u{7}, which nobody sees",
        ),
        (
            "= 1\n",
            "= 1\ntransform = [{ scale = [1, 2, 1]]\n",
            "9:33",
            "the braces before this place have no } at their end, or lack a comma",
        ),
    ] {
        assert_eq!(error_of(from, to), format!("{place}: {text}"), "{to}");
    }
    let brackets = format!("= {}", "[".repeat(5000));
    assert!(error_of("= 1\n", &brackets).ends_with("too many brackets inside each other"));
    let parts = format!("{}b = 1\n", "a.".repeat(5000));
    assert!(error_of(SPHERE, &parts).ends_with("this name has too many parts"));
    let shapes = error_of("[[sphere]]", "[[group.sphere]]");
    assert!(
        shapes.starts_with("6:3: group must be a table: [[group]], behind which"),
        "{shapes}"
    );
    // The second mistake comes first in the alphabet.
    let two = error_of("center = [0, 1, 0]\nradius", "senter = [0, 1, 0]\narius");
    assert!(two.starts_with("7:1: sphere has no \"senter\""), "{two}");
}

#[test]
fn a_wrong_number_of_brackets_gets_the_header_that_is_right() {
    for (header, place, text) in [
        (
            "[sphere]",
            "6:1",
            "sphere may stand there several times, so its table has two pairs of brackets: [[sphere]]",
        ),
        (
            "[define.pawn.sphere]",
            "6:1",
            "sphere may stand there several times, so its table has two pairs of brackets: \
             [[define.pawn.sphere]]",
        ),
        (
            "[[define.sphere]]",
            "6:1",
            "define must be a table: [define.NAME], with a name, behind which its shapes stand, \
             such as [[define.pawn.sphere]]",
        ),
    ] {
        assert_eq!(error_of("[[sphere]]", header), format!("{place}: {text}"));
    }
}

#[test]
fn names_of_other_programs_get_ours() {
    for (from, to, place, text) in [
        (
            "gaze",
            "lookAt",
            "3:1",
            "camera has no \"lookAt\"; here it is look_at",
        ),
        (
            "angle",
            "fov",
            "4:1",
            "camera has no \"fov\"; here it is angle",
        ),
        (
            "eye",
            "position",
            "2:1",
            "camera has no \"position\"; here it is eye",
        ),
        (
            "[[sphere]]",
            "[[cube]]",
            "6:3",
            "a scene file has no \"cube\"; here it is box",
        ),
        (
            "[[sphere]]",
            "[[cone]]",
            "6:3",
            "a scene file has no \"cone\"; a mesh can have this form",
        ),
        (
            "radius",
            "r",
            "8:1",
            "sphere has no \"r\"; here it is radius",
        ),
        (
            "radius",
            "rotate_y",
            "8:1",
            "sphere has no \"rotate_y\"; it stands in a transform, such as transform = \
             [{ rotate_y = 30 }]",
        ),
        (
            "color =",
            "colour =",
            "9:1",
            "sphere has no \"colour\"; here it is color",
        ),
        (
            "color = [1, 0.5, 0]\n",
            "",
            "6:1",
            "sphere lacks a color or a material",
        ),
        (
            "[[sphere]]\ncenter = [0, 1, 0]\nradius = 1",
            "[[triangle]]\ncorners = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]",
            "7:11",
            "triangle: triangle is [0, 0, 0], [1, 1, 1], [2, 2, 2], but must be three corners that \
             are not on a line",
        ),
        (
            "[1, 0.5, 0]",
            "\"oragne\"",
            "9:9",
            "there is no color \"oragne\"; the nearest is orange",
        ),
        (
            "[1, 0.5, 0]",
            "\"#ff80\"",
            "9:9",
            "\"#ff80\" is no color: behind # stand six hexadecimal digits, such as #ff8000",
        ),
        (
            "gaze",
            "look_at = [0, 0, 0]\ngaze",
            "3:11",
            "a camera has a gaze or a look_at, not both",
        ),
        (
            "gaze = [0, -1, -6]",
            "look_at = [0, 2, 6]",
            "3:11",
            "camera: look_at is the eye itself, but must be another point",
        ),
    ] {
        assert_eq!(error_of(from, to), format!("{place}: {text}"), "{to}");
    }
}

#[test]
fn files_that_are_no_text_in_utf_8_are_told_where() {
    let utf_16: Vec<_> = format!("\u{FEFF}{SPHERE}")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let error = open(folder().path(), &utf_16).err().unwrap();
    assert!(
        error.ends_with("it is a text in UTF-16; save it in UTF-8"),
        "{error}"
    );
    let latin_1 = [SPHERE.as_bytes(), b"# gr\xfcn\n"].concat();
    let error = open(folder().path(), &latin_1).err().unwrap();
    assert!(
        error.contains("line 10 has a letter that is not in UTF-8"),
        "{error}"
    );
}

#[test]
fn a_backslash_in_double_quotation_marks_gets_a_hint() {
    let hint = "in double quotation marks \\ begins a special character; write / between \
        folders, or single quotation marks, such as 'models\\bunny.obj'";
    let mesh = |name: &str| {
        error_of(
            "[[sphere]]\ncenter = [0, 1, 0]\nradius = 1",
            &format!("[[mesh]]\nfile = {name}"),
        )
    };
    for (name, place) in [
        (r#""C:\Users\me\bunny.obj""#, "7:11: "),
        (r#""sub\knot.obj""#, "7:12: "),
        (
            r#""models\bunny.obj""#,
            r"7:8: cannot read models\u{8}unny.obj: ",
        ),
        (r#""C:\temp\a\new.obj""#, "7:16: "),
    ] {
        let error = mesh(name);
        assert!(error.starts_with(place) && error.ends_with(hint), "{error}");
        assert!(!error.contains(char::is_control), "{error:?}");
    }
    for name in ["'knot.obj'", r#""a\\knot.obj""#, r"'models\bunny.obj'"] {
        let error = mesh(name);
        assert!(
            !error.contains(hint) && error.contains("no such file in the folder /"),
            "{error}"
        );
    }
    let long = mesh(&format!("\"{}\"", "x".repeat(5000)));
    assert!(long.len() < 600, "{long}");
}

#[test]
fn numbers_out_of_range_are_told_in_few_digits_and_with_the_range() {
    let length = "but must be from 1e-100 to 1e100";
    for (number, shown) in [
        ("1e300", "1e300"),
        ("5e-310", "5e-310"),
        ("-1e150", "-1e150"),
    ] {
        let error = error_of("= 1\n", &format!("= {number}\n"));
        assert_eq!(error, format!("8:10: sphere: radius is {shown}, {length}"));
    }
    let up = error_of("angle", "up = [0, 1e300, 6e300]\nangle");
    assert!(up.len() < 150, "{up}");
    for (depth, text) in [
        ("0", "depth must be a whole number from 1"),
        (
            "10001",
            "picture: depth is 10001, but must be from 1 to 10000",
        ),
    ] {
        let error = error_of("[camera]", &format!("[picture]\ndepth = {depth}\n[camera]"));
        assert_eq!(error, format!("2:9: {text}"));
    }
}

#[test]
fn an_inverse_that_does_not_fit_is_told_from_a_singular_matrix() {
    let group = |step: &str| {
        let group =
            format!("[[group]]\ncolor = [1, 1, 1]\ntransform = [{{ {step} }}]\n[[group.sphere]]");
        let text = SPHERE
            .replace("[[sphere]]", &group)
            .replace("color = [1, 0.5, 0]\n", "");
        open(folder().path(), text.as_bytes())
            .err()
            .unwrap_or_default()
    };
    let stretch = "matrix = [[1, 0, 0, 0], [0, 1e6, 0, 0], [0, 0, 1, 0]]";
    let with_inverse = |y: &str| {
        group(&format!(
            "{stretch}, inverse = [[1, 0, 0, 0], [0, {y}, 0, 0], [0, 0, 1, 0]]"
        ))
    };
    // The products are 1 + 5e-7 and 1 + 1e-5.
    assert_eq!(with_inverse("1.0000005e-6"), "");
    let error = with_inverse("1.00001e-6");
    let text = "the inverse does not fit the matrix: their product differs by 1e-5 from the \
        identity, and 1e-6 is allowed";
    assert!(error.contains(text), "{error}");
    let error = group("matrix = [[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]]");
    assert!(error.contains("the matrix is singular"), "{error}");
}

#[test]
fn colours_in_bytes_and_a_file_without_shapes_get_a_note() {
    let notes = |text: &str| open(folder().path(), text.as_bytes()).unwrap().notes;
    assert_eq!(notes(SPHERE), [""; 0]);
    let lamp =
        |color: &str| format!("{SPHERE}[[point_light]]\ncolor = {color}\nposition = [0, 9, 0]\n");
    assert_eq!(notes(&lamp("[2, 2.5, 40.5]")), [""; 0]);
    for (text, end) in [
        (
            SPHERE.replace("[1, 0.5, 0]", "[255, 128, 0]"),
            "9:9: color [255, 128, 0] is brighter than 1",
        ),
        (
            lamp("[255, 255, 255]"),
            "11:9: color [255, 255, 255] is brighter than 1",
        ),
        (
            SPHERE[..SPHERE.find("[[").unwrap()].to_owned(),
            "has no shape",
        ),
        (
            SPHERE
                .replace("[[sphere]]", "[[group]]\n")
                .replace("center = [0, 1, 0]\nradius = 1\n", ""),
            "has no shape",
        ),
    ] {
        let notes = notes(&text);
        assert!(notes.len() == 1 && notes[0].contains(end), "{notes:?}");
    }
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    for file in fs::read_dir(scenes).unwrap() {
        let path = file.unwrap().path();
        if path.extension() == Some("toml".as_ref()) {
            let scene = (stage().open.unwrap())(&path).unwrap();
            assert_eq!(scene.notes, [""; 0], "{path:?}");
        }
    }
}

/// Root may read every file, so the program runs as the user nobody then.
#[cfg(unix)]
#[test]
fn files_without_permission_are_refused() {
    use std::os::unix::fs::PermissionsExt;
    use std::process::Command;

    let folder = folder();
    let [scene, mesh, program] =
        ["scene.toml", "pyramid.obj", "program"].map(|name| folder.path().join(name));
    fs::write(&scene, EXAMPLE).unwrap();
    fs::copy(env!("CARGO_BIN_EXE_a07-transforms"), &program).unwrap();
    let allow = |path: &Path, mode| fs::set_permissions(path, fs::Permissions::from_mode(mode));
    allow(folder.path(), 0o755).unwrap();
    allow(&mesh, 0o000).unwrap();
    let is_root = fs::read(&mesh).is_ok();
    let cases = [
        (0o644, 0o644, ""),
        (0o644, 0o000, "scene.toml:72:8: cannot read pyramid.obj: "),
        (0o000, 0o644, "cannot open scene.toml: "),
    ];
    for (of_scene, of_mesh, expected) in cases {
        allow(&scene, of_scene).unwrap();
        allow(&mesh, of_mesh).unwrap();
        let mut command = if is_root {
            let mut command = Command::new("setpriv");
            command
                .args(["--reuid=65534", "--clear-groups"])
                .arg(&program);
            command
        } else {
            Command::new(&program)
        };
        command.args(["export", "scene.toml", "--to", "toml"]);
        let Ok(output) = command.current_dir(folder.path()).output() else {
            return eprintln!("skipped: without setpriv root is no other user");
        };
        let errors = String::from_utf8(output.stderr).unwrap();
        let expected = match expected {
            "" => String::new(),
            place => format!("error: {place}Permission denied (os error 13)\n"),
        };
        assert_eq!(errors, expected);
        assert_eq!(output.status.code(), Some(i32::from(!expected.is_empty())));
    }
}

/// A face in the shape of the letter T, turned over. A fan from its first corner covers 3152.
#[test]
fn a_concave_face_covers_its_pixels() {
    let folder = folder();
    let letter = "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nv 3 1 0\nv 3 0 0\n\
                  f 1 2 3 4 5 6 7 8\nf 1 2\n";
    fs::write(folder.path().join("letter.obj"), letter).unwrap();
    let text = "[picture]\nsize = [160, 120]\n[camera]\neye = [1.5, 1, 6]\ngaze = [0, 0, -6]\n\
                angle = 40\n[[mesh]]\nfile = \"letter.obj\"\ncolor = [1, 1, 1]\n";
    let scene = open(folder.path(), text.as_bytes()).unwrap();
    let note = "letter.obj: 1 face of fewer than three corners is left out";
    assert_eq!(scene.notes, [note]);
    for renderer in Renderer::ALL {
        let settings = Settings {
            renderer,
            ..scene.defaults.clone()
        };
        let image = scene.render(&settings, &()).unwrap();
        let white = image.rows().flatten().filter(|color| color.r == 1.0);
        assert_eq!(white.count(), 2970, "{renderer:?}");
    }
}
