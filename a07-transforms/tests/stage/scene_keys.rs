//! What the keys of scene files mean that stand for others: a point that is looked at, colours by
//! name, shapes that are defined once, and shapes that are repeated.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use a07_transforms::stage;
use common::{Color, Image, Renderer, Scene, Settings, Size, Transfer};

/// A scene of a text, beside a mesh of six triangles.
pub fn open(text: &str) -> Result<Scene, String> {
    let folder = tempfile::tempdir().unwrap();
    let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\n\
                f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\nf 5 3 4\nf 1 3 5\n";
    fs::write(folder.path().join("mesh.obj"), mesh).unwrap();
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).unwrap();
    (stage().open.unwrap())(Path::new(&path)).map_err(|error| {
        let error = error.to_string();
        let end = error.find("scene.toml:").unwrap() + "scene.toml:".len();
        error[end..].to_owned()
    })
}

/// The picture of this size, which must be the same by all renderers, and from the scene's export.
pub fn picture(text: &str, size: [u32; 2]) -> Image {
    let scene = open(text).unwrap();
    let settings = |renderer| Settings {
        size: Size::new(size[0], size[1]).unwrap(),
        renderer,
        ..scene.defaults.clone()
    };
    let lesson = scene.render(&settings(Renderer::Lesson), &()).unwrap();
    let export = scene.rays().unwrap().export("toml", &scene.defaults);
    let again = open(&export.unwrap()).unwrap();
    for renderer in Renderer::ALL {
        let same = scene.render(&settings(renderer), &()).unwrap();
        assert!(same == lesson, "{renderer:?}: {text}");
        let again = again.render(&settings(renderer), &()).unwrap();
        let bytes = |image: &Image| image.to_rgb8(Transfer::Linear);
        assert!(
            bytes(&again) == bytes(&lesson),
            "exported, {renderer:?}: {text}"
        );
    }
    lesson
}

/// A picture as rows of letters: the first of the name of a color, or a dot for black.
fn letters(image: &Image) -> Vec<String> {
    let letter = |color: &Color| match color.to_bytes() {
        [0, 0, 0] => '.',
        [255, 255, 255] => 'w',
        [255, 0, 0] => 'r',
        [0, 0, 255] => 'b',
        other => panic!("{other:?}"),
    };
    image
        .rows()
        .map(|row| row.iter().map(letter).collect())
        .collect()
}

/// A camera that sees x and y from 0 to 8 along parallel rays, a pixel for each unit.
const FROM_ABOVE: &str = "[picture]\nsize = [8, 8]\n[camera]\neye = [4, 4, 9]\n\
                          look_at = [4, 4, 0]\nscale = 7\n";

#[test]
fn a_chess_board_takes_ten_lines() {
    let board = r#"
[[repeat]]
count = 4
translate = [2, 0, 0]
repeat = [{ count = 4, translate = [0, 2, 0], box = [
    { lbf = [0, 0, 0], run = [1, 1, 1], color = "red" },
    { lbf = [1, 1, 0], run = [2, 2, 1], color = "red" },
    { lbf = [1, 0, 0], run = [2, 1, 1], color = "white" },
    { lbf = [0, 1, 0], run = [1, 2, 1], color = "white" },
] }]
"#;
    assert_eq!(board.trim().lines().count(), 9);
    let image = picture(&format!("{FROM_ABOVE}{board}"), [8, 8]);
    // The lower left one is red.
    let rows = ["wrwrwrwr", "rwrwrwrw"];
    let expected: Vec<_> = (0..8).map(|row| rows[row % 2]).collect();
    assert_eq!(letters(&image), expected);
}

#[test]
fn a_material_and_a_transform_of_a_shape_hold_within_groups() {
    let groups = r#"
[[group]]
color = "white"
transform = [{ translate = [2, 0, 0] }]
[[group.box]]
lbf = [0, 0, 0]
run = [1, 1, 1]
[[group.box]]
lbf = [0, 0, 0]
run = [1, 1, 1]
color = "red"
transform = [{ translate = [0, 2, 0] }, { scale = [3, 1, 1] }]
[[group.group]]
color = "blue"
transform = [{ translate = [0, 5, 0] }]
[[group.group.box]]
lbf = [0, 0, 0]
run = [1, 1, 1]
[[group.group.box]]
lbf = [2, 0, 0]
run = [3, 1, 1]
color = "white"
"#;
    let image = picture(&format!("{FROM_ABOVE}{groups}"), [8, 8]);
    let expected = [
        "........", "........", "..b.w...", "........", "........", "..rrr...", "........",
        "..w.....",
    ];
    assert_eq!(letters(&image), expected);
}

#[test]
fn copies_are_displaced_and_rotated_by_multiples_and_uses_choose_their_color() {
    let uses = r#"
[define.bar]
transform = [{ translate = [0, 0.5, 0.5] }]
[[define.bar.box]]
lbf = [1, -0.5, -0.5]
run = [3, 0.5, 0.5]
[[define.bar.box]]
lbf = [3, -0.5, -0.5]
run = [4, 0.5, 0.5]
color = "blue"
[[use]]
name = "bar"
color = "white"
transform = [{ translate = [0, 7, 0] }]
[[repeat]]
count = 3
translate = [0, 2, 0]
color = "red"
[[repeat.use]]
name = "bar"
"#;
    let image = picture(&format!("{FROM_ABOVE}{uses}"), [8, 8]);
    let expected = [
        ".wwb....", "........", "........", ".rrb....", "........", ".rrb....", "........",
        ".rrb....",
    ];
    assert_eq!(letters(&image), expected);

    // A quarter, half and three quarters of a turn around the middle of the picture.
    let turned = r#"
[[repeat]]
count = 4
rotate = [0, 0, 90]
color = "red"
transform = [{ translate = [4, 4, 0] }]
[[repeat.box]]
lbf = [1, 0, 0]
run = [4, 1, 1]
"#;
    let image = picture(&format!("{FROM_ABOVE}{turned}"), [8, 8]);
    let expected = [
        "...r....", "...r....", "...r....", ".....rrr", "rrr.....", "....r...", "....r...",
        "....r...",
    ];
    assert_eq!(letters(&image), expected);
}

/// Shared meshes of more triangles than are copied, under transforms that stretch, mirror and
/// rotate, in each other, with shadows, mirrors and a lamp within.
#[test]
fn instances_are_drawn_alike_by_all_renderers() {
    let text = r##"
[camera]
eye = [1, 2, 9]
look_at = [0.5, 0.5, 0]
angle = 40
[world]
ambient = "dimgray"
background = "midnightblue"
[material.mirror]
diffuse = "#806040"
specular = "silver"
exponent = 20
reflection = "gray"
[material.matt]
diffuse = "orchid"
[[point_light]]
color = "white"
position = [3, 6, 5]
[[spot_light]]
color = "#8080ff"
position = [-1, 0.2, 1]
direction = [1, -0.5, -1]
half_angle = 80
[[plane]]
point = [0, -1.5, 0]
normal = [0.1, 1, 0]
material = "mirror"
[[define.star.mesh]]
file = "mesh.obj"
[[define.star.sphere]]
center = [0.5, 0.5, 0.5]
radius = 0.3
material = "mirror"
[[define.star.mesh]]
file = "mesh.obj"
smooth = true
transform = [{ rotate = [10, 20, 30] }, { scale = [-1, 0.01, 2] }]
[[define.stars.repeat]]
count = 3
translate = [1.5, 0.2, -0.4]
rotate = [25, 0, 40]
[[define.stars.repeat.use]]
name = "star"
[[use]]
name = "stars"
material = "matt"
[[use]]
name = "stars"
material = "mirror"
transform = [{ translate = [-2.5, 1, 0] }, { scale = [0.5, -1.2, 0.7] }]
[[repeat]]
count = 5
rotate = [0, 72, 0]
material = "matt"
[[repeat.use]]
name = "star"
transform = [{ translate = [2, -1, 0] }, { scale = [0.3, 0.3, 0.3] }]
[[use]]
name = "star"
material = "matt"
transform = [{ translate = [0, 1.5, 0] }, { scale = [1e-7, 1, 1] }]
"##;
    let image = picture(text, [48, 36]);
    let colors: std::collections::BTreeSet<_> = image
        .to_rgb8(Transfer::Linear)
        .as_chunks::<3>()
        .0
        .iter()
        .copied()
        .collect();
    assert!(colors.len() > 300, "{}", colors.len());
}

#[test]
fn a_pixel_of_a_color_in_bytes_has_these_bytes_by_every_transfer() {
    let scene = open(&format!(
        "{FROM_ABOVE}[world]\nbackground = \"#c0ffee\"\n[[box]]\nlbf = [0, 0, 0]\n\
         run = [8, 4, 1]\ncolor = \"peru\"\n"
    ))
    .unwrap();
    for transfer in [Transfer::Srgb, Transfer::Linear, Transfer::Gamma] {
        for renderer in Renderer::ALL {
            let settings = Settings {
                transfer,
                renderer,
                ..scene.defaults.clone()
            };
            let bytes = scene.render(&settings, &()).unwrap().to_rgb8(transfer);
            let expected = [[0xc0, 0xff, 0xee], [205, 133, 63]].map(|rgb| [rgb; 32]);
            assert_eq!(
                bytes,
                expected.as_flattened().as_flattened(),
                "{transfer:?}"
            );
        }
    }
}

#[test]
fn the_point_looked_at_is_the_gaze_from_the_eye() {
    let camera = |gaze: &str| {
        let text = format!(
            "[camera]\neye = [1, 2, 6]\n{gaze}\nangle = 40\n[[sphere]]\ncenter = [0, 1, 0]\n\
             radius = 1\ncolor = \"red\"\n"
        );
        picture(&text, [16, 12])
    };
    let image = camera("look_at = [0, 1, 0]");
    assert!(image == camera("gaze = [-1, -1, -6]"));
    assert!(letters(&image)[6].contains('r'));
}

#[test]
fn mistakes_in_uses_are_told_where_they_are() {
    let sphere = "center = [0, 0, 0]\nradius = 1\n";
    for (text, expected) in [
        (
            format!("[[define.pawn.sphere]]\n{sphere}[[use]]\nname = \"pwan\"\ncolor = \"red\"\n"),
            "11:8: there is no definition \"pwan\"; the nearest is pawn",
        ),
        (
            "[[define.a.use]]\nname = \"b\"\n[[define.b.use]]\nname = \"a\"\n".to_owned(),
            "10:8: the definition \"a\" uses itself",
        ),
        (
            format!("[[define.pawn.sphere]]\n{sphere}[[use]]\nname = \"pawn\"\n"),
            "10:1: use lacks a color or a material",
        ),
        (
            format!(
                "[[group]]\n[[group.sphere]]\ncolor = \"red\"\n{sphere}[[group.sphere]]\n{sphere}"
            ),
            "12:1: sphere lacks a color or a material",
        ),
        (
            format!("[[repeat]]\ncolor = \"red\"\ncount = 9\n[[repeat.sphere]]\n{sphere}"),
            "7:1: repeat lacks translate, a list of 3 numbers, all of them finite, or rotate",
        ),
        (
            format!(
                "[[repeat]]\ncolor = \"red\"\ntranslate = [1, 0, 0]\ncount = 10001\n\
                 [[repeat.sphere]]\n{sphere}"
            ),
            "10:9: repeat: count is 10001, but must be from 1 to 10000",
        ),
        (
            "[[sphere]]\nradius = 0\ncenter = [0, 0, 0]\ncolor = \"red\"\nsmooth = true\n"
                .to_owned(),
            "8:10: sphere: radius is 0, but must be from 1e-100 to 1e100",
        ),
        // The plane is read before the sphere, whose mistake is one of the tables.
        (
            "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\ncolor = \"red\"\n[[spher]]\n"
                .to_owned(),
            "9:10: plane: normal n is [0, 0, 0], but must be a direction: three finite numbers, not \
             all of them 0",
        ),
    ] {
        let error = open(&format!("{FROM_ABOVE}{text}")).err();
        assert_eq!(error.as_deref(), Some(expected), "{text}");
    }
}

/// A scene of 10^10 shapes in 20 lines, and one that is deep.
#[test]
fn scenes_that_grow_too_large_are_refused() {
    let cube = "[[define.a0.box]]\nlbf = [0, 0, 0]\nrun = [1, 1, 1]\n";
    let mut large = format!("{FROM_ABOVE}{cube}");
    for i in 0..5 {
        let _ = writeln!(
            large,
            "[[define.a{}.repeat]]\ncount = 100\ntranslate = [1, 0, 0]\n\
             use = [{{ name = \"a{i}\" }}]",
            i + 1
        );
    }
    let error = open(&large).err().unwrap();
    assert!(error.contains("more than 1000000 shapes"), "{error}");

    let mut deep = format!("{FROM_ABOVE}{cube}");
    for i in 0..40 {
        let _ = writeln!(deep, "[[define.a{}.use]]\nname = \"a{i}\"", i + 1);
    }
    let error = open(&deep).err().unwrap();
    assert!(
        error.contains("more than 32 groups, uses or repeats"),
        "{error}"
    );

    let mut many = FROM_ABOVE.to_owned();
    for _ in 0..11 {
        many += "[[repeat]]\ncount = 10000\ntranslate = [1, 0, 0]\n";
    }
    let error = open(&many).err().unwrap();
    assert!(error.contains("at most 100000 copies"), "{error}");
}
